// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards Newton's method and the cone program against each other, and both against CVXPY with other
// solvers: they share nothing but the net. The paper's form: test_tension_laws.cpp. In a build
// without Clarabel only the refusal is tested.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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
    const Eigen::VectorXd tension = tensions(net, net.unstressed_lengths(), form);
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
            const double lowest = energy(net, net.unstressed_lengths(), newton.form);
            const double scale = elastic_energy(net, newton.form);
            EXPECT_NEAR(energy(net, net.unstressed_lengths(), cone.form), lowest, 1e-9 * scale);
            EXPECT_NEAR(cone.primal_objective, lowest, 1e-9 * scale);
            EXPECT_NEAR(cone.dual_objective, lowest, 1e-9 * scale);
        }
    }
}

TEST_F(ConeProgram, GivesForcesThatBalanceAndAreTheTensions) {
    const CableNet net = disturbed("hypar:8x10", 50.0);
    const ConeSolution cone = solve_cone_program(net, net.unstressed_lengths());
    Points sums = -net.loads();
    const Eigen::VectorXd tension = tensions(net, net.unstressed_lengths(), cone.form);
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        sums.col(s) += cone.edge_forces.col(e);
        sums.col(t) -= cone.edge_forces.col(e);
        const Eigen::Vector3d direction = (cone.form.col(s) - cone.form.col(t)).normalized();
        EXPECT_LT((cone.edge_forces.col(e) - tension(e) * direction).norm(), 1e-5 * tension.mean());
    }
    EXPECT_LT(sums(Eigen::all, net.free_nodes()).norm(), 1e-8 * tension.mean());
    const EnergyCertificate c = certify(net, net.unstressed_lengths(), cone.form, cone.edge_forces);
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

/// Bound on how far the energy of the solver's form is above the lowest, from what it reports: the
/// distance of its objectives, and the residuals r_p = A x + s - b and r_d = P x + q + A'z relative
/// to
///
///   N_p = max(1, max |b| + |x| + |s|),   N_d = max(1, max |q| + |x| + |z|)
///
/// in its units of length and force. By convexity, and since s and z lie in cones that are dual to
/// each other, the objective at x is above the optimum x* by at most
///
///   p - d + 2 |z| |r_p| + |x*| |r_d|,
///
/// and r_p lets an edge be longer than its w allows, which costs sqrt(2) |T| |r_p| + max c |r_p|^2,
/// with |z| = sqrt(2) |T|. The bound is small beside the elastic energy if that is of the size of
/// these units. But they are taken from the net's nodes, and a net may slacken to a ten thousandth
/// of that.
double energy_by_residuals(const CableNet& net, const Points& lowest, const ConeSolution& cone) {
    const Eigen::VectorXd& unstressed = net.unstressed_lengths();
    const Eigen::VectorXd at_nodes = tensions(net, unstressed, net.nodes());
    const auto taut_count = (at_nodes.array() > 0.0).count();
    const double length = unstressed.mean();
    double force = taut_count > 0 ? at_nodes.sum() / static_cast<double>(taut_count)
                                  : net.loads().colwise().norm().mean();
    if (force == 0.0) {
        force = net.axial_stiffness().mean();
    }
    const Eigen::VectorXd c = net.axial_stiffness().cwiseQuotient(unstressed) * length / force;
    const auto norm_of_x = [&](const Points& form) {
        const Eigen::VectorXd T = tensions(net, unstressed, form) / force;
        return std::hypot((form - net.nodes()).norm() / length,
                          T.cwiseQuotient(c.cwiseSqrt()).norm());
    };
    const Eigen::VectorXd T = tensions(net, unstressed, cone.form) / force;
    const double x = norm_of_x(cone.form);
    const double z = std::sqrt(2.0) * T.norm();
    const double s = std::sqrt(2.0) * edge_lengths(net, cone.form).norm() / length + x;
    const double largest_b =
        std::max(unstressed.maxCoeff(), edge_lengths(net, net.nodes()).maxCoeff()) / length;
    const double largest_q = net.loads().cwiseAbs().maxCoeff() / force;
    const double r_p = cone.primal_residual * std::max(1.0, largest_b + x + s);
    const double r_d = cone.dual_residual * std::max(1.0, largest_q + x + z);
    return std::abs(cone.primal_objective - cone.dual_objective) +
           force * length * (3.0 * z * r_p + norm_of_x(lowest) * r_d + c.maxCoeff() * r_p * r_p);
}

void expect_the_cone_program_to_agree_with_newton() {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const Equilibrium newton = solve_equilibrium(net);
    const ConeSolution cone = solve_cone_program(net, lengths);
    RC_ASSERT(cone.solved());
    const double tolerance = cone.status == ConeStatus::solved ? 1e-9 : 1e-7;
    RC_ASSERT(cone.primal_residual <= tolerance);
    RC_ASSERT(cone.dual_residual <= tolerance);

    const double lowest = energy(net, lengths, newton.form);
    const double above = energy(net, lengths, cone.form) - lowest;
    const double rounding =
        1e-13 * (std::abs(lowest) + elastic_energy(net, newton.form) +
                 (net.loads().cwiseAbs().array() * newton.form.cwiseAbs().array()).sum());
    RC_ASSERT(above >= -certify(net, lengths, newton.form).duality_gap - rounding);
    RC_ASSERT(above <= energy_by_residuals(net, newton.form, cone) + rounding);
}

class ConeProgramOfARandomNet : public ConeProgram {};

TEST_F(ConeProgramOfARandomNet, AgreesWithNewtonWithinItsResiduals) {
    EXPECT_TRUE(rc::check(expect_the_cone_program_to_agree_with_newton));
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
