// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a net that changes on its way out and back, and against a file that other programs
// cannot open: what COMPAS and meshio see in these files, tests/data/check_exports.py compares.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "support/examples.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/interchange/form_vtk.hpp"
#include "taut/interchange/net_csv.hpp"
#include "taut/interchange/net_import.hpp"
#include "taut/interchange/obj.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// A net in its equilibrium form, with names, loads, several stiffnesses, an adjustable interior
/// edge and an edge that is slack.
CableNet net_with_everything() {
    CableNetData data = test::example_net().net.data();
    data.axial_stiffness(2) *= 1.5;
    data.unstressed_lengths(1) *= 1.3;
    data.adjustable.pop_back();
    const CableNet net(data);
    data.nodes = solve_equilibrium(net).form;
    return CableNet(std::move(data));
}

CableNet import(const ImportedStructure& structure) {
    return import_net(structure, {.force_unit = 1.0}).net;
}

/// The edges with the same two nodes have the same numbers and names.
void expect_same(const CableNet& found, const CableNet& net) {
    ASSERT_EQ(found.data().node_ids, net.data().node_ids);
    ASSERT_EQ(found.edge_count(), net.edge_count());
    EXPECT_EQ(found.nodes(), net.nodes());
    EXPECT_EQ(found.loads(), net.loads());
    std::vector<int> supports = net.supports();
    std::ranges::sort(supports);
    EXPECT_EQ(found.supports(), supports);
    using Attributes = std::tuple<std::string, double, double, bool>;
    const auto by_ends = [](const CableNet& of) {
        std::map<std::pair<int, int>, Attributes> edges;
        for (int e = 0; e < of.edge_count(); ++e) {
            const auto [s, t] = of.edges()[e];
            const auto& adjustable = of.adjustable_edges();
            edges[std::minmax(s, t)] = {of.edge_id(e), of.axial_stiffness()(e),
                                        of.unstressed_lengths()(e),
                                        std::ranges::find(adjustable, e) != adjustable.end()};
        }
        return edges;
    };
    EXPECT_EQ(by_ends(found), by_ends(net));
}

TEST(Exports, ToCompasComeBackToTheLastBit) {
    const CableNet net = net_with_everything();
    ASSERT_FALSE(slack_edges(net, net.unstressed_lengths(), net.nodes()).empty());
    const ImportedNet back =
        import_net(parse_compas(form_to_compas(net, net.nodes()), "net.json"), {});
    expect_same(back.net, net);
    EXPECT_EQ(back.net.name(), net.name());
    EXPECT_THAT(back.report.assumed, testing::Contains("coordinates are in m"));
}

TEST(Exports, ToCsvComeBackToTheLastBit) {
    const CableNet net = net_with_everything();
    expect_same(import(parse_net_csv(form_to_net_csv(net, net.nodes()), "n.csv", "e.csv")), net);
}

/// A ridge that slides with friction, on supports of which two give way, with cables that sag.
CableNet net_as_built() {
    CableNetData data = sliding_ridge().data();
    data.runs[0].friction = 0.07;
    data.sag_weight = Eigen::VectorXd::Constant(std::ssize(data.edges), 4.0);
    data.sag_weight(3) = 0.0;
    Eigen::Matrix3d stiffness = 2e5 * Eigen::Matrix3d::Identity();
    stiffness(0, 1) = stiffness(1, 0) = 3e4;
    for (int k = 0; k < 2; ++k) {
        const int node = data.supports.back();
        data.supports.pop_back();
        data.elastic_supports.push_back(
            {.node = node, .stiffness = (1.0 + k) * stiffness, .place = data.nodes.col(node)});
    }
    const Equilibrium equilibrium = solve_equilibrium(CableNet(data));
    EXPECT_TRUE(equilibrium.balanced());
    data.nodes = equilibrium.form;
    data.unstressed_lengths = equilibrium.unstressed_lengths;
    return CableNet(std::move(data));
}

/// Supports, sag and runs are the same, of edges by their names.
void expect_as_built(const CableNet& found, const CableNet& net) {
    ASSERT_EQ(found.elastic_supports().size(), net.elastic_supports().size());
    for (const ElasticSupport& support : net.elastic_supports()) {
        const int node = found.find_node(net.node_id(support.node));
        const auto same = std::ranges::find(found.elastic_supports(), node, &ElasticSupport::node);
        ASSERT_NE(same, found.elastic_supports().end());
        EXPECT_EQ(same->stiffness, support.stiffness);
        EXPECT_EQ(same->place, support.place);
    }
    const Eigen::VectorXd expected = tensions_of(net, net.unstressed_lengths(), net.nodes());
    const Eigen::VectorXd tension = tensions_of(found, found.unstressed_lengths(), found.nodes());
    for (int e = 0; e < net.edge_count(); ++e) {
        const int there = found.find_edge(net.edge_id(e));
        ASSERT_GE(there, 0);
        EXPECT_EQ(found.data().sag_weight(there), net.data().sag_weight(e));
        EXPECT_EQ(found.unstressed_lengths()(there), net.unstressed_lengths()(e));
        EXPECT_NEAR(tension(there), expected(e), 1e-9 * expected.maxCoeff());
    }
    const auto runs_of = [](const CableNet& of) {
        std::set<std::tuple<std::set<std::string>, std::set<std::string>, double>> runs;
        for (const CableRun& run : of.data().runs) {
            std::set<std::string> edges;
            std::set<std::string> nodes;
            for (const int edge : run.edges) {
                edges.insert(of.edge_id(edge));
            }
            for (const int node : run.slides_at) {
                nodes.insert(of.node_id(node));
            }
            runs.emplace(edges, nodes, run.friction.value_or(-1.0));
        }
        return runs;
    };
    EXPECT_EQ(runs_of(found), runs_of(net));
    EXPECT_EQ(found.adjustable_edges().size(), net.adjustable_edges().size());
    EXPECT_EQ(found.nodes().col(0), net.nodes().col(0));
    EXPECT_TRUE(solve_equilibrium(found).form.isApprox(net.nodes(), 1e-9));
}

TEST(Exports, ToCompasBringBackSupportsThatGiveWaySagAndRuns) {
    const CableNet net = net_as_built();
    expect_as_built(import(parse_compas(form_to_compas(net, net.nodes()), "net.json")), net);
}

TEST(Exports, ToCsvBringBackSupportsThatGiveWaySagAndRuns) {
    const CableNet net = net_as_built();
    expect_as_built(import(parse_net_csv(form_to_net_csv(net, net.nodes()), "n.csv", "e.csv")),
                    net);
}

TEST(Exports, ToObjComeBackAsFarAsObjGoes) {
    const CableNet net = net_with_everything();
    const ImportedStructure back = parse_obj(form_to_obj(net, net.nodes()), "net.obj");
    const CableNet found = import_net(back, {.axial_stiffness = 1e5}).net;
    EXPECT_EQ(found.nodes(), net.nodes());
    EXPECT_EQ(found.supports().size(), net.supports().size());
    EXPECT_EQ(found.edge_count(), net.edge_count());
}

TEST(Exports, HoldTensionsInTheFormThatIsGivenAndWhichEdgesAreSlack) {
    const CableNet net = net_with_everything();
    Points form = net.nodes();
    form.col(net.free_nodes()[0]).z() += 0.001;
    const Eigen::VectorXd expected = tensions_of(net, net.unstressed_lengths(), form);
    const auto document = nlohmann::json::parse(form_to_compas(net, form));
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        const auto& edge = document["data"]["edge"][std::to_string(s)][std::to_string(t)];
        EXPECT_EQ(edge["f"], expected(e));
        EXPECT_EQ(edge["is_slack"], expected(e) == 0.0);
    }
    EXPECT_EQ(document["dtype"], "compas.datastructures/Graph");
}

TEST(Exports, OfATensionLawHoldTheStiffnessWithWhichOthersFindItsTension) {
    const CableNet net = steel_roof();
    const CableNet linear =
        import_net(parse_compas(form_to_compas(net, net.nodes()), "net.json"), {}).net;
    EXPECT_TRUE(linear.is_linear());
    // The edges come back in another order.
    Eigen::VectorXd expected = tensions_of(net, net.unstressed_lengths(), net.nodes());
    Eigen::VectorXd found = tensions_of(linear, linear.unstressed_lengths(), linear.nodes());
    std::ranges::sort(expected);
    std::ranges::sort(found);
    EXPECT_TRUE(found.isApprox(expected, 1e-9));
}

/// Lines of numbers below each heading.
std::map<std::string, int> vtk_lines(const CableNet& net) {
    std::istringstream file(form_to_vtk(net, net.nodes()));
    std::map<std::string, int> lines;
    std::string heading;
    for (std::string line; std::getline(file, line);) {
        const bool is_number = line.find_first_not_of("0123456789-.e+ ") == std::string::npos;
        if (is_number) {
            ++lines[heading];
        } else if (!line.starts_with("LOOKUP_TABLE")) {
            heading = line;
        }
    }
    return lines;
}

TEST(Exports, ToVtkHoldWhatSagsSlidesAndGivesWay) {
    const CableNet net = net_as_built();
    auto lines = vtk_lines(net);
    EXPECT_EQ(lines["SCALARS sag_weight double 1"], net.edge_count());
    EXPECT_EQ(lines["SCALARS run int 1"], net.edge_count());
    EXPECT_EQ(lines["SCALARS slides int 1"], net.node_count());
    EXPECT_EQ(lines["TENSORS support_stiffness double"], 3 * net.node_count());
    EXPECT_EQ(lines["VECTORS support_place double"], net.node_count());
}

TEST(Exports, ToVtkHoldAsManyNumbersAsTheirHeadersSay) {
    const CableNet net = net_with_everything();
    auto lines = vtk_lines(net);
    const int n = net.node_count();
    const int m = net.edge_count();
    EXPECT_EQ(lines["POINTS " + std::to_string(n) + " double"], n);
    EXPECT_EQ(lines["CELLS " + std::to_string(m) + " " + std::to_string(3 * m)], m);
    EXPECT_EQ(lines["CELL_TYPES " + std::to_string(m)], m);
    for (const std::string name : {"tension double 1", "force_density double 1", "is_slack int 1",
                                   "unstressed_length double 1", "axial_stiffness double 1"}) {
        EXPECT_EQ(lines["SCALARS " + name], m) << name;
    }
    EXPECT_EQ(lines["SCALARS is_support int 1"], n);
    EXPECT_EQ(lines["VECTORS load double"], n);
}

TEST(Exports, RefuseAFormThatIsNone) {
    const CableNet net = net_with_everything();
    Points form = net.nodes();
    form(0, net.free_nodes()[0]) = std::numeric_limits<double>::quiet_NaN();
    const Points shorter = net.nodes().leftCols(3);
    for (const Points& bad : {form, shorter}) {
        EXPECT_THROW(static_cast<void>(form_to_compas(net, bad)), std::invalid_argument);
        EXPECT_THROW(static_cast<void>(form_to_obj(net, bad)), std::invalid_argument);
        EXPECT_THROW(static_cast<void>(form_to_net_csv(net, bad)), std::invalid_argument);
        EXPECT_THROW(static_cast<void>(form_to_vtk(net, bad)), std::invalid_argument);
    }
}

}  // namespace
}  // namespace taut
