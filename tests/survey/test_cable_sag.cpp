// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against tensions from sags that are wrong where a cable slopes, where its ends are not the
// targets, and where its points show no sag.

#include "taut/survey/cable_sag.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace taut;
using testing::HasSubstr;

constexpr double mass = 3.0;  // [kg/m]

/// A cable of 20 m that slopes from a support to the only free node, held by another.
CableNet sloping() {
    CableNetData data;
    data.nodes.resize(3, 3);
    data.nodes << 0.0, 16.0, 30.0, 0.0, 0.0, 0.0, 0.0, 12.0, 12.0;
    data.supports = {0, 2};
    data.edges = {{0, 1}, {1, 2}};
    data.axial_stiffness = Eigen::VectorXd::Constant(2, 2e7);
    data.unstressed_lengths = Eigen::Vector2d(19.99, 13.99);
    data.mass = Eigen::VectorXd::Constant(2, mass);
    return CableNet(std::move(data));
}

/// Points on the exact catenary through (0, 0, 0) and (16, 0, 12) whose horizontal tension is H.
std::vector<SagPoint> on_catenary(double H, int count, double std_dev, double offset = 0.0) {
    const double a = H / (mass * 9.80665);
    // z = a (cosh((x - c)/a) - cosh(c/a)), with c such that z(16) = 12.
    double low = -1e4, high = 1e4;
    const auto z_of = [a](double x, double c) {
        return 2.0 * a * std::sinh((x - 2.0 * c) / (2.0 * a)) * std::sinh(x / (2.0 * a));
    };
    while (high - low > 1e-9) {
        const double middle = 0.5 * (low + high);
        (z_of(16.0, middle) > 12.0 ? low : high) = middle;
    }
    std::vector<SagPoint> points;
    for (int k = 1; k <= count; ++k) {
        const double x = 16.0 * k / (count + 1);
        points.push_back(
            {.edge = 0, .position = {x, 0.0, z_of(x, low) + offset}, .std_dev = std_dev});
    }
    return points;
}

double middle_tension(double H) {
    return H / 0.8;  // the chord's slope: cos = 16/20
}

TEST(CableSag, TheTensionIsThatOfTheCatenary) {
    const CableNet net = sloping();
    for (const double H : {6e3, 12e3, 50e3}) {
        for (const double offset : {0.0, 0.03}) {  // the axis is 3 cm above the targets
            const auto found = tensions_by_sag(net, net.nodes(), on_catenary(H, 5, 1e-4, offset));
            ASSERT_EQ(found.size(), 1U);
            EXPECT_EQ(found[0].source, ForceSource::sag);
            EXPECT_NEAR(found[0].tension, middle_tension(H), 0.01 * middle_tension(H));
        }
    }
}

TEST(CableSag, ItsStandardDeviationIsThatOfItsError) {
    const CableNet net = sloping();
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, 2e-3);
    constexpr double H = 12e3;
    double squares = 0.0;
    constexpr int surveys = 200;
    for (int k = 0; k < surveys; ++k) {
        std::vector<SagPoint> points = on_catenary(H, 5, 2e-3);
        for (SagPoint& point : points) {
            point.position.z() += normal(random);
        }
        const ForceMeasurement found = tensions_by_sag(net, net.nodes(), points)[0];
        squares += std::pow((found.tension - middle_tension(H)) / found.std_dev, 2) / surveys;
    }
    EXPECT_NEAR(std::sqrt(squares), 0.8, 0.25);  // only z errs, of which cos(beta) is across
}

TEST(CableSag, WhatShowsNoTensionIsRefused) {
    const auto expect_refused = [](const std::vector<SagPoint>& points, const char* message) {
        const CableNet net = sloping();
        EXPECT_THAT([&] { static_cast<void>(tensions_by_sag(net, net.nodes(), points)); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
    };
    expect_refused(on_catenary(12e3, 2, 1e-3), "three or more");
    expect_refused(on_catenary(12e3, 5, 1.0), "too little for a tension");
    expect_refused(on_catenary(600.0, 5, 1e-3), "expected at most a twentieth");
    expect_refused(on_catenary(12e3, 5, 0.0), "expected a positive one");
    expect_refused(on_catenary(12e3, 5, 1e-3, 5.0), "not on the cable");
    std::vector<SagPoint> together = on_catenary(12e3, 5, 1e-3);
    for (SagPoint& point : together) {
        point.position = together.front().position;
    }
    expect_refused(together, "too close together");
}

}  // namespace
