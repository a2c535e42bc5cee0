// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against points of a surface that are not the nearest, and against normals that jump, or
// cancel out, where faces meet.
#include "taut/adjustment/target_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random_nets.hpp"
#include "support/refusals.hpp"

namespace taut {
namespace {

/// The height z over a grid of points, two triangles a cell, every other one turned over.
template <typename Height>
TargetSurface surface_of(int cells, const Height& z) {
    Points vertices(3, (cells + 1) * (cells + 1));
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            const double x = i / static_cast<double>(cells);
            const double y = j / static_cast<double>(cells);
            const int at = i * (cells + 1) + j;
            vertices.col(at) << x, y, z(x, y);
            if (i < cells && j < cells) {
                triangles.push_back({at, at + cells + 1, at + cells + 2});
                triangles.push_back({at, at + 1, at + cells + 2});
            }
        }
    }
    return {vertices, triangles};
}

double saddle(double x, double y) {
    return 0.3 * x * y;
}

TEST(TargetSurface, FindsTheNearestOfAllPoints) {
    const TargetSurface surface = surface_of(12, saddle);
    test::Random random(3);
    std::uniform_real_distribution<double> place(-0.2, 1.2);
    for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d point(place(random), place(random), place(random));
        const SurfacePoint nearest = surface.nearest(point);
        EXPECT_NEAR((nearest.place - point).norm(), nearest.distance, 1e-12);
        EXPECT_NEAR(nearest.normal.norm(), 1.0, 1e-12);
        // It is on the surface: on a triangle of the saddle, at most 0.3 / 144 / 8 off it.
        EXPECT_NEAR(nearest.place.z(), saddle(nearest.place.x(), nearest.place.y()), 6e-4);
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k <= 60 * 60; ++k) {
            const double x = (k / 61) / 59.0;
            const double y = (k % 61) / 60.0;
            least = std::min(least, (Eigen::Vector3d(x, y, saddle(x, y)) - point).norm());
        }
        EXPECT_LT(nearest.distance, least + 6e-4);
    }
}

TEST(TargetSurface, HasADistanceWhoseGradientIsItsNormal) {
    const TargetSurface surface = surface_of(5, saddle);
    test::Random random(4);
    std::uniform_real_distribution<double> inside(0.1, 0.9);
    std::uniform_real_distribution<double> height(-0.02, 0.02);
    constexpr double step = 1e-7;
    for (int i = 0; i < 200; ++i) {
        const double x = inside(random);
        const double y = inside(random);
        const Eigen::Vector3d point(x, y, saddle(x, y) + height(random));
        const SurfacePoint here = surface.nearest(point);
        const Eigen::Vector3d away = point - here.place;
        EXPECT_NEAR(std::abs(here.normal.dot(away)), here.distance, 1e-9);
        EXPECT_EQ(here.beyond_border, 0.0);
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d moved = point + step * Eigen::Vector3d::Unit(k);
            const double rate =
                (std::pow(surface.nearest(moved).distance, 2) - std::pow(here.distance, 2)) / step;
            EXPECT_NEAR(rate, 2.0 * here.normal.dot(away) * here.normal(k), 1e-6);
        }
    }
}

TEST(TargetSurface, HasTheMeanNormalOfItsFacesWhereTheyMeetWhicheverWayTheseAreTurned) {
    Points corners(3, 4);
    corners << 0.0, 0.0, 1.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -0.5, -0.5;
    const TargetSurface roof(corners, {{0, 1, 2}, {0, 1, 3}});
    const SurfacePoint ridge = roof.nearest({0.0, 0.5, 0.0});
    EXPECT_NEAR(std::abs(ridge.normal.z()), 1.0, 1e-12);
    const SurfacePoint above = roof.nearest({0.01, 0.5, 0.1});
    EXPECT_NEAR((above.normal - Eigen::Vector3d(0.01, 0.0, 0.1).normalized()).norm(), 0.0, 1e-12);
}

TEST(TargetSurface, GoesOnBehindItsBorderAsItIsThere) {
    const TargetSurface flat = surface_of(4, [](double, double) { return 0.0; });
    const SurfacePoint out = flat.nearest({1.2, 0.4, 0.05});
    EXPECT_NEAR(std::abs(out.normal.z()), 1.0, 1e-12);
    EXPECT_NEAR(out.beyond_border, 0.2, 1e-12);
    EXPECT_NEAR(out.distance, std::hypot(0.2, 0.05), 1e-12);
}

TEST(TargetSurface, JoinsVerticesAtOnePlaceAndLeavesOutWhatHasNoArea) {
    // Two triangles of a square with vertices of their own, and three without area.
    Points vertices(3, 7);
    vertices << 0, 1, 1, 0, 1, 0, 2, 0, 0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0;
    const TargetSurface square(vertices, {{0, 1, 2}, {3, 4, 5}, {0, 1, 1}, {0, 3, 1}, {0, 1, 6}});
    EXPECT_EQ(square.triangle_count(), 2);
    EXPECT_EQ(square.left_out(), 3);
    // The diagonal is no border.
    EXPECT_EQ(square.nearest({0.5, 0.5, 0.3}).beyond_border, 0.0);
    EXPECT_NEAR(square.nearest({0.5, 0.5, 0.3}).distance, 0.3, 1e-15);
}

TEST(TargetSurface, RefusesWhatIsNoSurface) {
    Points vertices = Points::Random(3, 3);
    const auto refused = [&](const std::vector<std::array<int, 3>>& triangles, const char* text) {
        test::expect_refused([&] { return TargetSurface(vertices, triangles); }, text);
    };
    refused({}, "no triangle");
    refused({{0, 1, 3}}, "vertex 3 of 3");
    refused({{0, 1, -1}}, "vertex -1 of 3");
    refused({{0, 1, 1}}, "has an area");
    vertices(1, 2) = std::numeric_limits<double>::quiet_NaN();
    refused({{0, 1, 2}}, "vertex 2");
}

}  // namespace
}  // namespace taut
