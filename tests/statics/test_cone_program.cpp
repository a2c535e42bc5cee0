// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards Newton's method and the cone program against each other, and both against CVXPY with other
// solvers: they share nothing but the net. The paper's form: test_tension_laws.cpp. In a build
// without Clarabel only the refusal is tested.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "statics/reference_net.hpp"
#include "support/balance.hpp"
#include "support/random_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using test::Json;
using test::largest_distance;
using test::points_of;
using test::reference_net;

class ConeProgram : public ::testing::Test {
protected:
    void SetUp() override {
        if (!cone_solver_available()) {
            GTEST_SKIP() << "built without Clarabel";
        }
    }
};

double elastic_energy(const CableNet& net, const Points& form) {
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), form);
    return (0.5 * tension.array().square() * net.unstressed_lengths().array() /
            net.axial_stiffness().array())
        .sum();
}

/// A built-in net with lengths off by up to 3 mm, and a weight at each node [N].
CableNet disturbed(const char* name, double weight) {
    CableNetData data = builtin_net(name).data();
    test::Random random(7);
    data.unstressed_lengths += test::uniform_vector(random, data.unstressed_lengths.size(), 0.003);
    data.loads = Points::Zero(3, data.nodes.cols());
    data.loads.row(2).setConstant(-weight);
    return CableNet(std::move(data));
}

TEST_F(ConeProgram, AgreesWithNewtonOnTheBuiltInNets) {
    for (const auto* name : {"hilo-quarter", "hypar:8x10"}) {
        for (const double weight : {0.0, 50.0}) {
            const CableNet net = disturbed(name, weight);
            const Equilibrium newton = solve_equilibrium(net);
            const ConeSolution cone = solve_cone_program(net, net.unstressed_lengths());
            EXPECT_EQ(cone.status, ConeStatus::solved) << name;
            EXPECT_LT(largest_distance(cone.form, newton.form), 1e-6) << name;
            const double lowest = potential_energy(net, net.unstressed_lengths(), newton.form);
            const double scale = elastic_energy(net, newton.form);
            EXPECT_NEAR(potential_energy(net, net.unstressed_lengths(), cone.form), lowest,
                        1e-9 * scale);
            EXPECT_NEAR(cone.primal_objective, lowest, 1e-9 * scale);
            EXPECT_NEAR(cone.dual_objective, lowest, 1e-9 * scale);
        }
    }
}

TEST_F(ConeProgram, GivesForcesThatBalanceAndAreTheTensions) {
    const CableNet net = disturbed("hypar:8x10", 50.0);
    const ConeSolution cone = solve_cone_program(net, net.unstressed_lengths());
    Points sums = -net.loads();
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), cone.form);
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        sums.col(s) += cone.edge_forces.col(e);
        sums.col(t) -= cone.edge_forces.col(e);
        const Eigen::Vector3d direction = (cone.form.col(s) - cone.form.col(t)).normalized();
        EXPECT_LT((cone.edge_forces.col(e) - tension(e) * direction).norm(), 1e-5 * tension.mean());
    }
    EXPECT_LT(sums(Eigen::all, net.free_nodes()).norm(), 1e-8 * tension.mean());
    const EnergyCertificate c =
        energy_certificate(net, net.unstressed_lengths(), cone.form, cone.edge_forces);
    EXPECT_LT(c.relative_gap, 1e-9);
}

TEST_F(ConeProgram, DoesNotDependOnTheSizeOfANet) {
    const CableNet net = disturbed("hypar:8x10", 50.0);
    const ConeSolution one = solve_cone_program(net, net.unstressed_lengths());
    for (const double length : {1e-3, 1e3}) {
        for (const double force : {1e-3, 1e6}) {
            CableNetData data = net.data();
            data.nodes *= length;
            data.unstressed_lengths *= length;
            data.axial_stiffness *= force;
            data.loads *= force;
            const CableNet other(std::move(data));
            const ConeSolution two = solve_cone_program(other, other.unstressed_lengths());
            EXPECT_TRUE(two.solved());
            EXPECT_NEAR(two.iterations, one.iterations, 2);
            EXPECT_LT(largest_distance(two.form / length, one.form), 1e-6);
        }
    }
}

TEST_F(ConeProgram, ReportsItsIterationLimit) {
    const CableNet net = hypar(2, 2);
    const ConeSolution cone =
        solve_cone_program(net, net.unstressed_lengths(), {.max_iterations = 2});
    EXPECT_EQ(cone.status, ConeStatus::iteration_limit);
    EXPECT_FALSE(cone.solved());
    EXPECT_EQ(cone.iterations, 2);
}

TEST_F(ConeProgram, AgreesWithCvxpyWithEcosAndScs) {
    for (const auto* name : {"grid", "chain", "tripod"}) {
        const Json json = reference_net("statics_reference.json", name);
        const CableNet net = test::net_of(json);
        const ConeSolution cone = solve_cone_program(net, net.unstressed_lengths());
        ASSERT_TRUE(cone.solved()) << name;
        const Json reference = reference_net("cone_reference.json", name);
        for (const auto* solver : {"ECOS", "SCS"}) {
            EXPECT_LT(largest_distance(cone.form, points_of(reference.at(solver).at("form"))), 1e-6)
                << name << ", " << solver;
            const double value = reference.at(solver).at("value").get<double>();
            EXPECT_NEAR(cone.primal_objective, value, 1e-7 * std::abs(value))
                << name << ", " << solver;
        }
    }
}

// Fixed seeds: for one net in some 1500 the solver stops with a numerical error.
TEST_F(ConeProgram, AgreesWithNewtonOnRandomNets) {
    for (int seed = 0; seed < 200; ++seed) {
        test::Random random(seed);
        const CableNet net = test::random_net(random);
        const Equilibrium newton = solve_equilibrium(net);
        const ConeSolution cone = solve_cone_program(net, net.unstressed_lengths());
        EXPECT_TRUE(cone.solved()) << seed;
        const double lowest = potential_energy(net, net.unstressed_lengths(), newton.form);
        // The solver's units follow from the nodes, and so do its tolerances.
        double scale = elastic_energy(net, net.nodes()) + net.loads().colwise().norm().sum();
        for (const ElasticSupport& support : net.elastic_supports()) {
            const Eigen::Vector3d shift = net.nodes().col(support.node) - support.place;
            scale += shift.dot(support.stiffness * shift);
        }
        EXPECT_NEAR(potential_energy(net, net.unstressed_lengths(), cone.form), lowest,
                    1e-6 * scale + 1e-15)  // where all is slack
            << seed;
    }
}

TEST(ConeProgramWithoutSolver, IsRefused) {
    if (cone_solver_available()) {
        GTEST_SKIP() << "built with Clarabel";
    }
    const CableNet net = hypar(1, 1);
    EXPECT_THROW(static_cast<void>(solve_cone_program(net, net.unstressed_lengths())),
                 std::invalid_argument);
}

}  // namespace
}  // namespace taut
