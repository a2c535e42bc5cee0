// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against wrong derivatives by strokes: a plan would then turn the wrong way, or count a
// broken limit as kept.
#include "adjustment/stroke_response.hpp"

#include <gtest/gtest.h>

#include "support/finite_differences.hpp"
#include "support/random_nets.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

/// Rates of forms and forces against differences of exact equilibria.
void expect_rates(const CableNet& net, const Eigen::VectorXd& lengths, double tolerance) {
    StrokeResponse response(net, net.adjustable_edges(),
                            {net.supports()[1], net.all_supports().back()});
    const Eigen::VectorXd none =
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(net.adjustable_edges().size()));
    const StrokedNet at = response.at(lengths, none, net.nodes());
    ASSERT_TRUE(at.equilibrium.balanced());
    const StrokeRates rates = response.rates(at);
    constexpr double step = 1e-6;
    const Eigen::MatrixXd forms = test::finite_differences(
        [&](const Eigen::VectorXd& strokes) {
            return free_coordinates(
                net, response.at(lengths, strokes, at.equilibrium.form).equilibrium.form);
        },
        none, step);
    EXPECT_LT((rates.form - forms).cwiseAbs().maxCoeff(), tolerance);
    const Eigen::MatrixXd forces = test::finite_differences(
        [&](const Eigen::VectorXd& strokes) {
            return response.at(lengths, strokes, at.equilibrium.form).forces;
        },
        none, step);
    EXPECT_LT((rates.forces - forces).cwiseAbs().maxCoeff(),
              tolerance * forces.cwiseAbs().maxCoeff());
}

TEST(StrokeResponse, HasTheRatesOfSolvedForms) {
    const CableNet net = hypar(4, 5);
    test::Random random(3);
    expect_rates(
        net,
        with_length_deviations(net, test::uniform_vector(random, net.interior_edge_count(), 1e-3)),
        2e-5);
}

TEST(StrokeResponse, HasTheRatesOfReactionsAtElasticSupports) {
    CableNetData data = hypar(4, 5).data();
    const int node = data.supports.back();
    data.supports.pop_back();
    data.elastic_supports = {{.node = node,
                              .stiffness = Eigen::Vector3d(5e5, 1e6, 2e6).asDiagonal(),
                              .place = data.nodes.col(node)}};
    const CableNet net(data);
    expect_rates(net, net.unstressed_lengths(), 2e-5);
}

TEST(StrokeResponse, HasTheRatesOfCablesThatSlide) {
    CableNetData data = sliding_ridge().data();
    data.runs[0].friction = 0.0;  // with friction rates are those of one direction
    const CableNet net(data);
    expect_rates(net, net.unstressed_lengths(), 2e-5);
}

TEST(StrokeResponse, HasTheRatesOfSlackEdgesToo) {
    const CableNet net = hypar(4, 5);
    Eigen::VectorXd lengths = net.unstressed_lengths();
    lengths(net.interior_edges()[7]) += 30e-3;
    StrokeResponse response(net, net.adjustable_edges(), {});
    const StrokedNet at = response.at(
        lengths, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(net.adjustable_edges().size())),
        net.nodes());
    ASSERT_FALSE(at.equilibrium.slack_edges.empty());
    EXPECT_LT(at.forces(net.interior_edges()[7]), 0.0);  // and by how much it is too long
    expect_rates(net, lengths, 2e-5);
}

TEST(StrokeResponse, HasTheRatesOfTwoSlopeCables) {
    const CableNet net = steel_roof();
    expect_rates(net, net.unstressed_lengths(), 2e-4);
}

}  // namespace
}  // namespace taut
