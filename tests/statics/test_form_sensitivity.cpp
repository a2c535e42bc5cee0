// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against derivatives that are not those of the form: identification from a survey then
// changes lengths the wrong way, and searches with second derivatives step astray.
#include "taut/statics/form_sensitivity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "support/finite_differences.hpp"
#include "support/random_laws.hpp"
#include "support/random_nets.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using test::all_edges;

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// dr_I/dl_0 by solving for the form again and again.
Eigen::MatrixXd solved_derivative(const CableNet& net, const Eigen::VectorXd& lengths,
                                  const Points& form, double step) {
    EquilibriumSolver solver(net);
    return test::finite_differences(
        [&](const Eigen::VectorXd& l_0) {
            return free_coordinates(net, solver.solve(l_0, form).form);
        },
        lengths, step);
}

/// Least distance of an edge from going slack or taut [m].
double distance_from_the_kink(const CableNet& net, const Eigen::VectorXd& lengths,
                              const Points& form) {
    return (edge_lengths(net, form) - lengths).cwiseAbs().minCoeff();
}

TEST(FormSensitivity, OfACrossIsThatComputedByHand) {
    // Edges 0 and 1 along x carry T = EA 0.25 at l = 1 m, l_0 = 0.8 m: k = EA / 0.8 each, and edges
    // 2 and 3 hold the node across with T / l each. dh/dl_0 = EA l / l_0^2 pulls towards node 1.
    const CableNet net(test::cross_data(0.25));
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    const double per_metre = -(1.0 / 0.64) / (2.0 / 0.8 + 2.0 * 0.25);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(3, 4);
    expected(0, 0) = per_metre;
    expected(0, 1) = -per_metre;
    expected(1, 2) = per_metre;
    expected(1, 3) = -per_metre;
    EXPECT_TRUE(sensitivity.columns(all_edges(net)).isApprox(expected, 1e-13));
}

TEST(FormSensitivity, AppliedIsTheSumOfItsColumns) {
    const CableNet net = hilo_quarter();
    test::Random random(3);
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    const Eigen::VectorXd changes = test::uniform_vector(random, net.edge_count(), 1.0);
    EXPECT_TRUE(
        sensitivity.apply(changes).isApprox(sensitivity.columns(all_edges(net)) * changes, 1e-10));
    const std::vector<int> some{17, 3, 500, 3};
    const Eigen::MatrixXd columns = sensitivity.columns(some);
    EXPECT_EQ(columns.col(1), columns.col(3));
    EXPECT_EQ(columns.col(0), sensitivity.apply(Eigen::VectorXd::Unit(net.edge_count(), 17)));
}

TEST(FormSensitivity, TransposedIsTheGradientOfAFunctionOfTheForm) {
    const CableNet net = hilo_quarter();
    test::Random random(4);
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    const Eigen::VectorXd gradient = test::uniform_vector(random, 3 * net.free_node_count(), 1.0);
    EXPECT_TRUE(sensitivity.apply_transposed(gradient).isApprox(
        sensitivity.columns(all_edges(net)).transpose() * gradient, 1e-10));
    EXPECT_THROW((void)sensitivity.apply_transposed(gradient.head(3)), std::invalid_argument);
}

TEST(FormSensitivity, TheGradientByTheNetIsThatOfSolvedForms) {
    test::Random random(6);
    CableNetData data = hypar(3, 3).data();
    data.loads = test::uniform_points(random, data.nodes.cols(), 50.0);
    const double stiffness = data.axial_stiffness(0);
    data.tension_laws = {{.name = "soft",
                          .strain = Eigen::VectorXd{{0.0, 1.0}},
                          .tension = Eigen::VectorXd{{0.0, 0.5 * stiffness}}}};
    data.tension_law.assign(data.edges.size(), -1);
    data.tension_law[2] = 0;
    const int elastic = data.supports.back();
    data.supports.pop_back();
    data.elastic_supports = {{.node = elastic,
                              .stiffness = Eigen::Vector3d(1e5, 2e5, 3e5).asDiagonal(),
                              .place = data.nodes.col(elastic)}};
    data.elastic_supports[0].stiffness(0, 2) = data.elastic_supports[0].stiffness(2, 0) = 5e4;
    const int beside = data.supports.back();
    data.supports.pop_back();
    data.elastic_supports.push_back({.node = beside,
                                     .stiffness = 2e5 * Eigen::Matrix3d::Identity(),
                                     .place = data.nodes.col(beside)});
    data.support_couplings = {
        {.first = 0,
         .second = 1,
         .stiffness = Eigen::Matrix3d{{3e4, 1e4, 0.0}, {-2e4, 4e4, 5e3}, {0.0, 7e3, -3e4}}}};
    const CableNet net(data);
    const Points weights = test::uniform_points(random, net.node_count(), 1.0);
    const auto value = [&](const CableNetData& changed) -> Eigen::VectorXd {
        const Points form = solve_equilibrium(CableNet(changed)).form;
        return Eigen::VectorXd::Constant(1, form.cwiseProduct(weights).sum());
    };
    // By the numbers that `part` gives of the data.
    const auto slope = [&](const auto& part, double step) -> Eigen::VectorXd {
        const auto changed = [&](const Eigen::VectorXd& numbers) {
            CableNetData other = data;
            part(other) = numbers;
            return value(other);
        };
        return test::finite_differences(changed, part(data), step).transpose();
    };
    const NetGradient gradient =
        FormSensitivity(net, net.unstressed_lengths(), solve_equilibrium(net).form)
            .net_gradient(weights);
    const auto close = [](const auto& got, const Eigen::VectorXd& expected) {
        return (got.reshaped() - expected).norm() < 1e-7 * expected.norm();
    };
    const auto lengths = [](CableNetData& of) { return of.unstressed_lengths.reshaped(); };
    const auto stiffnesses = [](CableNetData& of) { return of.axial_stiffness.reshaped(); };
    const auto loads = [](CableNetData& of) { return of.loads.reshaped(); };
    const auto nodes = [](CableNetData& of) { return of.nodes.reshaped(); };
    EXPECT_TRUE(close(gradient.unstressed_lengths, slope(lengths, 1e-5)));
    EXPECT_TRUE(close(gradient.axial_stiffness, slope(stiffnesses, 1e-4 * stiffness)));
    EXPECT_TRUE(close(gradient.loads, slope(loads, 0.1)));
    const auto place = [](CableNetData& of) { return of.elastic_supports[0].place.reshaped(); };
    const auto place_beside = [](CableNetData& of) {
        return of.elastic_supports[1].place.reshaped();
    };
    Points of_places = slope(nodes, 1e-5).reshaped(3, net.node_count());
    of_places.col(elastic) = slope(place, 1e-5);
    of_places.col(beside) = slope(place_beside, 1e-5);
    EXPECT_TRUE(close(gradient.nodes, of_places.reshaped()));
}

RC_GTEST_PROP(FormSensitivity, IsTheSlopeOfTheSolvedFormAndZeroForSlackEdges, ()) {
    test::Random random = test::any_random();
    // Stiff nets, whose forms change little enough for finite differences.
    const CableNet net = test::random_net(
        random, {.smallest_strain = -0.1, .largest_strain = 0.3, .largest_load = 3000.0});
    const Equilibrium e = solve_equilibrium(net);
    const Eigen::VectorXd lengths = net.unstressed_lengths();
    RC_PRE(e.status == EquilibriumStatus::converged);
    RC_PRE(distance_from_the_kink(net, lengths, e.form) > 1e-3);
    const Eigen::MatrixXd columns = FormSensitivity(net, lengths, e.form).columns(all_edges(net));
    for (const int edge : e.slack_edges) {
        RC_ASSERT(columns.col(edge).isZero(0.0));
    }
    const Eigen::MatrixXd slope = solved_derivative(net, lengths, e.form, 1e-6);
    RC_ASSERT((columns - slope).norm() < 1e-5 * (1.0 + columns.norm()));
}

/// The largest error of r''[v, w] and g . r''[v, .] against differences of first derivatives, for
/// random v, w and g, relative to their norms where those exceed 1.
double error_of_second(test::Random& random, const CableNet& net, double step) {
    EquilibriumSolver solver(net);
    const Eigen::VectorXd lengths = net.unstressed_lengths();
    const Eigen::VectorXd v = test::uniform_vector(random, net.edge_count(), 1.0);
    const Eigen::VectorXd w = test::uniform_vector(random, net.edge_count(), 1.0);
    const Eigen::VectorXd gradient = test::uniform_vector(random, 3 * net.free_node_count(), 1.0);
    const auto there = [&](double along, const Eigen::VectorXd& change) {
        const Eigen::VectorXd l_0 = lengths + along * change;
        return FormSensitivity(net, l_0, solver.solve(l_0, net.nodes()).form);
    };
    const Eigen::VectorXd move_slope = test::finite_differences(
        [&](const Eigen::VectorXd& along) { return there(along(0), w).apply(v); },
        Eigen::VectorXd::Zero(1), step);
    const Eigen::VectorXd gradient_slope = test::finite_differences(
        [&](const Eigen::VectorXd& along) { return there(along(0), v).apply_transposed(gradient); },
        Eigen::VectorXd::Zero(1), step);
    const FormSensitivity here = there(0.0, v);
    const Eigen::VectorXd second = here.apply_second(v, w);
    const Eigen::VectorXd transposed = here.apply_second_transposed(gradient, v);
    EXPECT_NEAR(transposed.dot(w), gradient.dot(second), 1e-9 * (1.0 + second.norm()));
    EXPECT_LT((second - here.apply_second(w, v)).norm(), 1e-9 * (1.0 + second.norm()));
    return std::max((second - move_slope).norm() / (1.0 + second.norm()),
                    (transposed - gradient_slope).norm() / (1.0 + transposed.norm()));
}

TEST(FormSensitivity, SecondDerivativesAreTheSlopeOfTheFirst) {
    test::Random random(5);
    EXPECT_LT(error_of_second(random, hypar(5, 5), 1e-5), 1e-7);
    EXPECT_LT(error_of_second(random, hilo_quarter(), 1e-6), 1e-6);
}

TEST(FormSensitivity, SecondDerivativesAreTheSlopeOfTheFirstWithTensionLawsAndSlackEdges) {
    int tried = 0;
    for (int seed = 0; seed < 300; ++seed) {
        test::Random random(seed);
        const CableNet net(test::with_random_laws(
            random,
            test::random_net_data(random, {.smallest_strain = -0.1, .largest_strain = 0.3})));
        const Equilibrium e = solve_equilibrium(net);
        if (e.status == EquilibriumStatus::converged &&
            test::distance_from_corners(net, e.form) > 1e-3) {
            EXPECT_LT(error_of_second(random, net, 1e-5), 1e-6) << seed;
            ++tried;
        }
    }
    EXPECT_GE(tried, 10);
}

TEST(FormSensitivity, SecondDerivativesOfSlackEdgesAreZero) {
    const CableNet net(test::cross_with_a_loose_node_data());
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    const Eigen::VectorXd slack = Eigen::VectorXd::Unit(5, 4);
    const Eigen::VectorXd all = Eigen::VectorXd::Ones(5);
    const Eigen::VectorXd gradient = Eigen::VectorXd::LinSpaced(6, 1.0, 2.0);
    EXPECT_TRUE(sensitivity.apply_second(slack, all).isZero(0.0));
    EXPECT_TRUE(sensitivity.apply_second_transposed(gradient, slack).isZero(0.0));
    EXPECT_EQ(sensitivity.apply_second_transposed(gradient, all)(4), 0.0);
}

TEST(FormSensitivity, LeavesLooseNodesWhereTheyAre) {
    const CableNet net(test::cross_with_a_loose_node_data());
    const Equilibrium e = solve_equilibrium(net);
    ASSERT_EQ(e.status, EquilibriumStatus::slack_mechanism);
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), e.form);
    const Eigen::VectorXd changes{{1e-3, 2e-3, -1e-3, 1e-3, 5e-3}};
    const Eigen::VectorXd moves = sensitivity.apply(changes);
    EXPECT_TRUE(moves.tail<3>().isZero(0.0));
    // The rest moves as without the loose node.
    const CableNet cross(test::cross_data(0.02));
    const Eigen::VectorXd alone =
        FormSensitivity(cross, cross.unstressed_lengths(), cross.nodes()).apply(changes.head(4));
    EXPECT_LT((moves.head<3>() - alone).norm(), 1e-9 * alone.norm());
}

TEST(FormSensitivity, StaysFiniteWhereAnEdgeIsTautByRoundingAlone) {
    // Each node was pulled in by a single edge until that was slack.
    CableNetData data = test::chain_data(2, 1.0, 0.0);
    data.supports = {0};
    const CableNet net(std::move(data));
    const Eigen::Vector2d lengths(0.5 - 1e-16, 0.5 - 1e-16);
    Points form = net.nodes();
    form.col(1) << 0.3, 0.4, 0.0;
    form.col(2) << 0.6, 0.8, 0.0;
    const FormSensitivity sensitivity(net, lengths, form);
    const Eigen::VectorXd moves = sensitivity.apply(Eigen::Vector2d(1e-3, -2e-3));
    EXPECT_LT(moves.cwiseAbs().maxCoeff(), 3e-3);
}

TEST(MostSensitiveEdges, AreThoseWithTheLargestColumnsInFallingOrder) {
    const CableNet net = hilo_quarter();
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    const std::vector<int>& edges = net.interior_edges();
    const Eigen::VectorXd moves = sensitivity.columns(edges).colwise().norm();
    const auto found = most_sensitive_edges(sensitivity, edges, 5);
    ASSERT_EQ(found.size(), 5U);
    EXPECT_EQ(found.front().move, moves.maxCoeff());
    for (size_t k = 0; k < found.size(); ++k) {
        const auto place = std::ranges::find(edges, found[k].edge) - edges.begin();
        EXPECT_EQ(found[k].move, moves(place));
        EXPECT_EQ((moves.array() > found[k].move).count(), static_cast<Eigen::Index>(k));
    }
    EXPECT_EQ(most_sensitive_edges(sensitivity, edges, 1000).size(), edges.size());
    EXPECT_TRUE(most_sensitive_edges(sensitivity, edges, 0).empty());
}

TEST(FormSensitivity, RefusesWrongChangesAndEdges) {
    const CableNet net(test::cross_data(0.02));
    const auto refuses = [](const auto& call, const char* words) {
        EXPECT_THAT(call, ThrowsMessage<std::invalid_argument>(HasSubstr(words)));
    };
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    refuses([&] { (void)sensitivity.apply(Eigen::VectorXd::Zero(5)); },
            "length_changes has 5 entries, expected 4");
    const Eigen::VectorXd changes = Eigen::VectorXd::Zero(4);
    refuses([&] { (void)sensitivity.apply_second(changes, Eigen::VectorXd::Zero(3)); },
            "more_changes has 3 entries, expected 4");
    refuses([&] { (void)sensitivity.apply_second_transposed(changes, changes); },
            "gradient has 4 entries, expected 3");
    refuses([&] { (void)sensitivity.net_gradient(Points::Zero(3, 4)); },
            "gradient has 4 entries, expected 5");
    refuses([&] { (void)sensitivity.columns(std::vector{0, 4}); }, "names edge 4");
    refuses([&] { (void)sensitivity.columns(std::vector{-1}); }, "names edge -1");
}

}  // namespace
}  // namespace taut
