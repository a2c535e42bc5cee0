// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against plans on other nets than those of the posterior samples: the uncertainty of
// stiffness, temperature, supports, turnbuckles and loads must be in the samples that limits are
// kept in.
#include "taut/adjustment/built_net.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "adjustment/force_ranges.hpp"
#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/adjustment/plan.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"

namespace taut {
namespace {

using test::uncertain;

constexpr LengthPrior prior{LengthPrior::Kind::uniform, 0.002};
constexpr double noise = 0.5e-3;

/// With loads, and cables that expand.
CableNet site_net() {
    const CableNet net = hypar(5, 5);
    CableNetData data = net.data();
    data.expansion = Eigen::VectorXd::Constant(net.edge_count(), 12e-6);
    data.loads = Points::Zero(3, net.node_count());
    for (const int node : net.free_nodes()) {
        data.loads(2, node) = -20.0;
    }
    return CableNet(std::move(data));
}

Identification identified(const CableNet& net, const Survey& survey,
                          std::vector<UncertainParameter> given) {
    return test::identify_lengths(net, survey,
                                  {.method = IdentificationMethod::map,
                                   .prior = prior,
                                   .uncertain = std::move(given),
                                   .draws = 30});
}

/// Each sample of the built net has the form and the tensions that the identification drew.
void expect_same_samples(const CableNet& net, const Identification& found) {
    ASSERT_TRUE(found.draws.has_value());
    ASSERT_EQ(found.draws->reason, "");
    const BuiltNet built = built_net_of(net, found);
    ASSERT_EQ(built.no_draws_because, "");
    for (int d = 0; d < found.draws->count(); ++d) {
        const ModelPerturbation perturbation = built.perturbations.empty()
                                                   ? unperturbed(built.net)
                                                   : built.perturbations.at(static_cast<size_t>(d));
        const CableNet sample = net_under(built.net, perturbation, built.length_draws.col(d));
        const Equilibrium equilibrium = solve_equilibrium(sample);
        const Eigen::VectorXd pull =
            tensions_of(sample, sample.unstressed_lengths(), equilibrium.form);
        const Eigen::VectorXd drawn = found.draws->tensions.col(d);
        EXPECT_LT((pull - drawn).cwiseAbs().maxCoeff(), 1e-5 * drawn.mean()) << d;
        EXPECT_LT((free_coordinates(net, equilibrium.form) - found.draws->forms.col(d))
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-7)
            << d;
    }
}

TEST(BuiltNet, HasTheSamplesOfAllThatIsUncertain) {
    const CableNet net = site_net();
    const test::SimulatedSurvey s = test::simulate(net, prior, noise, 3);
    for (const char* one : {"stiffness:5%", "stiffness-each:3%", "temperature:10K", "supports:1mm",
                            "adjustable:0.5mm", "loads:10%", "loads:2N"}) {
        SCOPED_TRACE(one);
        expect_same_samples(net, identified(net, s.survey, uncertain({one})));
    }
    expect_same_samples(
        net, identified(net, s.survey, with_site_assumptions(net, uncertain({"loads:10%"}))));
}

TEST(BuiltNet, HasTheSamplesOfAnUncertainWeightAndSag) {
    CableNetData data = site_net().data();
    data.nodes *= 100.0;
    data.unstressed_lengths *= 100.0;
    data.mass = Eigen::VectorXd::Constant(std::ssize(data.edges), 0.5);
    data.sag_weight = sag_weights_by_mass(data);
    data.nodes = solve_equilibrium(CableNet(data)).form;
    const CableNet net(data);
    data.mass *= 1.05;
    data.sag_weight *= 1.05;
    const test::SimulatedSurvey s = test::simulate(CableNet(data), prior, noise, 3);
    expect_same_samples(net, identified(net, s.survey, uncertain({"mass:3%", "loads:10%"})));
}

TEST(BuiltNet, HasTheSamplesOfElasticSupports) {
    const CableNet net = test::on_springs(site_net());
    const test::SimulatedSurvey s = test::simulate(net, prior, noise, 3);
    for (const auto& given : {uncertain({"supports:1mm"}), uncertain({"support-stiffness:10%"}),
                              uncertain({"supports:1mm", "support-stiffness:10%"})}) {
        SCOPED_TRACE(to_string(given));
        expect_same_samples(net, identified(net, s.survey, given));
    }
}

TEST(BuiltNet, HasTheTensionsOfSamplesInAnotherFrame) {
    const CableNet net = test::on_springs(site_net());
    test::SimulatedSurvey s = test::simulate(net, prior, noise, 3);
    s.survey.frame_is_unknown = true;
    for (auto place : s.survey.form.colwise()) {
        place += Eigen::Vector3d(5e-3, -4e-3, 3e-3);
    }
    const Identification found =
        identified(net, s.survey, uncertain({"supports:1mm", "support-stiffness:10%"}));
    const BuiltNet built = built_net_of(net, found);
    ASSERT_EQ(built.no_draws_because, "");
    for (int d = 0; d < found.draws->count(); ++d) {
        const CableNet sample = net_under(built.net, built.perturbations[static_cast<size_t>(d)],
                                          built.length_draws.col(d));
        const Eigen::VectorXd pull =
            tensions_of(sample, sample.unstressed_lengths(), solve_equilibrium(sample).form);
        const Eigen::VectorXd drawn = found.draws->tensions.col(d);
        // Small rotations turn neither loads nor springs.
        EXPECT_LT((pull - drawn).cwiseAbs().maxCoeff(), 2e-3 * drawn.mean()) << d;
    }
}

int edge_at(const CableNet& net, int node) {
    const auto is_at = [node](const Edge& edge) { return edge[0] == node || edge[1] == node; };
    return static_cast<int>(std::ranges::find_if(net.edges(), is_at) - net.edges().begin());
}

TEST(BuiltNet, HasTheSamplesOfASupportOrTurnbuckleThatTheSurveyContradicts) {
    const CableNet net = hilo_quarter();
    CableNetData moved = net.data();
    moved.nodes(2, net.supports()[10]) += 0.012;
    CableNetData turned = net.data();
    turned.unstressed_lengths(net.adjustable_edges()[40]) += 0.010;
    for (CableNetData* data : {&moved, &turned}) {
        const CableNet truth(*data);
        const test::SimulatedSurvey s = test::simulate(truth, prior, noise, 4);
        for (const bool is_uncertain : {false, true}) {
            const Identification found = identified(
                net, s.survey,
                is_uncertain ? with_site_assumptions(net, {}) : std::vector<UncertainParameter>());
            ASSERT_EQ(found.boundary_outliers.size(), 1U);
            // At a support with one edge either is named, and the other as what it is confounded
            // with.
            const BoundaryOutlier& outlier = found.boundary_outliers.front();
            const int edge =
                data == &moved ? edge_at(net, net.supports()[10]) : net.adjustable_edges()[40];
            const bool is_edge = outlier.kind == BoundaryOutlier::Kind::adjustable_edge;
            EXPECT_EQ(is_edge ? outlier.index : edge_at(net, outlier.index), edge);
            expect_same_samples(net, found);
            // An outlier of an edge is in the net once.
            const CableNet built = built_net_of(net, found).net;
            if (is_edge && data == &turned) {
                EXPECT_NEAR(built.unstressed_lengths()(edge), truth.unstressed_lengths()(edge),
                            0.003);
            }
        }
    }
}

TEST(BuiltNet, OfOlderSamplesWithoutWhatWasUncertainHasNone) {
    const CableNet net = site_net();
    const test::SimulatedSurvey s = test::simulate(net, prior, noise, 3);
    Identification found = identified(net, s.survey, uncertain({"stiffness:5%"}));
    found.draws->perturbations = {};
    const BuiltNet built = built_net_of(net, found);
    EXPECT_EQ(built.length_draws.cols(), 0);
    EXPECT_NE(built.no_draws_because, "");
}

TEST(ForceRanges, AnEdgeWithoutTensionIsSlack) {
    const CableNet net = hypar(5, 5);
    const TensionLimits any = stroke_limits(net, net.adjustable_edges(), 0.01).tension;
    const ForceRange range = range_of(net, any, {});
    Eigen::VectorXd forces = tensions_of(net, net.unstressed_lengths(), net.nodes());
    EXPECT_EQ(range.violation(forces), 0.0);
    forces(3) = 0.0;
    EXPECT_GT(range.violation(forces), negligible_violation * forces.mean());
    EXPECT_EQ(given_limit(net, range.lower(3)), 0.0);
    EXPECT_EQ(given_limit(net, 1500.0), 1500.0);
}

}  // namespace
}  // namespace taut
