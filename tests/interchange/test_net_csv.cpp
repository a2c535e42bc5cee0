// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a column taken for another: JAX FDM's own files call their columns by several
// names, and give the form as displacements.

#include "taut/interchange/net_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace taut {
namespace {

using test::input_error_of;

const std::string node_table =
    "Knoten,x,y,6,is_free,u,v,w\n"
    "1,0,0,0,0,0,0,0\n"
    "2,1,0,0,67,0.25,0,-0.5\n"
    "B 3,2,0,0,0,0,0,0\n";
const std::string edge_table = "a,b,q0,qopt,f\n2,1,8,4,20\n2,B 3,8,5,20\n";

ImportedStructure csv_net(const std::string& of_nodes, const std::string& of_edges) {
    return parse_net_csv({.nodes = of_nodes, .edges = of_edges}, "n.csv", "e.csv");
}

TEST(ParseNetCsv, ReadsColumnsByPlaceAndByName) {
    const ImportedStructure net = csv_net(node_table, edge_table);
    ASSERT_EQ(net.nodes.size(), 3U);
    EXPECT_EQ(net.nodes[2].id, "B 3");
    EXPECT_TRUE(net.nodes[0].is_support);
    EXPECT_FALSE(net.nodes[1].is_support);
    ASSERT_EQ(net.edges.size(), 2U);
    EXPECT_EQ(net.edges[0].id, "1-2");
    EXPECT_EQ(net.edges[0].numbers.at("q"), 4.0) << "qopt before q0";
    EXPECT_EQ(net.edges[0].numbers.at("f"), 20.0);
}

TEST(ParseNetCsv, AddsDisplacementsAndSaysSo) {
    const ImportedStructure net = csv_net(node_table, edge_table);
    EXPECT_EQ(net.nodes[1].position, Eigen::Vector3d(1.25, 0, -0.5));
    EXPECT_THAT(net.notes, testing::ElementsAre(testing::HasSubstr("displacements")));
}

TEST(ParseNetCsv, ReadsLoadsNamesAndOtherSeparators) {
    const ImportedStructure net =
        csv_net("id;x;y;z;is_free;px;py;pz\nA;0;0;0;0;0;0;0\nB;1;0;0;1;1;2;3\n",
                "u\tv\tq\tid\nA\tB\t2\tfirst\n");
    EXPECT_EQ(net.nodes[1].load, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(net.edges[0].id, "first");
}

TEST(ParseNetCsv, RefusesWhatIsNoSuchPair) {
    const auto error = [](const std::string& of_nodes, const std::string& of_edges) {
        return input_error_of([&] { return csv_net(of_nodes, of_edges); });
    };
    EXPECT_EQ(error("", edge_table), "n.csv: is empty, expected a header and a line an item");
    EXPECT_EQ(error("id,x,y\n", edge_table), "n.csv:1: has 3 fields, expected at least 4");
    EXPECT_EQ(error("1,0,0,0\n", edge_table), "n.csv:1: holds numbers only, expected a header");
    EXPECT_EQ(error("id,x,y,z\n1,0,0\n", edge_table), "n.csv:2: has 3 fields, expected 4");
    EXPECT_EQ(error("id,x,y,z\n1,0,nan,0\n", edge_table),
              "n.csv:2: y is 'nan', expected a finite number");
    EXPECT_EQ(error("id,x,y,z\n,0,0,0\n", edge_table), "n.csv:2: has an empty id");
    EXPECT_EQ(error("id,x,y,z\n1,0,0,0\n1,1,0,0\n", edge_table),
              "n.csv:3: gives the node '1' a second time");
    EXPECT_EQ(error(node_table, "a,b,q\n1,9,1\n"),
              "e.csv:2: names the node '9', which is not in n.csv");
    EXPECT_EQ(error(node_table, "a,b,q\n1,1,1\n"), "e.csv:2: joins the node '1' to itself");
    EXPECT_EQ(error(node_table, "a,b,q\n1,2,1\n2,1,1\n"),
              "e.csv:3: joins the nodes '2' and '1' a second time");
    EXPECT_EQ(error(node_table, "a,b,q\n1,2,x\n"), "e.csv:2: q is 'x', expected a finite number");
}

}  // namespace
}  // namespace taut
