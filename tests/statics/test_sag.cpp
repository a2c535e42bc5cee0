// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against cables whose sag is another than that of a catenary, that go slack, and
// derivatives that hold for straight edges alone. Forms by the same parabola are checked against
// SciPy in test_equilibrium_reference.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "statics/reference_net.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

CableNet sagging() {
    return test::net_of(test::reference_net("statics_reference.json", "sagging"));
}

/// The net whose cables hang as catenaries in the reference, with their weights as masses.
CableNetData heavy() {
    const test::Json json = test::reference_net("statics_reference.json", "catenaries");
    CableNetData data = test::net_of(json).data();
    data.mass = test::vector_of(json.at("weights")) / gravity;
    return data;
}

TEST(Sag, OfHeavyCablesGivesTheFormOfElasticCatenaries) {
    const test::Json json = test::reference_net("statics_reference.json", "catenaries");
    const Points expected = test::points_of(json.at("form"));
    const Eigen::VectorXd pulls = test::vector_of(json.at("tensions"));
    CableNetData data = heavy();
    const auto departure = [&](const CableNetData& of) {
        const CableNet net(of);
        const Equilibrium e = solve_equilibrium(net);
        EXPECT_EQ(e.status, EquilibriumStatus::converged);
        return std::pair{(e.form - expected).colwise().norm().maxCoeff(),
                         (tensions_of(net, net.unstressed_lengths(), e.form) - pulls)
                             .cwiseQuotient(pulls)
                             .cwiseAbs()
                             .maxCoeff()};
    };
    const auto [straight, straight_pull] = departure(data);
    data.sag_weight = sag_weights_by_mass(data);
    const auto [sagged, sagged_pull] = departure(data);
    EXPECT_GT(straight, 0.05);
    EXPECT_LT(sagged, 0.01 * straight);
    EXPECT_LT(sagged_pull, 0.02 * straight_pull);
    EXPECT_GT(straight_pull, 0.05);
}

TEST(Sag, KeepsLooseCablesUnderTension) {
    const CableNet net = sagging();
    const Equilibrium e = solve_equilibrium(net);
    ASSERT_EQ(e.status, EquilibriumStatus::converged);
    EXPECT_TRUE(slack_edges(net, net.unstressed_lengths(), e.form).empty());
    EXPECT_GT(tensions_of(net, net.unstressed_lengths(), e.form).minCoeff(), 0.0);
    const Eigen::VectorXd spans = edge_lengths(net, e.form);
    EXPECT_LT((spans - net.unstressed_lengths()).minCoeff(), -0.003);  // some are loose
    EXPECT_FALSE(net.can_be_slack(1));
    EXPECT_TRUE(net.can_be_slack(0));  // has no weight
}

TEST(Sag, HasACertificateAndNoConeProgram) {
    const CableNet net = sagging();
    const Equilibrium e = solve_equilibrium(net);
    const EnergyCertificate in_balance = energy_certificate(net, net.unstressed_lengths(), e.form);
    EXPECT_GE(in_balance.duality_gap, -1e-12);
    EXPECT_LT(in_balance.relative_gap, 1e-10);
    // Beside it, the gap is at least what the energy is above the lowest.
    Points beside = e.form;
    beside.col(net.free_nodes()[4]) += Eigen::Vector3d(0.01, -0.02, 0.015);
    const EnergyCertificate there = energy_certificate(net, net.unstressed_lengths(), beside);
    EXPECT_GT(there.energy, in_balance.energy);
    EXPECT_GE(there.duality_gap, there.energy - in_balance.energy);
    EXPECT_THAT([&] { (void)solve_cone_program(net, net.unstressed_lengths()); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("sag")));
}

TEST(Sag, HasForcesAndStiffnessThatAreDerivativesOfTheEnergy) {
    const CableNet net = sagging();
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const Eigen::VectorXd at = free_coordinates(net, solve_equilibrium(net).form) +
                               0.01 * Eigen::VectorXd::LinSpaced(27, -1.0, 1.0);
    const auto forces = [&](const Eigen::VectorXd& x) {
        return out_of_balance_forces(net, lengths, with_free_coordinates(net, x));
    };
    const Eigen::MatrixXd H = tangent_stiffness(net, lengths, with_free_coordinates(net, at));
    constexpr double step = 1e-6;
    for (Eigen::Index k = 0; k < at.size(); ++k) {
        const Eigen::VectorXd change = step * Eigen::VectorXd::Unit(at.size(), k);
        const double slope =
            (potential_energy(net, lengths, with_free_coordinates(net, at + change)) -
             potential_energy(net, lengths, with_free_coordinates(net, at - change))) /
            (2.0 * step);
        EXPECT_NEAR(forces(at)(k), slope, 1e-6 * forces(at).cwiseAbs().maxCoeff()) << k;
        const Eigen::VectorXd column = (forces(at + change) - forces(at - change)) / (2.0 * step);
        EXPECT_LT((H.col(k) - column).norm(), 1e-6 * H.col(k).norm()) << k;
    }
}

TEST(Sag, MovesWithLengthsAndStiffnessAsTheSensitivityHasIt) {
    const CableNet net = sagging();
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const Points form = solve_equilibrium(net).form;
    const FormSensitivity sensitivity(net, lengths, form);
    const auto form_of = [&](const Eigen::VectorXd& by, const Eigen::VectorXd& stiffness_by) {
        CableNetData data = net.data();
        data.axial_stiffness += stiffness_by;
        const CableNet changed(data);  // S stays that of the net's own lengths
        return free_coordinates(net, EquilibriumSolver(changed).solve(lengths + by, form).form);
    };
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(net.edge_count());
    const Eigen::VectorXd at = form_of(none, none);
    const Eigen::VectorXd towards = Eigen::VectorXd::LinSpaced(at.size(), -1.0, 2.0);
    Points gradient = Points::Zero(3, net.node_count());
    for (int i = 0; i < net.free_node_count(); ++i) {
        gradient.col(net.free_nodes()[i]) = towards.segment<3>(3 * i);
    }
    const NetGradient by_net = sensitivity.net_gradient(gradient);
    constexpr double step = 1e-5;
    for (int edge = 0; edge < net.edge_count(); edge += 2) {
        const Eigen::VectorXd change = Eigen::VectorXd::Unit(net.edge_count(), edge);
        const Eigen::VectorXd forth = form_of(step * change, none);
        const Eigen::VectorXd back = form_of(-step * change, none);
        const Eigen::VectorXd slope = (forth - back) / (2.0 * step);
        EXPECT_LT((sensitivity.apply(change) - slope).norm(), 1e-5 * slope.norm()) << edge;
        const Eigen::VectorXd curvature = (forth - 2.0 * at + back) / (step * step);
        EXPECT_LT((sensitivity.apply_second(change, change) - curvature).norm(),
                  1e-2 * curvature.norm() + 1e-3 * slope.norm())
            << edge;
        const double EA = net.axial_stiffness()(edge);
        const double by_stiffness =
            towards.dot(form_of(none, 1e-4 * EA * change) - form_of(none, -1e-4 * EA * change)) /
            (2e-4 * EA);
        EXPECT_NEAR(by_net.axial_stiffness(edge), by_stiffness,
                    1e-4 * by_net.axial_stiffness.cwiseAbs().maxCoeff())
            << edge;
    }
}

TEST(Sag, OfAVeryLightCableIsThatOfAStraightOne) {
    CableNetData data = sagging().data();
    data.sag_weight.setConstant(1e-6);
    const CableNet light(data);
    data.sag_weight.resize(0);
    const CableNet straight(data);
    EXPECT_FALSE(light.sags());
    EXPECT_EQ(solve_equilibrium(light).form, solve_equilibrium(straight).form);
    EXPECT_NE(light.fingerprint(), straight.fingerprint());
}

}  // namespace
}  // namespace taut
