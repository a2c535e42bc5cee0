// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a survey moved to the wrong place: mirrored, scaled to fit, blurred by large
// coordinates, or fitted to points that do not determine a frame.

#include "taut/survey/registration.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <Eigen/Geometry>

#include "survey/covariance.hpp"
#include "survey/mean_edge_length.hpp"
#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;

RigidMotion some_motion(const Eigen::Vector3d& to) {
    return {.rotation = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().toRotationMatrix(),
            .from = Eigen::Vector3d(1, 2, 3),
            .to = to};
}

/// Supports of the built-in net as an instrument elsewhere sees them.
std::vector<ControlPoint> control_points(const CableNet& net, const RigidMotion& motion) {
    std::vector<ControlPoint> points;
    for (const int node : net.supports()) {
        points.push_back({.id = net.node_id(node),
                          .known = net.nodes().col(node),
                          .measured = motion(net.nodes().col(node))});
    }
    return points;
}

std::string refusal(std::vector<ControlPoint> points) {
    try {
        (void)register_rigidly(std::move(points));
    } catch (const SurveyError& error) {
        return error.what();
    }
    return "not refused";
}

TEST(RegisterRigidly, BringsAFarAwayFrameBackToTheNetToTheRoundingOfItsCoordinates) {
    const CableNet net = hilo_quarter();
    const RigidMotion away = some_motion({2.6e6, 1.2e6, 400.0});
    const Registration found = register_rigidly(control_points(net, away));
    // One rounding error of 2.6e6 m is 5e-10 m.
    EXPECT_LT(root_mean_square(found.residuals), 1e-9);
    for (const int node : net.free_nodes()) {
        const Eigen::Vector3d place = net.nodes().col(node);
        EXPECT_LT((found.motion(away(place)) - place).norm(), 1e-9);
    }
}

TEST(RegisterRigidly, DoesNotMirror) {
    std::vector<ControlPoint> points = control_points(hilo_quarter(), some_motion({0, 0, 0}));
    for (ControlPoint& point : points) {
        point.measured.x() *= -1.0;
    }
    const Registration found = register_rigidly(points);
    EXPECT_NEAR(found.motion.rotation.determinant(), 1.0, 1e-12);
    EXPECT_GT(root_mean_square(found.residuals), 0.1);
}

TEST(RegisterRigidly, GivesTheResidualOfEachPoint) {
    std::vector<ControlPoint> points = control_points(hilo_quarter(), some_motion({9, 8, 7}));
    points[5].measured += Eigen::Vector3d(0.0, 0.03, 0.0);
    const Registration found = register_rigidly(points);
    ASSERT_EQ(found.residuals.size(), points.size());
    double squares = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(found.residuals[i].id, points[i].id);
        const Eigen::Vector3d residual = found.motion(points[i].measured) - points[i].known;
        EXPECT_LT((found.residuals[i].residual - residual).norm(), 1e-12);
        EXPECT_NEAR(residual.norm(), i == 5 ? 0.03 : 0.0, 0.002);
        squares += residual.squaredNorm();
    }
    EXPECT_NEAR(root_mean_square(found.residuals),
                std::sqrt(squares / static_cast<double>(points.size())), 1e-12);
    EXPECT_EQ(root_mean_square({}), 0.0);
}

RC_GTEST_PROP(RegisterRigidly, LeavesNoRigidMotionThatFitsBetter, ()) {
    std::vector<ControlPoint> points;
    const auto coordinate = [] { return *rc::gen::inRange(-1000, 1000) * 1e-3; };
    for (int i = 0; i < 6; ++i) {
        const Eigen::Vector3d known(coordinate(), coordinate(), coordinate());
        const Eigen::Vector3d noise(coordinate(), coordinate(), coordinate());
        points.push_back({.known = known, .measured = known + 1e-3 * noise});
    }
    Registration found;
    try {
        found = register_rigidly(points);
    } catch (const SurveyError&) {
        RC_DISCARD("points on a line, or all alike");
    }
    double least = 0.0;
    for (const ControlResidual& r : found.residuals) {
        least += r.residual.squaredNorm();
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const double angle : {-1e-4, 1e-4}) {
            RigidMotion other = found.motion;
            other.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)) * other.rotation;
            double squares = 0.0;
            for (const ControlPoint& point : points) {
                squares += (other(point.measured) - point.known).squaredNorm();
            }
            RC_ASSERT(squares >= least);
        }
    }
}

TEST(RegisterRigidly, RefusesPointsThatDetermineNoFrame) {
    std::vector<ControlPoint> points = control_points(hilo_quarter(), some_motion({0, 0, 0}));
    for (ControlPoint& point : points) {
        point.measured *= 1000.0;
    }
    EXPECT_EQ(refusal(points),
              "the control points are measured 1000 times as far apart as they are, expected 1: is "
              "the survey of this net, and in metres?");
    points.resize(2);
    EXPECT_EQ(refusal(points),
              "holds 2 named supports or control points, expected at least 3 to find the frame");
    EXPECT_NE(refusal(std::vector<ControlPoint>(4)), "not refused");
    points.clear();
    for (int i = 0; i < 5; ++i) {
        const Eigen::Vector3d place(i, 2.0 * i, 3.0 * i);
        points.push_back({.known = place, .measured = place});
    }
    EXPECT_EQ(refusal(points),
              "the known places of the 5 control points lie on a line, expected three that do not");
}

TEST(SupportControlPoints, AreTheNamedSupportsOnly) {
    const CableNet net = hypar(3, 3);
    const int support = net.supports().front();
    const int free = net.free_nodes().front();
    const auto control = support_control_points(
        net,
        {{net.node_id(free), {1, 1, 1}, 1}, {net.node_id(support), {2, 2, 2}, 2}, {"", {}, 3}});
    ASSERT_EQ(control.size(), 1U);
    EXPECT_EQ(control[0].id, net.node_id(support));
    EXPECT_EQ(control[0].known, net.nodes().col(support));
    EXPECT_EQ(control[0].measured, Eigen::Vector3d(2, 2, 2));
}

TEST(SplitOffControlPoints, TakesThemByNameAndLeavesTargetsAndNodes) {
    const CableNet net = hypar(3, 3);
    const std::string node = net.node_id(net.free_nodes().front());
    std::vector<SurveyPoint> points{{.id = "pillar", .position = {1, 0, 0}, .line = 1},
                                    {.id = "", .position = {2, 0, 0}, .line = 2},
                                    {.id = node, .position = {3, 0, 0}, .line = 3}};
    const auto control = split_off_control_points(net,
                                                  {{.id = node, .position = {3, 1, 0}},
                                                   {.id = "pillar", .position = {1, 1, 0}},
                                                   {.id = "not seen", .position = {9, 9, 9}}},
                                                  points);
    ASSERT_EQ(control.size(), 2U);
    EXPECT_EQ(control[0].id, "pillar");
    EXPECT_EQ(control[0].measured, Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(control[0].known, Eigen::Vector3d(1, 1, 0));
    EXPECT_EQ(control[1].line, 3);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].line, 2);
    EXPECT_EQ(points[1].id, node);
}

TEST(SplitOffControlPoints, RefusesAKnownPointWithoutANameOfItsOwn) {
    const CableNet net = hypar(3, 3);
    std::vector<SurveyPoint> points;
    for (const std::string second : {"", "pillar"}) {
        try {
            static_cast<void>(split_off_control_points(net,
                                                       {{.id = "pillar", .position = {}, .line = 4},
                                                        {.id = second, .position = {}, .line = 5}},
                                                       points));
            ADD_FAILURE() << "'" << second << "' is not refused";
        } catch (const SurveyError& error) {
            EXPECT_EQ(error.line(), 5);
        }
    }
}

TEST(Moved, TurnsTheCovarianceOfATargetWithIt) {
    const RigidMotion motion{
        .rotation =
            Eigen::AngleAxisd(0.7, Eigen::Vector3d(2, -1, 3).normalized()).toRotationMatrix(),
        .to = {10, 20, 30}};
    const PlaceNoise noise{.std_dev = {1e-3, 3e-3, 2e-3}, .correlations = {0.3, -0.6, 0.2}};
    const auto points = moved({{.id = "A",
                                .position = {1, 2, 3},
                                .noise_std = noise.std_dev,
                                .noise_correlations = noise.correlations},
                               {.id = "B", .position = {}, .noise_std = Eigen::Vector3d(1, 1, 1)}},
                              motion);
    const Eigen::Matrix3d expected =
        motion.rotation * covariance_of(noise) * motion.rotation.transpose();
    const Eigen::Matrix3d found = covariance_of(
        {.std_dev = *points[0].noise_std, .correlations = points[0].noise_correlations});
    EXPECT_TRUE(found.isApprox(expected, 1e-12)) << found;
    // The same in every direction, and so in every frame: to the last bit.
    EXPECT_EQ(*points[1].noise_std, Eigen::Vector3d(1, 1, 1));
    EXPECT_EQ(points[1].noise_correlations, Eigen::Vector3d::Zero());
}

TEST(InFrameOfNet, HoldsToATenthOfTheMeanEdgeLength) {
    const CableNet net = hypar(3, 3);
    const double mean = mean_edge_length(net);
    std::vector<ControlPoint> points = control_points(net, {});
    EXPECT_TRUE(in_frame_of_net(net, points));
    points[2].measured.y() += 0.099 * mean;
    EXPECT_TRUE(in_frame_of_net(net, points));
    points[2].measured.y() += 0.002 * mean;
    EXPECT_FALSE(in_frame_of_net(net, points));
}

}  // namespace
