// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a surveyor's own numbers that are taken for nodes, and sound names that are not.

#include "survey/point_names.hpp"

#include <gtest/gtest.h>

#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

/// Points on all nodes, counted from `first`.
std::vector<SurveyPoint> numbered(const CableNet& net, int first) {
    std::vector<SurveyPoint> points;
    for (int node = 0; node < net.node_count(); ++node) {
        points.push_back({.id = std::to_string(first + node), .position = net.nodes().col(node)});
    }
    return points;
}

TEST(PointNames, ContradictPlacesWhereTheSurveyorCountsFromOne) {
    const CableNet net = hypar(4, 5);
    EXPECT_TRUE(names_contradict_places(net, numbered(net, 1)));
    EXPECT_FALSE(names_contradict_places(net, numbered(net, 0)));
    // Names that are no node's say nothing against places.
    EXPECT_FALSE(names_contradict_places(net, numbered(net, 1000)));
    EXPECT_FALSE(names_contradict_places(net, {}));
    std::vector<SurveyPoint> swapped = numbered(net, 0);
    std::swap(swapped[3].id, swapped[7].id);
    EXPECT_FALSE(names_contradict_places(net, swapped));
    std::vector<SurveyPoint> in_another_frame = numbered(net, 1);
    for (SurveyPoint& point : in_another_frame) {
        point.position.x() += 1000.0;
    }
    EXPECT_FALSE(names_contradict_places(net, in_another_frame));
}

TEST(PointNames, BecomeLabelsWhereTheyAreNoNodes) {
    const CableNet net = hypar(4, 5);
    std::vector<SurveyPoint> points{{.id = "3"}, {.id = "T3"}, {.id = ""}};
    EXPECT_EQ(make_names_labels(net, points, false), 1);
    EXPECT_EQ(points[0].id, "3");
    EXPECT_EQ(points[1].id, "");
    EXPECT_EQ(points[1].label, "T3");
    EXPECT_EQ(make_names_labels(net, points, true), 1);
    EXPECT_EQ(points[0].label, "3");
}

}  // namespace
}  // namespace taut
