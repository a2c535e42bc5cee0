// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a net that is not the one in the file: an attribute missed because its edge is
// named the other way round, a border taken for a cable, a default forgotten, the wrong one of two
// meshes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/foreign_nets.hpp"
#include "taut/interchange/compas_json.hpp"

namespace taut {
namespace {

using nlohmann::json;
using test::edge_named;
using test::input_error_of;
using test::new_compas_graph;
using test::old_compas_mesh;

ImportedStructure compas_net(const json& file, const std::string& select = "") {
    return parse_compas(file.dump(), "net.json", select);
}

std::vector<std::string> ids_of(const auto& items) {
    std::vector<std::string> ids;
    for (const auto& item : items) {
        ids.push_back(item.id);
    }
    return ids;
}

TEST(ParseCompas, TakesTheSidesOfFacesThatAreEdges) {
    const ImportedStructure net = compas_net(old_compas_mesh());
    EXPECT_EQ(net.format, "COMPAS mesh");
    EXPECT_EQ(net.name, "tent");
    EXPECT_THAT(ids_of(net.nodes), testing::ElementsAre("0", "1", "2", "3", "4"));
    EXPECT_THAT(ids_of(net.edges), testing::ElementsAre("0-4", "1-4", "2-4", "3-4"));
    EXPECT_EQ(net.inactive_edges, 4);
}

TEST(ParseCompas, TakesDefaultsWhereANodeOrEdgeSaysNothing) {
    const ImportedStructure net = compas_net(old_compas_mesh());
    EXPECT_EQ(net.nodes[1].position, Eigen::Vector3d(2, 0, 0));
    EXPECT_EQ(net.nodes[4].position, Eigen::Vector3d(1, 1, 0.5));
    EXPECT_EQ(net.nodes[4].load, Eigen::Vector3d(0, 0, -1.5));
    EXPECT_TRUE(net.nodes[1].is_support);
    EXPECT_FALSE(net.nodes[4].is_support);
    EXPECT_EQ(edge_named(net, "1-4").numbers.at("q"), 2.0);
}

TEST(ParseCompas, FindsAttributesOfAnEdgeUnderBothItsNames) {
    const ImportedEdge edge = edge_named(compas_net(old_compas_mesh()), "0-4");
    EXPECT_EQ(edge.numbers.at("q"), 3.0);
    EXPECT_EQ(edge.numbers.at("size"), 6.0) << "text that is a number";
    EXPECT_FALSE(edge.numbers.contains("is_edge") && edge.numbers.at("is_edge") == 0.0);
}

TEST(ParseCompas, TakesTheNamesOfLaterCableMeshes) {
    json file = old_compas_mesh();
    file["dea"]["_is_edge"] = true;
    file["edgedata"]["(4, 3)"]["_is_edge"] = false;
    file["edgedata"]["(4, 0)"]["radius"] = 0.002;
    const ImportedStructure net = compas_net(file);
    EXPECT_THAT(ids_of(net.edges), testing::ElementsAre("0-4", "1-4", "2-4"));
    EXPECT_EQ(net.inactive_edges, 5);
    EXPECT_EQ(edge_named(net, "0-4").numbers.at("radius"), 0.002);
}

TEST(ParseCompas, NotesASelfWeightWhereAVertexHasAThickness) {
    json file = old_compas_mesh();
    file["attributes"]["density"] = 14;
    file["dva"]["thickness"] = 0.0;
    EXPECT_THAT(compas_net(file).notes, testing::IsEmpty());
    const auto is_noted =
        testing::ElementsAre("self-weight (density 14): not among the file's loads");
    file["vertex"]["4"]["thickness"] = 0.05;
    EXPECT_THAT(compas_net(file).notes, is_noted);
    file["dva"] = {{"z", 0.0}, {"t", 0.05}};
    file["vertex"]["4"].erase("thickness");
    EXPECT_THAT(compas_net(file).notes, is_noted);
}

TEST(ParseCompas, RefusesTwoNamesOfAnEdgeThatContradictEachOther) {
    json file = old_compas_mesh();
    file["edgedata"]["(0, 4)"]["q"] = 2.5;
    EXPECT_EQ(input_error_of([&] { return compas_net(file); }),
              "net.json:/edgedata/(4, 0)/q: contradicts /edgedata/(0, 4)/q, where the same edge "
              "has 2.5");
}

TEST(ParseCompas, LeavesOutEntriesOfEdgedataThatAreNoEdgesAndSaysSo) {
    json file = old_compas_mesh();
    file["edgedata"]["(0, 2)"] = {{"q", 1.0}};
    file["edgedata"]["(4, 77)"] = {{"q", 1.0}};
    EXPECT_THAT(compas_net(file).notes,
                testing::ElementsAre("2 entries of edgedata that are no edges"));
}

TEST(ParseCompas, KnowsTheBoundaryOfAMesh) {
    json file = old_compas_mesh();
    file["dva"]["is_anchor"] = false;
    ImportedStructure net = compas_net(file);
    support_boundary(net);
    std::vector<bool> supports;
    for (const ImportedNode& node : net.nodes) {
        supports.push_back(node.is_support);
    }
    EXPECT_THAT(supports, testing::ElementsAre(true, true, true, true, false));
}

TEST(ParseCompas, ReadsAGraphOfTodayWithTextForKeys) {
    const ImportedStructure net = compas_net(new_compas_graph());
    EXPECT_EQ(net.format, "COMPAS network");
    EXPECT_THAT(ids_of(net.nodes), testing::ElementsAre("A", "B", "C"));
    EXPECT_THAT(ids_of(net.edges), testing::ElementsAre("A-B", "right"));
    EXPECT_TRUE(net.nodes[0].is_support);
    EXPECT_EQ(net.edges[1].numbers.at("q"), 5.0);
}

TEST(ParseCompas, TakesNumbersForKeysInTheirOrder) {
    json file = old_compas_mesh();
    file["vertex"]["10"] = {{"x", 9}, {"y", 9}};
    EXPECT_THAT(ids_of(compas_net(file).nodes),
                testing::ElementsAre("0", "1", "2", "3", "4", "10"));
}

TEST(ParseCompas, NamesNodesByTheirNamesWhereEachHasOne) {
    json file = new_compas_graph();
    file["data"]["node"]["'A'"]["name"] = "left";
    EXPECT_EQ(compas_net(file).nodes[0].id, "A");
    file["data"]["node"]["'B'"]["name"] = "middle";
    file["data"]["node"]["'C'"]["name"] = "right";
    EXPECT_THAT(ids_of(compas_net(file).nodes), testing::ElementsAre("left", "middle", "right"));
}

TEST(ParseCompas, KnowsTheProgramByItsDtype) {
    json file = new_compas_graph();
    file["dtype"] = "jax_fdm.datastructures/FDNetwork";
    EXPECT_EQ(compas_net(file).format, "JAX FDM network");
}

TEST(ParseCompas, FindsTheOnlyStructureWhereverItStands) {
    const json file{{"settings", {{"a", 1}}}, {"session", {{"cablenet", old_compas_mesh()}}}};
    EXPECT_EQ(compas_net(file).format, "COMPAS mesh at the key 'session/cablenet'");
    EXPECT_EQ(compas_net(json::array({new_compas_graph()})).format,
              "COMPAS network at the key '0'");
}

TEST(ParseCompas, AsksWhichOneWhereThereAreMore) {
    const json file{{"a", old_compas_mesh()}, {"b", new_compas_graph()}};
    EXPECT_EQ(input_error_of([&] { return compas_net(file); }),
              "net.json: holds 2 meshes or networks ('a', 'b'): select one of them");
    EXPECT_EQ(compas_net(file, "b").format, "COMPAS network at the key 'b'");
    EXPECT_EQ(input_error_of([&] { return compas_net(file, "c"); }),
              "net.json: holds no meshes or networks named 'c', expected one of 'a', 'b'");
}

TEST(ParseCompas, KnowsTheUnitOfTheFile) {
    json file = new_compas_graph();
    file["data"]["attributes"]["force_unit"] = "kN";
    EXPECT_EQ(compas_net(file).force_unit, 1000.0);
}

TEST(ParseCompas, RefusesOtherValuesAtTheirJsonPointer) {
    test::expect_refused("net.json", old_compas_mesh(), R"(
 | 3 | is 3, expected an object that holds a mesh or a network...
 | {"a": 1} | holds no mesh or network...
/face/7 | [0, 1] | has 2 vertices, expected at least 3...
/face/7 | [0, 0, 4] | /face/7/1: names the same vertex as the one before it...
/face/7/1 | 99 | names the vertex '99', which is not in the file...
/vertex/4/x | "1" | is the text '1', expected a number...
/vertex/4/is_anchor | "no" | is the text 'no', expected true or false...
/edgedata/(4, 0)/q | "2" | is the text '2', expected a number...
/edgedata/edge | {} | is no edge...
/attributes/force_unit | "lbf" | is no unit of force...
/attributes/length_unit | "mm" | is another unit of length...
)",
                         [](const std::string& mesh) { return parse_compas(mesh, "net.json"); });
}

TEST(ParseCompas, RefusesAnEdgeListThatIsWrong) {
    json file = new_compas_graph();
    file["data"]["edge"]["'A'"] = {{"'X'", json::object()}};
    EXPECT_EQ(input_error_of([&] { return compas_net(file); }),
              "net.json:/data/edge/'A'/'X': names the vertex 'X', which is not in the file");
    file["data"]["edge"]["'A'"] = {{"'A'", json::object()}};
    EXPECT_EQ(input_error_of([&] { return compas_net(file); }),
              "net.json:/data/edge/'A'/'A': joins a node to itself");
    file["data"]["edge"]["'A'"] = 5;
    EXPECT_EQ(input_error_of([&] { return compas_net(file); }),
              "net.json:/data/edge/'A': is 5, expected an object of neighbours");
}

}  // namespace
}  // namespace taut
