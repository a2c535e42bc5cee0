// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/interchange/net_import.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "interchange/import_lengths.hpp"
#include "interchange/import_numbers.hpp"
#include "interchange/import_runs.hpp"
#include "interchange/import_selection.hpp"
#include "taut/files/input_error.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/imbalance.hpp"
#include "taut/statics/plausibility.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

std::vector<int> nodes_that_give_way(const ImportedStructure& structure) {
    std::vector<int> result;
    for (size_t i = 0; i < structure.nodes.size(); ++i) {
        if (structure.nodes[i].support_stiffness) {
            result.push_back(static_cast<int>(i));
        }
    }
    return result;
}

/// The net. A broken rule is reported in the names of the file.
CableNet make_net(const ImportedStructure& structure, CableNetData data) {
    try {
        return CableNet(std::move(data));
    } catch (const NetError& error) {
        if (!error.index().empty()) {
            const int i = error.index().front();
            if (error.field() == "edges") {
                fail_at(structure, structure.edges[i], error.problem());
            }
            const bool is_elastic = error.field() == "elastic_supports";
            if (is_elastic || error.field() == "nodes" || error.field() == "loads") {
                const ImportedNode& node =
                    structure.nodes[is_elastic ? nodes_that_give_way(structure)[i] : i];
                throw InputError(structure.file, node.place,
                                 fmt::format("node {} {}", node.id, error.problem()));
            }
        }
        throw InputError(structure.file, "", error.what());
    }
}

CableNetData data_of(const ImportedStructure& structure) {
    CableNetData data;
    data.name = structure.name.empty() ? std::filesystem::path(structure.file).stem().string()
                                       : structure.name;
    data.nodes.resize(3, static_cast<Eigen::Index>(structure.nodes.size()));
    for (size_t i = 0; i < structure.nodes.size(); ++i) {
        const ImportedNode& node = structure.nodes[i];
        data.nodes.col(static_cast<Eigen::Index>(i)) = node.position;
        data.node_ids.push_back(node.id);
        if (node.is_rigid()) {
            data.supports.push_back(static_cast<int>(i));
        }
    }
    for (const ImportedEdge& edge : structure.edges) {
        data.edges.push_back({edge.s, edge.t});
        data.edge_ids.push_back(edge.id);
    }
    return data;
}

void add_elastic_supports(const ImportedStructure& structure, double force_unit, CableNetData& data,
                          ImportReport& report) {
    for (const int i : nodes_that_give_way(structure)) {
        const ImportedNode& node = structure.nodes[i];
        data.elastic_supports.push_back({.node = i,
                                         .stiffness = force_unit * *node.support_stiffness,
                                         .place = node.support_place.value_or(node.position)});
    }
    if (!data.elastic_supports.empty()) {
        report.read.push_back(fmt::format("{} supports give way, by support_stiffness",
                                          data.elastic_supports.size()));
    }
}

/// Places without load, where the file gives none: there the springs balance the given form.
CableNet with_places_in_balance(const ImportedStructure& structure, const CableNet& net,
                                ImportReport& report) {
    const CableNet balanced = with_supports_in_balance(net);
    CableNetData data = net.data();
    int moved = 0;
    for (size_t k = 0; k < data.elastic_supports.size(); ++k) {
        ElasticSupport& support = data.elastic_supports[k];
        if (!structure.nodes[support.node].support_place) {
            support.place = balanced.elastic_supports()[k].place;
            ++moved;
        }
    }
    if (moved == 0) {
        return net;
    }
    report.assumed.push_back(fmt::format(
        "{} supports that give way stand in balance in the given form (no support_place)", moved));
    return make_net(structure, std::move(data));
}

/// Names of edges are free text: where two are alike, all edges go by their nodes.
void make_edge_ids_unique(CableNetData& data, ImportReport& report) {
    const std::set<std::string> ids(data.edge_ids.begin(), data.edge_ids.end());
    if (ids.size() == data.edge_ids.size()) {
        return;
    }
    for (size_t e = 0; e < data.edges.size(); ++e) {
        data.edge_ids[e] = data.node_ids[data.edges[e][0]] + "-" + data.node_ids[data.edges[e][1]];
    }
    report.left_out.emplace_back("the names of the edges, of which some are alike");
}

std::vector<int> adjustable_of(const ImportedStructure& structure, const CableNetData& data,
                               ImportReport& report) {
    std::vector<int> adjustable;
    bool given = false;
    for (size_t e = 0; e < structure.edges.size(); ++e) {
        const auto& numbers = structure.edges[e].numbers;
        const auto found = numbers.find("is_adjustable");
        given |= found != numbers.end();
        if (found != numbers.end() && found->second != 0.0) {
            adjustable.push_back(static_cast<int>(e));
        }
    }
    if (given) {
        report.read.emplace_back("adjustable edges: by is_adjustable");
        return adjustable;
    }
    report.assumed.emplace_back("adjustable edges: those at supports");
    std::vector<int> supports = data.supports;
    std::ranges::move(nodes_that_give_way(structure), std::back_inserter(supports));
    return edges_at_supports(data.edges, supports);
}

/// By is_strut of the file, else those in compression.
std::vector<EdgeKind> kinds_of(const ImportedStructure& structure,
                               const std::vector<bool>& is_pressed, ImportReport& report) {
    std::vector<EdgeKind> kinds(is_pressed.size(), EdgeKind::cable);
    bool is_given = false;
    for (size_t e = 0; e < kinds.size(); ++e) {
        const auto& numbers = structure.edges[e].numbers;
        const auto found = numbers.find("is_strut");
        is_given |= found != numbers.end();
        if (found != numbers.end() && found->second != 0.0) {
            kinds[e] = EdgeKind::strut;
        }
    }
    if (is_given) {
        for (size_t e = 0; e < kinds.size(); ++e) {
            if (is_pressed[e] && kinds[e] == EdgeKind::cable) {
                fail_at(structure, structure.edges[e],
                        "is in compression, but no strut by is_strut");
            }
        }
        report.read.emplace_back("struts: by is_strut");
        return kinds;
    }
    const auto pressed = std::ranges::count(is_pressed, true);
    const auto beams = std::ranges::count(structure.edges, true, &ImportedEdge::is_beam);
    for (size_t e = 0; e < kinds.size(); ++e) {
        if (is_pressed[e] || structure.edges[e].is_beam) {
            kinds[e] = EdgeKind::strut;
        }
    }
    if (beams > 0) {
        report.assumed.push_back(fmt::format(
            "struts: the {} edges of type beam or strut, which taut does not bend", beams));
    }
    if (pressed > 0) {
        report.assumed.push_back(fmt::format("struts: the {} edges in compression", pressed));
    }
    if (2 * pressed > std::ssize(kinds)) {
        report.warnings.push_back(
            fmt::format("{} of {} edges are in compression, and become struts. Is a negative force "
                        "tension in this file?",
                        pressed, kinds.size()));
    }
    return kinds;
}

Points loads_of_file(const ImportedStructure& structure, double force_unit, ImportReport& report) {
    Points loads(3, static_cast<Eigen::Index>(structure.nodes.size()));
    for (size_t i = 0; i < structure.nodes.size(); ++i) {
        loads.col(static_cast<Eigen::Index>(i)) = force_unit * structure.nodes[i].load;
    }
    int loaded_edges = 0;
    for (const ImportedEdge& edge : structure.edges) {
        for (const char* name : {"px", "py", "pz"}) {
            const auto found = edge.numbers.find(name);
            if (found != edge.numbers.end() && found->second != 0.0) {
                ++loaded_edges;
                break;
            }
        }
    }
    if (loaded_edges > 0) {
        report.left_out.push_back(fmt::format("the loads of {} edges", loaded_edges));
    }
    return loads;
}

/// Forces at the free nodes that hold the form: h_s without loads.
Points balancing_loads(const CableNet& net) {
    const Eigen::VectorXd forces =
        out_of_balance_forces(net, net.unstressed_lengths(), net.nodes());
    Points loads = Points::Zero(3, net.node_count());
    loads(Eigen::all, net.free_nodes()) = forces.reshaped(3, net.free_node_count());
    return loads;
}

/// Names the ends of single cables, which only a load holds: in the structure a strut, a beam or a
/// support may.
void warn_of_loose_ends(const CableNet& net, ImportReport& report) {
    std::vector<std::string> ends;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double largest = 0.0;
    for (const int node : net.free_nodes()) {
        const Eigen::Vector3d load = net.loads().col(node);
        if (net.edges_at(node).size() == 1 && !load.isZero(0.0)) {
            ends.push_back(net.node_id(node));
            sum += load;
            largest = std::max(largest, load.norm());
        }
    }
    if (ends.empty()) {
        return;
    }
    report.warnings.push_back(fmt::format(
        "only the loads of 'balance' hold {} {}, where one cable ends: up to {:.3g} N, together "
        "({:.3g}, {:.3g}, {:.3g}) N. Does a strut, a beam or a support hold it that the net does "
        "not have?",
        ends.size() == 1 ? "node" : "nodes", fmt::join(ends, ", "), largest, sum.x(), sum.y(),
        sum.z()));
}

void describe(const CableNet& net, ImportReport& report) {
    const Points loads = net.loads()(Eigen::all, net.free_nodes());
    report.load_sum = loads.rowwise().sum();
    report.largest_horizontal_load = loads.topRows(2).colwise().norm().maxCoeff();
    const Imbalance found = imbalance_of(net, net.unstressed_lengths(), net.nodes());
    report.largest_out_of_balance = found.largest;
    report.mean_tension = found.mean_tension;
    const Eigen::ArrayXd strains =
        edge_lengths(net, net.nodes()).array() / net.unstressed_lengths().array() - 1.0;
    report.least_strain = strains.minCoeff();
    report.largest_strain = strains.maxCoeff();
    std::ranges::move(unit_warnings(net), std::back_inserter(report.warnings));
}

}  // namespace

ImportedNet import_net(const ImportedStructure& structure, const ImportSettings& settings) {
    ImportReport report;
    report.read.push_back(structure.format);
    const ImportedStructure selected = select_net(structure, report);
    CableNetData data = data_of(selected);
    make_edge_ids_unique(data, report);
    data.adjustable = adjustable_of(selected, data, report);

    const ImportedLengths lengths = import_lengths(selected, settings, report);
    data.axial_stiffness = lengths.axial_stiffness;
    data.tension_laws = lengths.tension_laws;
    data.tension_law = lengths.tension_law;
    data.unstressed_lengths = lengths.unstressed;
    data.kind = kinds_of(selected, lengths.is_pressed, report);
    data.sag_weight = lengths.sag_weight;
    add_elastic_supports(selected, lengths.force_unit, data, report);
    report.assumed.emplace_back("coordinates are in m");
    if (settings.loads == ImportSettings::Loads::file) {
        data.loads = loads_of_file(selected, lengths.force_unit, report);
    }
    CableNet net = make_net(selected, std::move(data));
    if (!net.elastic_supports().empty()) {
        net = with_places_in_balance(selected, net, report);
    }
    if (settings.loads == ImportSettings::Loads::balance) {
        data = net.data();
        data.loads = balancing_loads(net);
        net = make_net(selected, std::move(data));
        warn_of_loose_ends(net, report);
    }
    net = with_sliding_runs(net, settings.slides, selected, report);
    describe(net, report);
    return {.net = net, .report = std::move(report)};
}

}  // namespace taut
