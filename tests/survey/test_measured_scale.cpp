// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a survey in a map grid, or by an instrument of wrong scale: a twentieth of a per
// cent is more than a steel cable stretches, and it would all go into the lengths.

#include "survey/measured_scale.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The supports of the built-in net, or the first so many, in a frame of another scale.
std::vector<ControlPoint> control_points(double scale, double noise, unsigned seed = 1,
                                         int count = 128) {
    const CableNet net = hilo_quarter();
    const RigidMotion motion{
        .rotation = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized().toRotationMatrix(),
        .to = {2.6e3, 1.2e3, 400.0}};
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<ControlPoint> points;
    const int step = 128 / count;
    for (int i = 0; i < count; ++i) {
        const int node = net.supports()[step * i];
        const Eigen::Vector3d error =
            noise * Eigen::Vector3d(normal(random), normal(random), normal(random));
        points.push_back({.id = net.node_id(node),
                          .known = net.nodes().col(node),
                          .measured = scale * motion(net.nodes().col(node)) + error});
    }
    return points;
}

TEST(MeasuredScale, IsFoundInAnyFrame) {
    for (const double scale : {0.9996, 1.0, 1.0005}) {
        const auto found = measured_scale(control_points(scale, 0.0));
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->scale, scale, 1e-10);
        EXPECT_LT(found->std_dev, 1e-9);
        EXPECT_EQ(found->redundancy, 3 * 128 - 7);
    }
}

TEST(MeasuredScale, HasTheStandardErrorThatItGives) {
    constexpr int surveys = 400;
    double squares = 0.0;
    for (int seed = 0; seed < surveys; ++seed) {
        const auto found = measured_scale(control_points(1.0002, 1e-3, seed, 16));
        squares += std::pow((found->scale - 1.0002) / found->std_dev, 2);
    }
    // A chi-squared of so many surveys, its spread 7 %, and Student's t of 41: 2.5 % wider.
    EXPECT_NEAR(squares / surveys, 1.05, 0.25);
}

TEST(MeasuredScale, IsNotThereWhereThePointsDetermineNoFrame) {
    EXPECT_FALSE(measured_scale(control_points(1.0, 0.0, 1, 2)));
    EXPECT_FALSE(measured_scale(control_points(1.5, 0.0)));
}

TEST(ScaleWarnings, NameATwentiethOfAPerCentAndNoLess) {
    EXPECT_THAT(scale_warnings(control_points(1.0005, 0.5e-3)),
                ElementsAre(AllOf(HasSubstr("128 supports or control points"),
                                  HasSubstr(" times as far apart"), HasSubstr("map grid"))));
    EXPECT_THAT(scale_warnings(control_points(0.9996, 0.0)),
                ElementsAre(HasSubstr("measured 0.9996 times as far apart")));
    EXPECT_THAT(scale_warnings(control_points(1.00009, 0.0)), IsEmpty());
}

TEST(ScaleWarnings, RaiseHardlyAnAlarmWhereTheScaleIsRight) {
    // Off by more than 1e-4 in most of these, with 4 points and 3 mm; significant in one of 1000.
    int alarms = 0;
    int off = 0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        const auto points = control_points(1.0, 3e-3, seed, 4);
        alarms += static_cast<int>(scale_warnings(points).size());
        off += std::abs(measured_scale(points)->scale - 1.0) > 1e-4 ? 1 : 0;
    }
    EXPECT_GT(off, 800);
    EXPECT_LE(alarms, 5);
}

}  // namespace
