// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against struts that go slack, a form that is called stable while it buckles, and
// derivatives that hold for cables alone. Forms of nets with struts are checked against SciPy in
// test_equilibrium_reference.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "statics/descent.hpp"
#include "statics/reference_net.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/statics/stability.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

constexpr double load = 500.0;

/// A strut of 2 m upright on a support, with a load on top and two guys along x and y: it has no
/// guys against them.
CableNet column(double guy_strain) {
    CableNetData data;
    data.nodes = Points{{0.0, 0.0, 1.5, -1.5, 0.0, 0.0},
                        {0.0, 0.0, 0.0, 0.0, 1.5, -1.5},
                        {0.0, 2.0, 0.0, 0.0, 0.0, 0.0}};
    data.supports = {0, 2, 3, 4, 5};
    data.edges = {{0, 1}, {1, 2}, {1, 3}, {1, 4}, {1, 5}};
    data.axial_stiffness = Eigen::VectorXd{{1e6, 1e5, 1e5, 1e5, 1e5}};
    data.unstressed_lengths = Eigen::VectorXd::Constant(5, 2.5 / (1.0 + guy_strain));
    data.unstressed_lengths(0) = 2.0;
    data.kind.assign(5, EdgeKind::cable);
    data.kind[0] = EdgeKind::strut;
    data.loads = Points::Zero(3, 6);
    data.loads(2, 1) = -load;
    return CableNet(std::move(data));
}

/// Two struts up to a flat apex: the truss of R. von Mises, which snaps through.
CableNet toggle(double on_apex) {
    CableNetData data;
    data.nodes =
        Points{{-1.0, 1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 1.0, -1.0}, {0.0, 0.0, 0.1, 0.1, 0.1}};
    data.supports = {0, 1, 3, 4};
    data.edges = {{0, 2}, {1, 2}, {2, 3}, {2, 4}};  // the last two hold it in its plane
    data.axial_stiffness = Eigen::VectorXd{{1e5, 1e5, 1e3, 1e3}};
    const double length = std::sqrt(1.01);
    data.unstressed_lengths = Eigen::VectorXd{{length, length, 0.999, 0.999}};
    data.kind = {EdgeKind::strut, EdgeKind::strut, EdgeKind::cable, EdgeKind::cable};
    data.loads = Points::Zero(3, 5);
    data.loads(2, 2) = -on_apex;
    return CableNet(std::move(data));
}

TEST(Strut, CarriesWhatTheGuysAndTheLoadPressItWith) {
    const CableNet net = column(0.01);
    const Equilibrium e = solve_equilibrium(net);
    ASSERT_EQ(e.status, EquilibriumStatus::converged);
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), e.form);
    const double height = e.form(2, 1);
    const double of_guys = 4.0 * tension(1) * height / std::hypot(height, 1.5);
    EXPECT_NEAR(tension(0), -load - of_guys, 1e-6);
    EXPECT_NEAR(tension(0), 1e6 * (height / 2.0 - 1.0), 1e-6);
    EXPECT_NEAR(e.mean_tension, tension.tail(4).mean(), 1e-9);  // over the cables
    EXPECT_TRUE(slack_edges(net, net.unstressed_lengths(), e.form).empty());
    EXPECT_DOUBLE_EQ(mean_weights(net).dot(tension), tension.tail(4).mean());
}

TEST(Strut, OfASimplexHasTheFormAndForcesThatMusclePyFinds) {
    const test::Json json = test::reference_net("struts_reference.json", "simplex");
    const CableNet net = test::net_of(json);
    const Equilibrium e = solve_equilibrium(net);
    ASSERT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_GT((e.form - net.nodes()).cwiseAbs().maxCoeff(), 0.01);
    EXPECT_LT((e.form - test::points_of(json.at("form"))).cwiseAbs().maxCoeff(), 1e-7);
    const Eigen::VectorXd expected = test::vector_of(json.at("tensions"));
    const Eigen::VectorXd tension = tensions_of(net, net.unstressed_lengths(), e.form);
    EXPECT_LT((tension - expected).cwiseAbs().maxCoeff(), 1e-5 * expected.cwiseAbs().maxCoeff());
}

TEST(Strut, TopplesWhereItsStiffnessIsNegative) {
    // One strut on the other, under a load, with guys that are slack, and a plumb line: it is less
    // stiff sideways than the struts are unstable.
    CableNetData data;
    data.nodes = Points{{0.0, 0.0, 0.0, 2.0, 2.0, 2.0},
                        {0.0, 0.0, 0.0, -1.0, 1.0, 1.0},
                        {0.0, 1.0, 2.0, 0.0, 0.0, -1.0}};
    data.supports = {0, 3, 4};
    data.edges = {{0, 1}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {4, 5}};
    data.axial_stiffness = Eigen::VectorXd::Constant(7, 1e6);
    data.unstressed_lengths = Eigen::VectorXd{{1.0, 1.0, 5.0, 5.0, 5.0, 5.0, 1.0 - 1e-6}};
    data.kind.assign(7, EdgeKind::cable);
    data.kind[0] = data.kind[1] = EdgeKind::strut;
    data.loads = Points::Zero(3, 6);
    data.loads(2, 2) = -load;
    data.loads(2, 5) = -1e-6 / (1.0 - 1e-6) * 1e6;
    const CableNet net(data);
    Points form = net.nodes();
    form(2, 1) = 1.0 - load / 1e6;
    form(2, 2) = 2.0 * form(2, 1);  // balanced
    const LocalNet local = number_naturally(net);
    NetState state(local);
    local.gather(form, state.form());
    state.set_unstressed_lengths(local, net.unstressed_lengths());
    state.update(local);
    Stiffness of_state(local);
    ASSERT_TRUE(is_unstable(local, of_state, state));
    const Eigen::VectorXd direction = direction_of_collapse(local, of_state, state);
    EXPECT_NEAR(direction.reshaped(3, 3).colwise().norm().maxCoeff(), 1.0, 1e-12);
    const Eigen::MatrixXd matrix = tangent_stiffness(net, net.unstressed_lengths(), form);
    const double steepest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues()(0);
    const double along = direction.dot(matrix * direction) / direction.squaredNorm();
    EXPECT_LT(along, 0.7 * steepest);
}

TEST(Strut, IsNotStableWithoutGuysThatHoldIt) {
    const CableNet net = column(-0.1);  // slack
    const Equilibrium e = solve_equilibrium(net);
    EXPECT_EQ(e.status, EquilibriumStatus::unstable);
    EXPECT_FALSE(e.balanced());
    EXPECT_LT(e.out_of_balance, 1e-6);
    // Pushed aside, the strut turns with - P / l.
    EXPECT_NEAR(smallest_stiffness(net, net.unstressed_lengths(), e.form), -load / e.form(2, 1),
                1e-2 * load / 2.0);
    // From beside, it falls into the guys.
    Points start = net.nodes();
    start(0, 1) = 0.05;
    start(1, 1) = 0.03;
    const Equilibrium beside = EquilibriumSolver(net).solve(net.unstressed_lengths(), start);
    EXPECT_NE(beside.status, EquilibriumStatus::unstable);
    EXPECT_LT(potential_energy(net, net.unstressed_lengths(), beside.form),
              potential_energy(net, net.unstressed_lengths(), e.form));
}

/// A mast of two struts with four guys at either level; the upper ones are slack.
CableNet leaning_mast() {
    CableNetData data;
    data.nodes = Points{{0.0, 0.0, 0.0, 3.0, -3.0, 0.0, 0.0},
                        {0.0, 0.0, 0.0, 0.0, 0.0, 3.0, -3.0},
                        {0.0, 3.0, 5.97, 0.0, 0.0, 0.0, 0.0}};
    data.supports = {0, 3, 4, 5, 6};
    data.edges = {{0, 1}, {1, 2}};
    for (const int level : {1, 2}) {
        for (const int foot : {3, 4, 5, 6}) {
            data.edges.push_back({level, foot});
        }
    }
    data.axial_stiffness = Eigen::VectorXd::Constant(10, 2e6);
    data.unstressed_lengths = Eigen::VectorXd::Constant(10, std::hypot(3.0, 3.0) - 0.02);
    data.unstressed_lengths.head(2) << 3.005, 2.97;
    data.unstressed_lengths.tail(4).setConstant(std::hypot(3.0, 6.0) - 0.005);
    data.kind.assign(10, EdgeKind::cable);
    data.kind[0] = data.kind[1] = EdgeKind::strut;
    data.loads = Points::Zero(3, 7);
    data.loads(2, 2) = -2000.0;
    return CableNet(std::move(data));
}

TEST(Strut, LeavesASaddleForAStableFormBesideIt) {
    const CableNet net = leaning_mast();
    const Equilibrium e = solve_equilibrium(net);
    ASSERT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_GT(smallest_stiffness(net, net.unstressed_lengths(), e.form), 0.0);
    const double lean = e.form.topRows<2>().col(2).norm();
    EXPECT_GT(lean, 1e-3);
    EXPECT_LT(lean, 0.5);
}

TEST(Strut, SnapsThroughUnderItsCriticalLoad) {
    // To first order at 2 EA (h/l)^3 / (3 sqrt(3)) = 38.5 N, and the cables add little.
    const Equilibrium below = solve_equilibrium(toggle(35.0));
    ASSERT_EQ(below.status, EquilibriumStatus::converged);
    EXPECT_GT(below.form(2, 2), 0.05);
    const Equilibrium above = solve_equilibrium(toggle(42.0));
    ASSERT_EQ(above.status, EquilibriumStatus::converged);
    EXPECT_LT(above.form(2, 2), -0.1);
}

class BuiltinNetWithStruts : public ::testing::TestWithParam<const char*> {};

TEST_P(BuiltinNetWithStruts, HasForcesAndStiffnessThatAreDerivativesOfItsEnergy) {
    const CableNet net = builtin_net(GetParam());
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const Eigen::VectorXd at =
        free_coordinates(net, net.nodes()) +
        1e-3 * Eigen::VectorXd::LinSpaced(3 * net.free_node_count(), -1.0, 1.0);
    const auto forces = [&](const Eigen::VectorXd& x) {
        return out_of_balance_forces(net, lengths, with_free_coordinates(net, x));
    };
    const Eigen::MatrixXd H = tangent_stiffness(net, lengths, with_free_coordinates(net, at));
    constexpr double step = 1e-6;
    for (Eigen::Index k = 0; k < at.size(); k += 7) {
        const Eigen::VectorXd change = step * Eigen::VectorXd::Unit(at.size(), k);
        const double slope =
            (potential_energy(net, lengths, with_free_coordinates(net, at + change)) -
             potential_energy(net, lengths, with_free_coordinates(net, at - change))) /
            (2.0 * step);
        EXPECT_NEAR(forces(at)(k), slope, 1e-5 * forces(at).cwiseAbs().maxCoeff() + 1e-2);
        const Eigen::VectorXd column = (forces(at + change) - forces(at - change)) / (2.0 * step);
        EXPECT_LT((H.col(k) - column).norm(), 1e-6 * H.col(k).norm()) << k;
    }
}

TEST_P(BuiltinNetWithStruts, HasItsSmallestStiffnessAsTheEigenvaluesHaveIt) {
    const CableNet net = builtin_net(GetParam());
    const Eigen::MatrixXd H = tangent_stiffness(net, net.unstressed_lengths(), net.nodes());
    const double smallest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues()(0);
    EXPECT_GT(smallest, 0.0);
    EXPECT_NEAR(smallest_stiffness(net, net.unstressed_lengths(), net.nodes()), smallest,
                1e-3 * smallest);
}

TEST_P(BuiltinNetWithStruts, MovesWithItsLengthsAsTheSensitivityHasIt) {
    const CableNet net = builtin_net(GetParam());
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const FormSensitivity sensitivity(net, lengths, net.nodes());
    EquilibriumSolver solver(net);
    constexpr double step = 1e-6;
    for (int edge = 0; edge < net.edge_count(); edge += 5) {
        const Eigen::VectorXd change = Eigen::VectorXd::Unit(net.edge_count(), edge);
        const auto form_at = [&](double by) {
            return free_coordinates(net, solver.solve(lengths + by * change, net.nodes()).form);
        };
        const Eigen::VectorXd expected = (form_at(step) - form_at(-step)) / (2.0 * step);
        EXPECT_LT((sensitivity.apply(change) - expected).norm(), 1e-5 * expected.norm()) << edge;
    }
}

TEST_P(BuiltinNetWithStruts, HasNeitherCertificateNorConeProgram) {
    const CableNet net = builtin_net(GetParam());
    const auto certificate = [&] {
        (void)energy_certificate(net, net.unstressed_lengths(), net.nodes());
    };
    const auto program = [&] { (void)solve_cone_program(net, net.unstressed_lengths()); };
    EXPECT_THAT(certificate, testing::ThrowsMessage<std::invalid_argument>(
                                 testing::HasSubstr("struts: its energy is not convex")));
    EXPECT_THAT(program, testing::ThrowsMessage<std::invalid_argument>(
                             testing::HasSubstr("struts: its energy is not convex")));
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinNetWithStruts,
                         ::testing::Values("cable-dome", "spoke-wheel", "tensegrity-simplex"),
                         [](const auto& param) {
                             std::string name(param.param);
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace taut
