// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against first derivatives that do not tell where the form goes: identification from a
// survey then turns lengths the wrong way.
#include "support/all_edges.hpp"
#include "taut/statics/form_sensitivity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <numeric>

#include "support/finite_differences.hpp"
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

/// How far the strain of any edge is from going slack, or from coming under tension.
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

TEST(FormSensitivity, OfAHyparIsTheSlopeOfTheSolvedForm) {
    const CableNet net = hypar(6, 5);
    test::Random random(1);
    const Eigen::VectorXd lengths =
        with_length_deviations(net, test::uniform_vector(random, net.interior_edge_count(), 1e-3));
    const Equilibrium e = EquilibriumSolver(net).solve(lengths, net.nodes());
    const Eigen::MatrixXd columns = FormSensitivity(net, lengths, e.form).columns(all_edges(net));
    const Eigen::MatrixXd slope = solved_derivative(net, lengths, e.form, 1e-5);
    EXPECT_LT((columns - slope).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(FormSensitivity, AppliedToChangesIsTheDifferenceOfSolvedForms) {
    const CableNet net = hilo_quarter();
    test::Random random(2);
    const Eigen::VectorXd lengths =
        with_length_deviations(net, test::uniform_vector(random, net.interior_edge_count(), 5e-3));
    EquilibriumSolver solver(net);
    const Points form = solver.solve(lengths, net.nodes()).form;
    const FormSensitivity sensitivity(net, lengths, form);
    const Eigen::VectorXd changes = test::uniform_vector(random, net.edge_count(), 1e-5);
    const Eigen::VectorXd difference =
        0.5 * (free_coordinates(net, solver.solve(lengths + changes, form).form) -
               free_coordinates(net, solver.solve(lengths - changes, form).form));
    EXPECT_LT((sensitivity.apply(changes) - difference).norm(), 1e-5 * difference.norm());
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

RC_GTEST_PROP(FormSensitivity, IsTheSlopeOfTheSolvedFormAndZeroForSlackEdges, ()) {
    test::Random random = test::any_random();
    // Nets that hang stiffly: their forms change little enough for finite differences.
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

TEST(FormSensitivity, LeavesLooseNodesWhereTheyAre) {
    // Node 5 hangs at the cross by a slack edge.
    CableNetData data = test::cross_data(0.02);
    data.nodes.conservativeResize(3, 6);
    data.nodes.col(5) << 0.1, 0.2, 0.3;
    data.edges.push_back({0, 5});
    data.axial_stiffness.setConstant(5, 100e3);
    data.unstressed_lengths.conservativeResize(5);
    data.unstressed_lengths(4) = 0.5;
    const CableNet net(std::move(data));
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
    // A node that a single edge has pulled in until it was slack.
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

TEST(FormSensitivity, RefusesWrongArguments) {
    const CableNet net(test::cross_data(0.02));
    const Eigen::VectorXd lengths = net.unstressed_lengths();
    const auto refuses = [](const auto& call, const char* words) {
        EXPECT_THAT(call, ThrowsMessage<std::invalid_argument>(HasSubstr(words)));
    };
    const auto make = [&](const Eigen::VectorXd& l_0, const Points& form) {
        return [&net, l_0, form] { (void)FormSensitivity(net, l_0, form); };
    };
    refuses(make(lengths.head(3), net.nodes()), "unstressed_lengths has 3 entries, expected 4");
    refuses(make(lengths, net.nodes().leftCols(4)), "form has 4 points, expected 5");
    Eigen::VectorXd bad_lengths = lengths;
    bad_lengths(3) = -1.0;
    refuses(make(bad_lengths, net.nodes()), "unstressed length 3 is -1");
    Points bad_form = net.nodes();
    bad_form(0, 0) = std::numeric_limits<double>::quiet_NaN();
    refuses(make(lengths, bad_form), "at node 0, expected finite");

    const FormSensitivity sensitivity(net, lengths, net.nodes());
    refuses([&] { (void)sensitivity.apply(Eigen::VectorXd::Zero(5)); },
            "length_changes has 5 entries, expected 4");
    refuses([&] { (void)sensitivity.columns(std::vector{0, 4}); }, "names edge 4");
    refuses([&] { (void)sensitivity.columns(std::vector{-1}); }, "names edge -1");
}

}  // namespace
}  // namespace taut
