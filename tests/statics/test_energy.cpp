// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against forces that are not the slope of the energy, and a stiffness that is not the slope
// of the forces: the solver then still ends somewhere, slowly or at the wrong form.
#include "taut/statics/energy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>

#include "support/finite_differences.hpp"
#include "support/random_nets.hpp"
#include "support/small_nets.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// A random net in which no edge is at the kink of its energy: so finite differences hold.
CableNet random_net_off_the_kink(test::Random& random) {
    CableNetData data = test::random_net_data(random);
    for (size_t e = 0; e < data.edges.size(); ++e) {
        const auto [s, t] = data.edges[e];
        double& l_0 = data.unstressed_lengths(static_cast<Eigen::Index>(e));
        const double length = (data.nodes.col(s) - data.nodes.col(t)).norm();
        if (std::abs(length - l_0) < 1e-3) {
            l_0 += 0.01;
        }
    }
    return CableNet(std::move(data));
}

TEST(Energy, IsThatComputedByHand) {
    // Node 0 in the middle of four edges of l_0 = 1 / 1.25 = 0.8 m, then moved 0.75 m upwards, so
    // that all are 1.25 m long: 4 * 100 kN / (2 * 0.8 m) * (0.45 m)^2 - 200 N * 0.75 m.
    CableNetData data = test::cross_data(0.25);
    data.loads = Points::Zero(3, 5);
    data.loads(2, 0) = 200.0;
    data.loads(2, 1) = 1e6;  // on a support: does no work
    const CableNet net(std::move(data));
    Points form = net.nodes();
    EXPECT_DOUBLE_EQ(energy(net, net.unstressed_lengths(), form), 4.0 * 62.5e3 * 0.04);
    form(2, 0) = 0.75;
    EXPECT_DOUBLE_EQ(energy(net, net.unstressed_lengths(), form), 4.0 * 62.5e3 * 0.2025 - 150.0);
    // 4 edges of 100 kN * (1.25 / 0.8 - 1), inclined by 0.75 / 1.25.
    const Eigen::Vector3d forces = out_of_balance_forces(net, net.unstressed_lengths(), form);
    EXPECT_TRUE(forces.isApprox(Eigen::Vector3d(0.0, 0.0, 4.0 * 56.25e3 * 0.6 - 200.0), 1e-14));
}

TEST(Energy, OfSlackEdgesIsZero) {
    const CableNet net(test::cross_data(-0.1));
    EXPECT_EQ(energy(net, net.unstressed_lengths(), net.nodes()), 0.0);
    EXPECT_TRUE(out_of_balance_forces(net, net.unstressed_lengths(), net.nodes()).isZero(0.0));
    EXPECT_TRUE(stiffness(net, net.unstressed_lengths(), net.nodes()).toDense().isZero(0.0));
}

RC_GTEST_PROP(OutOfBalanceForces, AreTheSlopeOfTheEnergy, ()) {
    test::Random random = test::any_random();
    const CableNet net = random_net_off_the_kink(random);
    const auto energy_at = [&](const Eigen::VectorXd& r) {
        const double v = energy(net, net.unstressed_lengths(), with_free_coordinates(net, r));
        return Eigen::VectorXd::Constant(1, v);
    };
    const Eigen::VectorXd forces =
        out_of_balance_forces(net, net.unstressed_lengths(), net.nodes());
    const Eigen::RowVectorXd slope =
        test::finite_differences(energy_at, free_coordinates(net, net.nodes()), 1e-4);
    RC_ASSERT((forces - slope.transpose()).norm() < 1e-5 * (1.0 + forces.norm()));
}

RC_GTEST_PROP(Stiffness, IsTheSlopeOfTheForces, ()) {
    test::Random random = test::any_random();
    const CableNet net = random_net_off_the_kink(random);
    const auto forces_at = [&](const Eigen::VectorXd& r) {
        return out_of_balance_forces(net, net.unstressed_lengths(), with_free_coordinates(net, r));
    };
    const Eigen::MatrixXd H = stiffness(net, net.unstressed_lengths(), net.nodes());
    const Eigen::MatrixXd slope =
        test::finite_differences(forces_at, free_coordinates(net, net.nodes()), 1e-4);
    RC_ASSERT((H - slope).norm() < 1e-5 * (1.0 + H.norm()));
}

RC_GTEST_PROP(Stiffness, IsSymmetricAndPositiveSemidefinite, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Points form = test::uniform_points(random, net.node_count(), 3.0);
    const Eigen::MatrixXd H = stiffness(net, net.unstressed_lengths(), form);
    RC_ASSERT(H == H.transpose());
    const double smallest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H, Eigen::EigenvaluesOnly).eigenvalues()(0);
    RC_ASSERT(smallest >= -1e-12 * H.norm());
}

RC_GTEST_PROP(Energy, IsConvex, ()) {
    test::Random random = test::any_random();
    const CableNet net = test::random_net(random);
    const Points a = test::uniform_points(random, net.node_count(), 3.0);
    const Points b = test::uniform_points(random, net.node_count(), 3.0);
    // Supports move along, too: V is convex in all coordinates.
    const double s = test::uniform(random, 0.0, 1.0);
    const double v_a = energy(net, net.unstressed_lengths(), a);
    const double v_b = energy(net, net.unstressed_lengths(), b);
    const double between = energy(net, net.unstressed_lengths(), (1.0 - s) * a + s * b);
    RC_ASSERT(between <= (1.0 - s) * v_a + s * v_b + 1e-12 * (std::abs(v_a) + std::abs(v_b)));
}

using Function = void (*)(const CableNet&, const Eigen::VectorXd&, const Points&);

class FunctionOfAForm : public ::testing::TestWithParam<Function> {};

TEST_P(FunctionOfAForm, RefusesWrongArguments) {
    using ::testing::AllOf;
    using ::testing::HasSubstr;
    using ::testing::ThrowsMessage;
    const CableNet net(test::cross_data(0.02));
    const Eigen::VectorXd lengths = net.unstressed_lengths();
    const auto refuses = [&](const Eigen::VectorXd& l_0, const Points& form, const char* words) {
        EXPECT_THAT([&] { GetParam()(net, l_0, form); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(words)));
    };
    EXPECT_NO_THROW(GetParam()(net, lengths, net.nodes()));
    refuses(lengths.head(3), net.nodes(), "unstressed_lengths has 3 entries, expected 4");
    refuses(lengths, net.nodes().leftCols(4), "form has 4 points, expected 5");
    Eigen::VectorXd bad_lengths = lengths;
    bad_lengths(2) = 0.0;
    refuses(bad_lengths, net.nodes(), "unstressed length 2 is 0, expected a positive");
    Points bad_form = net.nodes();
    bad_form(1, 3) = std::numeric_limits<double>::infinity();
    refuses(lengths, bad_form, "at node 3, expected finite");
}

INSTANTIATE_TEST_SUITE_P(Statics, FunctionOfAForm,
                         ::testing::Values([](const CableNet& n, const Eigen::VectorXd& l,
                                              const Points& r) { (void)energy(n, l, r); },
                                           [](const CableNet& n, const Eigen::VectorXd& l,
                                              const Points& r) {
                                               (void)out_of_balance_forces(n, l, r);
                                           },
                                           [](const CableNet& n, const Eigen::VectorXd& l,
                                              const Points& r) { (void)stiffness(n, l, r); },
                                           [](const CableNet& n, const Eigen::VectorXd& l,
                                              const Points& r) { (void)tensions(n, l, r); },
                                           [](const CableNet& n, const Eigen::VectorXd& l,
                                              const Points& r) { (void)slack_edges(n, l, r); }));

}  // namespace
}  // namespace taut
