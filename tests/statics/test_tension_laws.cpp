// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the statics of edges, linear and with piecewise linear tension laws: derivatives against
// finite differences, the equilibrium against the cone program and against forces computed by hand.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "support/balance.hpp"
#include "support/finite_differences.hpp"
#include "support/random_laws.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using test::distance_from_corners;
using test::largest_distance;

/// The built-in lattice with edges that start at half their stiffness, have a constructional
/// stretch and are stiffer beyond it; lengths are cut for the same tensions.
CableNet two_slope_hypar(double length_error) {
    CableNetData data = hypar(6, 7).data();
    const double stiffness = data.axial_stiffness(0);
    data.tension_laws = {{.name = "strand",
                          .strain = Eigen::VectorXd{{0.0, 0.015, 0.017, 0.05}},
                          .tension = stiffness * Eigen::VectorXd{{0.0, 0.0075, 0.0075, 0.0405}}}};
    data.tension_law.assign(data.edges.size(), 0);
    const CableNet linear = hypar(6, 7);
    const Eigen::VectorXd tension =
        tensions_of(linear, linear.unstressed_lengths(), linear.nodes());
    const Eigen::VectorXd length = edge_lengths(linear, linear.nodes());
    test::Random random(3);
    for (Eigen::Index e = 0; e < tension.size(); ++e) {
        data.unstressed_lengths(e) =
            length(e) / (1.0 + data.tension_laws[0].strain_at(tension(e))) +
            test::uniform(random, -length_error, length_error);
    }
    return CableNet(std::move(data));
}

TEST(TensionLaws, OfACrossGiveTheirTensionsAndEnergy) {
    CableNetData data = test::cross_data(0.01);
    data.tension_laws = {{.name = "law",
                          .strain = Eigen::VectorXd{{0.0, 0.005, 0.02}},
                          .tension = Eigen::VectorXd{{0.0, 100.0, 1000.0}}}};
    data.tension_law = {0, 0, -1, -1};
    const CableNet net(data);
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), net.nodes());
    EXPECT_NEAR(tension(0), 100.0 + 900.0 / 3.0, 1e-9);
    EXPECT_NEAR(tension(2), 1000.0, 1e-9);
    const double expected =
        2.0 * net.unstressed_lengths()(0) * (0.5 * 100.0 * 0.005 + 0.5 * (100.0 + 400.0) * 0.005) +
        2.0 * net.unstressed_lengths()(2) * 0.5 * 1000.0 * 0.01;
    EXPECT_NEAR(potential_energy(net, net.unstressed_lengths(), net.nodes()), expected, 1e-9);
}

RC_GTEST_PROP(TensionLaws, ForcesAreTheGradientOfTheEnergyAndStiffnessThatOfTheForces, ()) {
    test::Random random = test::any_random();
    const CableNet net(test::with_random_laws(random, test::random_net_data(random)));
    const Points form = net.nodes();
    RC_PRE(distance_from_corners(net, form) > 1e-5);
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const Eigen::VectorXd x = free_coordinates(net, form);
    const auto energy_at = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
        return Eigen::VectorXd::Constant(
            1, potential_energy(net, lengths, with_free_coordinates(net, at)));
    };
    const auto forces_at = [&](const Eigen::VectorXd& at) {
        return out_of_balance_forces(net, lengths, with_free_coordinates(net, at));
    };
    const Eigen::VectorXd forces = forces_at(x);
    const Eigen::VectorXd gradient = test::finite_differences(energy_at, x, 1e-6).transpose();
    RC_ASSERT((gradient - forces).norm() <= 1e-5 * (1.0 + forces.norm()));
    const Eigen::MatrixXd difference = test::finite_differences(forces_at, x, 1e-6);
    const Eigen::MatrixXd matrix = tangent_stiffness(net, lengths, form);
    RC_ASSERT((difference - matrix).norm() <= 1e-6 * (1.0 + matrix.norm()));
}

TEST(TensionLaws, OfPointsOnALineAreTheLinearLaw) {
    for (int seed = 0; seed < 20; ++seed) {
        test::Random random(seed);
        const CableNetData data = test::random_net_data(random);
        const CableNet linear(data);
        const CableNet straight(test::with_straight_laws(data));
        const Equilibrium a = solve_equilibrium(linear);
        const Equilibrium b = solve_equilibrium(straight);
        EXPECT_EQ(a.status, b.status) << seed;
        if (a.status == EquilibriumStatus::converged) {
            EXPECT_EQ(a.slack_edges, b.slack_edges) << seed;
            EXPECT_LT(largest_distance(a.form, b.form), 1e-7) << seed;
        }
        EXPECT_NEAR(potential_energy(linear, linear.unstressed_lengths(), a.form),
                    potential_energy(straight, straight.unstressed_lengths(), a.form), 1e-9);
        const EnergyCertificate ca =
            energy_certificate(linear, linear.unstressed_lengths(), linear.nodes());
        const EnergyCertificate cb =
            energy_certificate(straight, straight.unstressed_lengths(), straight.nodes());
        EXPECT_NEAR(ca.duality_gap, cb.duality_gap, 1e-9 * ca.duality_gap) << seed;
    }
}

// Laws that stiffen a hundredfold can make steps ever shorter.
TEST(TensionLaws, ThatStiffenAHundredfoldHaveAnEquilibrium) {
    const test::RandomNetSettings settings{.most_free_nodes = 12,
                                           .smallest_strain = -0.4,
                                           .largest_strain = 0.06,
                                           .largest_load = 3000.0};
    for (int seed = 0; seed < 1000; ++seed) {
        test::Random random(seed);
        const CableNetData data =
            test::with_random_laws(random, test::random_net_data(random, settings), test::wild_law);
        std::vector<int> from;
        for (const CableNet& net :
             {CableNet(data), CableNet(test::renumbered(random, data, from))}) {
            const Equilibrium found = solve_equilibrium(net);
            ASSERT_TRUE(found.balanced()) << seed;
            EXPECT_LT(energy_certificate(net, net.unstressed_lengths(), found.form).relative_gap,
                      1e-3)
                << seed;
        }
    }
}

// If a law is flat the gap grows with the out-of-balance force, not with its square: up to 3e-4 of
// the elastic energy in experiments.
TEST(TensionLaws, EquilibriumIsCertifiedAndCloselyExceptForFewNets) {
    int loose = 0;
    for (int seed = 0; seed < 2000; ++seed) {
        test::Random random(seed);
        const CableNet net(test::with_random_laws(random, test::random_net_data(random)));
        const Eigen::VectorXd& lengths = net.unstressed_lengths();
        const Equilibrium found = solve_equilibrium(net);
        ASSERT_TRUE(found.balanced()) << seed;
        const EnergyCertificate proof = energy_certificate(net, lengths, found.form);
        EXPECT_GE(proof.duality_gap, 0.0) << seed;
        EXPECT_LT(proof.relative_gap, 1e-3) << seed;
        loose += proof.relative_gap < 1e-5 ? 0 : 1;
        // Any other form has a higher energy, by at most the gap of its certificate.
        EXPECT_LE(potential_energy(net, lengths, net.nodes()) -
                      potential_energy(net, lengths, found.form),
                  energy_certificate(net, lengths, net.nodes()).duality_gap +
                      1e-9 * (1.0 + std::abs(proof.energy)))
            << seed;
    }
    EXPECT_LE(loose, 5);
}

TEST(TensionLaws, EquilibriumIsThatOfTheConeProgram) {
    if (!cone_solver_available()) {
        GTEST_SKIP() << "built without Clarabel";
    }
    for (const double error : {0.0, 0.003}) {
        const CableNet net = two_slope_hypar(error);
        const Equilibrium newton = solve_equilibrium(net);
        ASSERT_EQ(newton.status, EquilibriumStatus::converged);
        for (const ConeForm form : {ConeForm::quadratic, ConeForm::paper}) {
            const ConeSolution cone =
                solve_cone_program(net, net.unstressed_lengths(), {.form = form});
            ASSERT_TRUE(cone.solved()) << to_string(form);
            EXPECT_LT(largest_distance(cone.form, newton.form), 1e-5) << to_string(form);
            const double lowest = potential_energy(net, net.unstressed_lengths(), newton.form);
            EXPECT_NEAR(cone.primal_objective, lowest, 1e-7 * lowest) << to_string(form);
            EXPECT_LT(energy_certificate(net, net.unstressed_lengths(), cone.form, cone.edge_forces)
                          .relative_gap,
                      1e-5);
        }
    }
}

TEST(TensionLaws, CutForTheSameTensionsKeepTheForm) {
    const CableNet net = two_slope_hypar(0.0);
    const Equilibrium found = solve_equilibrium(net);
    ASSERT_EQ(found.status, EquilibriumStatus::converged);
    EXPECT_LT(largest_distance(found.form, hypar(6, 7).nodes()), 1e-9);
}

TEST(TensionLaws, SensitivityIsTheDerivativeOfTheForm) {
    const CableNet net = two_slope_hypar(0.002);
    const Equilibrium found = solve_equilibrium(net);
    ASSERT_EQ(found.status, EquilibriumStatus::converged);
    ASSERT_GT(distance_from_corners(net, found.form), 2e-6);
    EquilibriumSolver solver(net);
    const Eigen::MatrixXd difference = test::finite_differences(
        [&](const Eigen::VectorXd& lengths) {
            return free_coordinates(net, solver.solve(lengths, found.form).form);
        },
        net.unstressed_lengths(), 1e-8);
    const Eigen::MatrixXd derivative =
        FormSensitivity(net, net.unstressed_lengths(), found.form).columns(test::all_edges(net));
    EXPECT_LT((difference - derivative).norm(), 1e-4 * derivative.norm());
}

}  // namespace
}  // namespace taut
