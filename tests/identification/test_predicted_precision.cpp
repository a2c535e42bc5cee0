// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a plan of targets that promises more, or less, than the survey then gives.

#include "taut/identification/predicted_precision.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <atomic>
#include <cmath>
#include <set>

#include "identification/maximum_a_posteriori.hpp"
#include "identification/simulated_survey.hpp"
#include "support/finite_differences.hpp"
#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;

constexpr double noise_std = 0.5e-3;
constexpr LengthPrior uniform_5mm{LengthPrior::Kind::uniform, 0.005};
constexpr LengthPrior normal_3mm{LengthPrior::Kind::normal, 0.003};

/// Free nodes within so many edges of one.
std::set<int> region(const CableNet& net, int centre, int edges) {
    std::set<int> nodes{centre};
    for (int k = 0; k < edges; ++k) {
        const std::set<int> inner = nodes;
        for (const auto& [s, t] : net.edges()) {
            for (const auto& [from, to] : {std::pair(s, t), std::pair(t, s)}) {
                if (inner.contains(from) && net.free_index(to) >= 0) {
                    nodes.insert(to);
                }
            }
        }
    }
    return nodes;
}

/// (J' S J + I / prior.std_dev()^2)^-1, with J from differences of equilibria.
Eigen::VectorXd reference_std(const CableNet& net, const Survey& survey, const LengthPrior& prior) {
    const Eigen::Index count = net.interior_edge_count();
    EquilibriumSolver solver(net);
    const auto seen = [&](const Eigen::VectorXd& deviations) -> Eigen::VectorXd {
        const Points form = solver.solve(with_length_deviations(net, deviations), net.nodes()).form;
        return form(Eigen::all, survey.surveyed).reshaped();
    };
    const Eigen::MatrixXd jacobian =
        test::finite_differences(seen, Eigen::VectorXd::Zero(count), 1e-5);
    const Eigen::MatrixXd precision =
        jacobian.transpose() * jacobian / (noise_std * noise_std) +
        Eigen::MatrixXd::Identity(count, count) / (prior.std_dev() * prior.std_dev());
    return precision.inverse().diagonal().cwiseSqrt();
}

TEST(PredictedPrecision, IsThePosteriorByDifferencesOfEquilibriaAndItsRule) {
    const CableNet net = hypar(6, 8);
    const Points form = solve_equilibrium(net).form;
    for (const int radius : {-1, 0, 2, 4}) {
        const std::set<int> hidden =
            radius < 0 ? std::set<int>() : region(net, net.free_nodes()[20], radius);
        const Survey survey = test::planned_survey(net, noise_std, hidden);
        const PredictedPrecision precision =
            predicted_precision(net, form, survey, normal_3mm, {.assume_site = false});
        const Eigen::VectorXd expected = reference_std(net, survey, normal_3mm);
        const Eigen::VectorXd stds = test::of_edges(precision.edges, &EdgePrecision::std_dev);
        EXPECT_LT((stds - expected).cwiseQuotient(expected).cwiseAbs().maxCoeff(), 1e-4);
        for (size_t i = 0; i < precision.edges.size(); ++i) {
            EXPECT_EQ(precision.edges[i].status,
                      status_of(normal_3mm.std_dev(), expected(static_cast<Eigen::Index>(i))))
                << i;
        }
        EXPECT_NEAR(precision.rms_std(), std::sqrt(expected.cwiseAbs2().mean()),
                    1e-4 * precision.rms_std());
    }
}

TEST(PredictedPrecision, IsWhatIdentificationsThenGive) {
    const CableNet net = hilo_quarter();
    const Points form = solve_equilibrium(net).form;
    for (const LengthPrior& prior : {uniform_5mm, normal_3mm}) {
        test::SimulatedSurvey s = test::simulate(net, prior, noise_std, 3);
        for (const int node : net.free_nodes()) {
            if (node % 10 < 7) {
                test::hide(net, s.survey, node);
            }
        }
        const PredictedPrecision precision =
            predicted_precision(net, form, s.survey, prior, {.assume_site = false});
        const Identification then = identify_by_maximum_a_posteriori(net, s.survey, prior);
        const Eigen::VectorXd stds = test::of_edges(then.edges, &IdentifiedEdge::std_dev);
        EXPECT_NEAR(precision.rms_std(), std::sqrt(stds.cwiseAbs2().mean()),
                    0.03 * precision.rms_std());
        const auto open = static_cast<double>(
            std::ranges::count(then.edges, EdgeStatus::not_determined, &IdentifiedEdge::status));
        EXPECT_GT(open, 10);
        EXPECT_NEAR(precision.count(EdgeStatus::not_determined), open, 0.3 * open);
    }
}

TEST(PredictedPrecision, EndsWhenItIsToStop) {
    const CableNet net = hypar(4, 4);
    std::atomic<int> asked = 0;
    EXPECT_THROW((void)predicted_precision(net, solve_equilibrium(net).form,
                                           test::planned_survey(net, noise_std), normal_3mm, {},
                                           {.stop_requested = [&] { return ++asked > 9; }}),
                 Interrupted);
    EXPECT_GT(asked, 9);
}

TEST(PredictedPrecision, AssumesByDefaultWhatIdentifyAssumes) {
    const CableNet net = hypar(4, 4);
    const Points form = solve_equilibrium(net).form;
    const test::SimulatedSurvey s = test::simulate(net, normal_3mm, noise_std, 3);
    const PredictedPrecision precision = predicted_precision(net, form, s.survey, normal_3mm);
    const Identification then = identify(net, s.survey, {.prior = normal_3mm, .prior_exact = true});
    EXPECT_NEAR(precision.mean_tension_std, then.drawn.mean_tension.std_dev,
                0.25 * precision.mean_tension_std);
    const PredictedPrecision exact =
        predicted_precision(net, form, s.survey, normal_3mm, {.assume_site = false});
    EXPECT_GT(precision.mean_tension_std, 1.5 * exact.mean_tension_std);
    const Survey whole = test::planned_survey(net, 0.0);
    EXPECT_EQ(
        predicted_precision(net, form, whole, normal_3mm).mean_tension_std,
        predicted_precision(net, form, whole, normal_3mm, {.assume_site = false}).mean_tension_std);
}

TEST(PredictedPrecision, KnowsASlackEdge) {
    CableNetData data = hypar(4, 4).data();
    const int edge = CableNet(data).interior_edges()[3];
    data.unstressed_lengths(edge) *= 1.5;
    const CableNet net(data);
    const PredictedPrecision precision = predicted_precision(
        net, solve_equilibrium(net).form, test::planned_survey(net, noise_std), uniform_5mm);
    for (const EdgePrecision& e : precision.edges) {
        EXPECT_EQ(e.status == EdgeStatus::slack, e.edge == edge);
        if (e.edge == edge) {
            EXPECT_NEAR(e.std_dev, uniform_5mm.std_dev(), 1e-9);
        }
    }
}

TEST(PredictedPrecision, RefusesASurveyOfNothingAndANetWithNothingToFind) {
    const CableNet net = hypar(3, 3);
    Survey survey = test::planned_survey(net, noise_std);
    survey.surveyed.clear();
    EXPECT_THROW(static_cast<void>(predicted_precision(net, net.nodes(), survey, uniform_5mm)),
                 std::invalid_argument);
    const CableNet known = hypar(1, 1);
    EXPECT_THROW(static_cast<void>(predicted_precision(
                     known, known.nodes(), test::planned_survey(known, noise_std), uniform_5mm)),
                 std::invalid_argument);
}

}  // namespace
