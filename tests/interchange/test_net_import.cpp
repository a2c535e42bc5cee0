// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a net that behaves unlike the one its authors had: forces in the wrong unit,
// lengths that do not carry the tensions, loads that do not hold the form; and against guesses
// without a word.

#include "taut/interchange/net_import.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "support/errors.hpp"
#include "support/foreign_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

using nlohmann::json;
using test::input_error_of;
using test::old_compas_mesh;
using testing::Contains;
using testing::HasSubstr;
using Loads = ImportSettings::Loads;

constexpr double EA = 210e9 * std::numbers::pi * 1e-6;  ///< of the mesh's E and r [N]

ImportedNet import(const json& file, const ImportSettings& settings = {}) {
    return import_net(parse_compas(file.dump(), "net.json"), settings);
}

std::string error(const json& file, const ImportSettings& settings = {}) {
    return input_error_of([&] { return import(file, settings); });
}

/// The mesh with an l_0 that carries q = 2, 2, 2, 3 in kN/m.
json with_stored_lengths() {
    json file = old_compas_mesh();
    const double l = 1.5;
    for (const auto& [key, q] : std::map<std::string, double>{
             {"(4, 0)", 3.0}, {"(1, 4)", 2.0}, {"(2, 4)", 2.0}, {"(4, 3)", 2.0}}) {
        file["edgedata"][key]["l0"] = l / (1.0 + 1e3 * q * l / EA);
    }
    return file;
}

TEST(ImportNet, CutsEdgesSoThatTheyCarryTheFilesForceDensities) {
    const CableNet net = import(old_compas_mesh(), {.force_unit = 1e3}).net;
    EXPECT_EQ(net.free_node_count(), 1);
    EXPECT_EQ(net.edge_count(), 4);
    EXPECT_EQ(net.adjustable_edges().size(), 4U);
    EXPECT_EQ(net.node_id(4), "4");
    EXPECT_EQ(net.edge_id(0), "0-4");
    const Eigen::VectorXd expected = Eigen::Vector4d(3, 2, 2, 2) * 1e3 * 1.5;
    EXPECT_LT((tensions_of(net, net.unstressed_lengths(), net.nodes()) - expected).norm(), 1e-8);
    EXPECT_NEAR(net.axial_stiffness()(0), EA, 1e-9 * EA);
}

TEST(ImportNet, TakesARadiusByEitherName) {
    json file = old_compas_mesh();
    file["dea"].erase("r");
    file["dea"]["radius"] = 0.001;
    EXPECT_NEAR(import(file, {.force_unit = 1e3}).net.axial_stiffness()(0), EA, 1e-9 * EA);
}

TEST(ImportNet, TakesForcesForNewtonsAndSaysSoWhereNoUnitIsGiven) {
    const ImportedNet imported = import(old_compas_mesh());
    EXPECT_NEAR(
        tensions_of(imported.net, imported.net.unstressed_lengths(), imported.net.nodes())(1), 3.0,
        1e-6);
    EXPECT_THAT(imported.report.assumed, Contains(HasSubstr("forces of the file are in N")));
}

TEST(ImportNet, TakesForcesOverLengthsWhereThereAreNoForceDensities) {
    json file = old_compas_mesh();
    file["dea"].erase("q");
    file["edgedata"]["(4, 0)"].erase("q");
    file["dea"]["f"] = 3.0;
    const CableNet net = import(file).net;
    EXPECT_NEAR(tensions_of(net, net.unstressed_lengths(), net.nodes())(2), 3.0, 1e-6);
}

TEST(ImportNet, TakesStoredLengthsThatAgreeWithTheForcesAndFindsTheUnitByThem) {
    const ImportedNet imported = import(with_stored_lengths(), {.loads = Loads::balance});
    EXPECT_EQ(imported.net.unstressed_lengths()(0), 1.5 / (1.0 + 4500.0 / EA));
    EXPECT_THAT(imported.report.assumed, Contains(HasSubstr("forces of the file are in kN")));
    EXPECT_THAT(imported.report.read, Contains(HasSubstr("the file's l0")));
    EXPECT_TRUE(imported.report.warnings.empty());
}

TEST(ImportNet, NamesEndsThatOnlyBalancingLoadsHold) {
    json file = old_compas_mesh();
    file["vertex"]["0"]["is_anchor"] = false;
    const ImportedNet imported = import(file, {.loads = Loads::balance});
    EXPECT_THAT(imported.report.warnings,
                Contains(HasSubstr("only the loads of 'balance' hold node 0, where one cable ends: "
                                   "up to 4.5 N, together (-3, -3, -1.5) N.")));
}

TEST(ImportNet, LeavesStoredLengthsThatDoNotAgreeWithTheForcesAndSaysSo) {
    const ImportedNet imported = import(with_stored_lengths(), {.force_unit = 1.0});
    EXPECT_NEAR(imported.net.unstressed_lengths()(0), 1.5 / (1.0 + 4.5 / EA), 1e-12);
    EXPECT_THAT(imported.report.warnings, Contains(HasSubstr("l0 does not agree with q")));
}

/// 200 GPa up to 1 permille, flat up to 2, then 300 GPa.
StressStrain two_slopes() {
    return parse_stress_strain("strain,stress\n0,0\n0.001,2e8\n0.002,2e8\n0.012,3.2e9\n",
                               "law.csv");
}

TEST(ImportNet, TakesATableOfStressOverStrainTimesTheAreaOfEachEdge) {
    const ImportedNet imported =
        import(old_compas_mesh(), {.stress_strain = two_slopes(), .force_unit = 1e3});
    const CableNet& net = imported.net;
    const double area = EA / 210e9;
    ASSERT_NE(net.tension_law(0), nullptr);
    EXPECT_NEAR(net.tension_law(0)->at(0.001).tension, 2e8 * area, 1e-6);
    EXPECT_NEAR(net.axial_stiffness()(0), 3e11 * area, 1e-3);
    // 3 kN is above the flat part.
    EXPECT_NEAR(tensions_of(net, net.unstressed_lengths(), net.nodes())(1), 3000.0, 1e-6);
    EXPECT_NEAR(net.unstressed_lengths()(1), 1.5 / (1.0 + 0.002 + (3000.0 / area - 2e8) / 3e11),
                1e-12);
    EXPECT_THAT(imported.report.read, Contains(HasSubstr("stress over strain of 4 points")));
    EXPECT_THAT(imported.report.read, Contains(HasSubstr("l / (1 + strain at T)")));
}

TEST(ImportNet, TakesStoredLengthsThatAgreeWithATableOfStressOverStrain) {
    const CableNet found =
        import(old_compas_mesh(), {.stress_strain = two_slopes(), .force_unit = 1e3}).net;
    json file = with_stored_lengths();
    EXPECT_THAT(import(file, {.stress_strain = two_slopes(), .force_unit = 1e3}).report.warnings,
                Contains(HasSubstr("l0 does not agree with q and the tension laws")));
    const std::vector<std::string> keys{"(4, 0)", "(1, 4)", "(2, 4)", "(4, 3)"};
    for (size_t e = 0; e < keys.size(); ++e) {
        file["edgedata"][keys[e]]["l0"] = found.unstressed_lengths()(static_cast<Eigen::Index>(e));
    }
    const ImportedNet again = import(file, {.stress_strain = two_slopes(), .force_unit = 1e3});
    EXPECT_TRUE(again.net.unstressed_lengths().isApprox(found.unstressed_lengths(), 1e-15));
    EXPECT_THAT(again.report.read, Contains(HasSubstr("the file's l0, which agrees with its q")));
}

TEST(StressStrain, IsRefusedWithItsLine) {
    const auto message = [](const char* text) {
        return input_error_of([&] { return parse_stress_strain(text, "law.csv"); });
    };
    EXPECT_THAT(message("0,0\n0.001,2e8\n"),
                HasSubstr("law.csv:1: does not start with the header strain,stress"));
    EXPECT_THAT(message("strain,stress\n0,0\n0.001,200\n"), HasSubstr("are its stresses in Pa"));
    EXPECT_THAT(message("strain,stress\n0,0\n0.001,2e8\n0.002,1e8\n"), HasSubstr("falls from"));
    EXPECT_THAT(message("strain,stress\n0,0\n"), HasSubstr("two at least"));
}

TEST(ImportNet, BalancesTheGivenForm) {
    const ImportedNet imported = import(old_compas_mesh(), {.loads = Loads::balance});
    const CableNet& net = imported.net;
    EXPECT_LT(imported.report.largest_out_of_balance, 1e-9 * imported.report.mean_tension);
    // Node 4 is pulled to corner 0 by one more unit of q: (-1, -1, -0.5); and down by all: -0.5
    // * 8.
    EXPECT_LT((imported.report.load_sum - Eigen::Vector3d(1, 1, 4.5)).norm(), 1e-6);
    EXPECT_NEAR(imported.report.largest_horizontal_load, std::numbers::sqrt2, 1e-6);
    EXPECT_LT((solve_equilibrium(net).form - net.nodes()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ImportNet, TakesTheFilesLoadsOrNone) {
    EXPECT_EQ(import(old_compas_mesh(), {.force_unit = 1e3}).report.load_sum,
              Eigen::Vector3d(0, 0, -1500));
    EXPECT_EQ(import(old_compas_mesh(), {.loads = Loads::none}).report.load_sum,
              Eigen::Vector3d(0, 0, 0));
}

TEST(ImportNet, LeavesOutWhatIsNoPartOfTheNetAndCounts) {
    json file = old_compas_mesh();
    file["edgedata"].erase("(0, 1)");
    file["vertex"]["5"] = {{"x", 9}, {"y", 9}};
    file["vertex"]["6"] = {{"x", 9}, {"y", 9}, {"is_anchor", false}};
    const ImportReport report = import(file).report;
    EXPECT_EQ(report.inactive_edges, 3);
    EXPECT_EQ(report.edges_between_supports, 1);
    EXPECT_EQ(report.isolated_nodes, 2);
    EXPECT_THAT(report.left_out, Contains("1 edges between two supports"));
}

TEST(ImportNet, TakesTheStiffnessThatIsAskedFor) {
    EXPECT_EQ(import(old_compas_mesh(), {.axial_stiffness = 5e5}).net.axial_stiffness()(3), 5e5);
    EXPECT_NEAR(
        import(old_compas_mesh(), {.young = 200e9, .diameter = 0.002}).net.axial_stiffness()(3),
        200e9 * std::numbers::pi * 1e-6, 1e-6);
    json file = old_compas_mesh();
    file["dea"]["size"] = 8;
    const CableNet net = import(file, {.young = 200e9, .diameter_attribute = "size"}).net;
    EXPECT_NEAR(net.axial_stiffness()(0), 200e9 * std::numbers::pi * 9e-6, 1e-6);
    EXPECT_NEAR(net.axial_stiffness()(1), 200e9 * std::numbers::pi * 16e-6, 1e-6);
}

TEST(ImportNet, TakesEdgesInCompressionForStruts) {
    json file = old_compas_mesh();
    file["edgedata"]["(4, 0)"]["q"] = -1.0;
    const ImportedNet imported = import(file);
    const CableNet& net = imported.net;
    EXPECT_TRUE(net.is_strut(0));
    EXPECT_FALSE(net.is_strut(1));
    EXPECT_GT(net.unstressed_lengths()(0), edge_lengths(net, net.nodes())(0));
    EXPECT_THAT(imported.report.assumed, Contains("struts: the 1 edges in compression"));
    EXPECT_THAT(imported.report.warnings, testing::Not(Contains(HasSubstr("compression"))));
    // A cable by its mark is none that is pressed.
    file["edgedata"]["(4, 0)"]["is_strut"] = false;
    EXPECT_THAT(error(file), HasSubstr("edge 0-4 is in compression, but no strut by is_strut"));
    file["edgedata"]["(4, 0)"]["is_strut"] = true;
    EXPECT_THAT(import(file).report.read, Contains("struts: by is_strut"));
}

TEST(ImportNet, TellsPressedStrutsFromSlackCablesAndRoundingErrors) {
    json file = old_compas_mesh();
    file["edgedata"]["(4, 0)"]["q"] = -1e-13;
    EXPECT_FALSE(import(file).net.has_struts());
    // By their lengths alone.
    file = with_stored_lengths();
    file["dea"].erase("q");
    for (const auto& [key, edge] : file["edgedata"].items()) {
        edge.erase("q");
    }
    file["edgedata"]["(4, 0)"]["l0"] = 1.6;
    EXPECT_THAT(import(file).report.warnings, Contains(HasSubstr("1 edges are slack")));
    file["edgedata"]["(4, 0)"]["is_strut"] = true;
    EXPECT_THAT(import(file).report.warnings, testing::Not(Contains(HasSubstr("slack"))));
}

TEST(ImportNet, MakesStrutsOfBeams) {
    json file = old_compas_mesh();
    file["edgedata"]["(4, 0)"]["type"] = "beam";
    const ImportedNet imported = import(file);
    EXPECT_TRUE(imported.net.is_strut(0));
    EXPECT_THAT(imported.report.assumed,
                Contains("struts: the 1 edges of type beam or strut, which taut does not bend"));
}

TEST(ImportNet, LetsSupportsGiveWayInBalanceWithTheGivenForm) {
    json file = old_compas_mesh();
    file["vertex"]["0"]["support_stiffness"] = 2.0;
    const ImportedNet imported = import(file, {.force_unit = 1e3, .loads = Loads::balance});
    const CableNet& net = imported.net;
    ASSERT_EQ(net.elastic_supports().size(), 1U);
    EXPECT_EQ(net.elastic_supports()[0].stiffness, 2e3 * Eigen::Matrix3d::Identity());
    EXPECT_THAT(imported.report.assumed,
                Contains(HasSubstr("1 supports that give way stand in balance")));
    // The cable of q = 3 kN/m and 1.5 m pulls it.
    const Eigen::Vector3d shift = net.elastic_supports()[0].place - net.nodes().col(0);
    EXPECT_NEAR(shift.norm(), 3.0 * 1.5 / 2.0, 1e-12);
    EXPECT_NEAR(net.loads().col(0).norm(), 0.0, 1e-9);
    EXPECT_EQ(net.adjustable_edges().size(), 4U);

    file["vertex"]["0"]["support_place"] = {1.0, 2.0, 3.0};
    EXPECT_EQ(import(file).net.elastic_supports()[0].place, Eigen::Vector3d(1.0, 2.0, 3.0));
    file["vertex"]["0"]["support_stiffness"] = -2.0;
    EXPECT_THAT(error(file), HasSubstr("/vertex/0: node 0"));
    file["vertex"]["0"].erase("support_stiffness");
    EXPECT_THAT(error(file), HasSubstr("/vertex/0/support_place: is given without"));
}

TEST(ImportNet, RefusesRunsThatAreNoCable) {
    json file = json::parse(form_to_compas(sliding_ridge(), sliding_ridge().nodes()));
    const CableNet net = import(file).net;
    ASSERT_EQ(net.sliding_nodes().size(), sliding_ridge().sliding_nodes().size());
    // All runs that pass, and a number for a name.
    for (const auto& [key, node] : file["data"]["node"].items()) {
        node.erase("slides");
        node["slides"] = true;
    }
    EXPECT_GE(import(file).net.sliding_nodes().size(), net.sliding_nodes().size());
    json* in_run = nullptr;
    json* in_none = nullptr;
    for (const auto& [from, neighbours] : file["data"]["edge"].items()) {
        for (const auto& [to, edge] : neighbours.items()) {
            (edge.contains("run") ? in_run : in_none) = &edge;
        }
    }
    ASSERT_TRUE(in_run != nullptr && in_none != nullptr);
    const json friction = (*in_run)["friction"];
    (*in_run)["friction"] = 0.2;
    EXPECT_THAT(error(file), HasSubstr("has the friction 0.2, but an edge of the same run has"));
    (*in_run)["friction"] = friction;
    (*in_none)["run"] = (*in_run)["run"];
    EXPECT_THAT(error(file), HasSubstr("whose edges do not follow each other along one cable"));
}

TEST(ImportNet, AsksForTheSignOfForcesWhereMostEdgesAreInCompression) {
    json file = old_compas_mesh();
    file["dea"]["q"] = -1.0;
    file["edgedata"] = json::object();
    EXPECT_THAT(import(file, {.axial_stiffness = 1e4}).report.warnings,
                Contains(HasSubstr("Is a negative force tension in this file?")));
}

TEST(ImportNet, ReadsBackStrutsFromCompas) {
    const CableNet dome = cable_dome();
    const CableNet again =
        import_net(parse_compas(form_to_compas(dome, dome.nodes()), "dome.json"), {}).net;
    for (int e = 0; e < dome.edge_count(); ++e) {
        const int there = again.find_edge(dome.edge_id(e));
        EXPECT_EQ(again.is_strut(there), dome.is_strut(e));
        EXPECT_NEAR(again.unstressed_lengths()(there), dome.unstressed_lengths()(e), 1e-12);
    }
}

TEST(ImportNet, RefusesStrainsThatNoCableHas) {
    EXPECT_THAT(error(old_compas_mesh(), {.axial_stiffness = 44.0}),
                HasSubstr("edge 0-4 has a strain of 10.2 %, expected at most 10 %: check the "
                          "units"));
    json file = old_compas_mesh();
    file["dea"] = {{"EA", 1e3}, {"l0", 1500.0}};
    file["edgedata"].erase("(4, 0)");
    EXPECT_THAT(error(file), HasSubstr("has a strain of -99.9 %"));
}

TEST(ImportNet, RefusesWhatGivesNoStiffness) {
    json file = old_compas_mesh();
    file["dea"]["r"] = 0.0;
    EXPECT_THAT(error(file), HasSubstr("gives no axial stiffness"));
    EXPECT_THAT(error(old_compas_mesh(), {.young = 2e11, .diameter_attribute = "size"}),
                HasSubstr("edge 1-4 has no attribute 'size' that is a number"));
    file = old_compas_mesh();
    file["edgedata"]["(4, 0)"]["r"] = 0.0;
    EXPECT_THAT(error(file), HasSubstr("edge 0-4 has the axial stiffness 0 N"));
}

TEST(ImportNet, RefusesANetWithoutSupportsOrWithoutFreeNodes) {
    json file = old_compas_mesh();
    file["dva"]["is_anchor"] = false;
    EXPECT_THAT(error(file), HasSubstr("marks no supports"));
    file["dva"]["is_anchor"] = true;
    file["vertex"]["4"].erase("is_anchor");
    EXPECT_THAT(error(file), HasSubstr("joins supports only"));
}

TEST(ImportNet, ReportsABrokenRuleOfTheNetInTheNamesOfTheFile) {
    json file = old_compas_mesh();
    file["vertex"]["4"]["z"] = 0.0;
    file["vertex"]["4"]["x"] = 0.0;
    file["vertex"]["4"]["y"] = 0.0;
    EXPECT_THAT(error(file), HasSubstr("edge 0-4 has the length 0 m"));
    file = old_compas_mesh();
    file["vertex"].update({{"20", {{"x", 5}, {"y", 0}, {"is_anchor", false}}},
                           {"21", {{"x", 6}, {"y", 0}, {"is_anchor", false}}},
                           {"22", {{"x", 6}, {"y", 1}, {"is_anchor", false}}}});
    file["face"]["11"] = {20, 21, 22};
    EXPECT_EQ(error(file),
              "net.json:/vertex/20: node 20 is a free node in a part of the net that "
              "reaches no support");
}

TEST(ImportNet, SaysThatAFileWithoutForcesGivesANetWithoutTension) {
    json file = old_compas_mesh();
    file["dea"]["q"] = 0.0;
    file["edgedata"]["(4, 0)"]["q"] = 0.0;
    const ImportedNet imported = import(file);
    EXPECT_THAT(imported.report.warnings, Contains(HasSubstr("the file gives no forces")));
    EXPECT_DOUBLE_EQ(imported.net.unstressed_lengths()(0), 1.5);
}

TEST(ImportNet, RefusesSettingsThatExcludeEachOtherOrAreNotPositive) {
    for (const ImportSettings& settings :
         {ImportSettings{.axial_stiffness = 0.0}, ImportSettings{.axial_stiffness = -1.0},
          ImportSettings{.young = 2e11}, ImportSettings{.diameter = 0.008},
          ImportSettings{.young = -2e11, .diameter = 0.008},
          ImportSettings{.axial_stiffness = 1e5, .young = 2e11, .diameter = 0.008},
          ImportSettings{.young = 2e11, .diameter = 0.008, .diameter_attribute = "size"},
          ImportSettings{.young = 2e11, .stress_strain = two_slopes()},
          ImportSettings{.force_unit = 0.0}}) {
        EXPECT_THROW(static_cast<void>(import(old_compas_mesh(), settings)), std::invalid_argument);
    }
}

TEST(SupportNamed, MarksTheNodesOfAListAndRefusesAName) {
    json file = old_compas_mesh();
    file["dva"]["is_anchor"] = false;
    ImportedStructure net = parse_compas(file.dump(), "net.json");
    support_named(net, "# corners\n0, 1;2\n3 # the last\n", "supports.txt");
    EXPECT_TRUE(net.nodes[0].is_support && net.nodes[3].is_support);
    EXPECT_FALSE(net.nodes[4].is_support);
    EXPECT_EQ(input_error_of([&] {
                  support_named(net, "0\n9\n", "supports.txt");
                  return 0;
              }),
              "supports.txt:2: '9' is no node of net.json");
    EXPECT_EQ(input_error_of([&] {
                  support_named(net, "# none\n", "supports.txt");
                  return 0;
              }),
              "supports.txt: names no node, expected the supports");
}

/// A cross of two cables of three edges each, r and s, and a ring of three.
ImportedStructure crossing_cables() {
    ImportedStructure structure{.file = "net.json", .format = "test"};
    const auto add = [&](const char* id, double x, double y, bool is_support) {
        structure.nodes.push_back(
            {.id = id, .position = Eigen::Vector3d(x, y, 0.0), .is_support = is_support});
    };
    add("a", -2, 0, true);
    add("b", -1, 0, false);
    add("c", 1, 0.1, false);
    add("d", 2, 0, true);
    add("e", -1, -2, true);
    add("f", 1, 2, true);
    for (const auto& [id, s, t] : {std::tuple("r_2", 1, 2),
                                   {"r_1", 0, 1},
                                   {"r_3", 2, 3},
                                   {"s.1", 4, 1},
                                   {"s.2", 2, 5},
                                   {"tie", 1, 5}}) {
        structure.edges.push_back({.id = id, .s = s, .t = t, .numbers = {{"f", 10.0}}});
    }
    return structure;
}

TEST(ImportNet, FindsCablesThatSlideByNamesAndAsTheyGoStraightOn) {
    const ImportedStructure structure = crossing_cables();
    ImportSettings settings{.axial_stiffness = 1e4};
    const ImportedNet clamped = import_net(structure, settings);
    EXPECT_TRUE(clamped.net.sliding_nodes().empty());
    EXPECT_THAT(clamped.report.assumed,
                Contains(HasSubstr("though 1 go on by their names, and 1 straight on")));
    settings.slides = parse_slides("names");
    const ImportedNet named = import_net(structure, settings);
    ASSERT_EQ(named.net.data().runs.size(), 1U);  // the edges of s do not meet
    const CableRun& run = named.net.data().runs[0];
    EXPECT_EQ(run.name, "r");
    EXPECT_THAT(run.edges, testing::ElementsAre(1, 0, 2));
    EXPECT_THAT(run.slides_at, testing::ElementsAre(1, 2));
    EXPECT_FALSE(run.friction);
    settings.slides = parse_slides("straight");
    EXPECT_EQ(import_net(structure, settings).net.sliding_nodes().size(), 2U);
    EXPECT_THAT([] { (void)parse_slides("all"); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("expected 'names'")));
    ImportedStructure other = structure;
    for (size_t e = 0; e < other.edges.size(); ++e) {  // names of edges that have none are no names
        other.edges[e].id = e < 2 ? fmt::format("{}-{}", other.nodes[other.edges[e].s].id,
                                                other.nodes[other.edges[e].t].id)
                                  : other.edges[e].id + "x";
    }
    settings.slides = ImportSettings::Slides::names;
    EXPECT_THAT(input_error_of([&] { return import_net(other, settings); }),
                HasSubstr("names no cable that slides"));
    // Tensions that do not balance where it slides.
    other = structure;
    other.edges[0].numbers["f"] = 13.0;
    EXPECT_THAT(import_net(other, settings).report.warnings, Contains(HasSubstr("1.3 times")));
}

}  // namespace
}  // namespace taut
