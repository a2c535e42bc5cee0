// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against edges between the wrong vertices (OBJ counts from 1, or from the end), and against
// a line that is passed over without a word.

#include "taut/interchange/obj.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"

namespace taut {
namespace {

using test::input_error_of;

ImportedStructure obj_net(const std::string& text) {
    return parse_obj(text, "net.obj");
}

std::vector<std::string> edges_of(const ImportedStructure& structure) {
    std::vector<std::string> ids;
    for (const ImportedEdge& edge : structure.edges) {
        ids.push_back(edge.id);
    }
    return ids;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5 # high\n";

TEST(ParseObj, ReadsVerticesAndLines) {
    const ImportedStructure net = obj_net("# a net\r\n" + square + "o net\nl 1 2 3\r\nl -1 1\n");
    ASSERT_EQ(net.nodes.size(), 4U);
    EXPECT_EQ(net.nodes[3].id, "4");
    EXPECT_EQ(net.nodes[3].position, Eigen::Vector3d(0, 1, 0.5));
    EXPECT_THAT(edges_of(net), testing::ElementsAre("1-2", "1-4", "2-3"));
    EXPECT_EQ(net.edges[1].place, "8");
}

TEST(ParseObj, ReadsFacesEachSideOnceAndKnowsTheirBoundary) {
    const ImportedStructure net =
        obj_net(square + "v 0.5 0.5 1\nf 1/1 2/2/2 5//3\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    EXPECT_EQ(net.edges.size(), 8U);
    for (size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(net.nodes[i].is_boundary, i < 4) << i;
    }
}

TEST(ParseObj, TakesTheEndsOfLinesForTheBoundaryWhereThereAreNoFaces) {
    const ImportedStructure net = obj_net(square + "l 1 2 3\n");
    EXPECT_TRUE(net.nodes[0].is_boundary && net.nodes[2].is_boundary);
    EXPECT_FALSE(net.nodes[1].is_boundary || net.nodes[3].is_boundary);
}

TEST(ParseObj, TakesThePointsOfTheGroupSupports) {
    const ImportedStructure net = obj_net(square + "l 1 2 3\ng other\np 2\ng supports\np 1 3\n");
    EXPECT_TRUE(net.nodes[0].is_support && net.nodes[2].is_support);
    EXPECT_FALSE(net.nodes[1].is_support);
}

TEST(ParseObj, RefusesOtherLinesWithTheirNumber) {
    test::expect_refused(
        "net.obj:5",
        {{"curv 1 2", ": starts with 'curv', expected v, l, f or another keyword of OBJ"},
         {"v 1 2", ": has 2 coordinates, expected 3"},
         {"v 1 nan 2", ": y is 'nan', expected a finite number"},
         {"f 1 2", ": has 2 vertices, expected at least 3"},
         {"l 0 1", ": names the vertex '0', expected 1 to 4, or -1 to -4 from the end"},
         {"l 1 5", ": names the vertex '5', expected 1 to 4, or -1 to -4 from the end"},
         {"l 2 2", ": names the vertex 2 twice in a row"}},
        [](const std::string& line) { return obj_net(square + line + "\n"); });
}

TEST(ParseObj, RefusesWhatHoldsNoVertex) {
    EXPECT_EQ(input_error_of([] { return obj_net("# nothing\n"); }),
              "net.obj: holds no vertex, expected lines v x y z");
    EXPECT_EQ(input_error_of([] { return obj_net(std::string("v 0 0 0\n\0", 9)); }),
              "net.obj:2: holds a zero byte, expected text");
}

}  // namespace
}  // namespace taut
