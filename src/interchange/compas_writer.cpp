// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "interchange/form_values.hpp"
#include "taut/interchange/compas_json.hpp"

namespace taut {
namespace {

using nlohmann::ordered_json;

/// Keys are the indices of the nodes: names, which COMPAS would have to quote, are attributes.
ordered_json nodes_json(const CableNet& net, const Points& form, const RunValues& runs) {
    ordered_json nodes = ordered_json::object();
    for (int node = 0; node < net.node_count(); ++node) {
        const auto load = net.loads().col(node);
        nodes[std::to_string(node)] = {{"x", form(0, node)}, {"y", form(1, node)},
                                       {"z", form(2, node)}, {"is_support", net.is_support(node)},
                                       {"px", load.x()},     {"py", load.y()},
                                       {"pz", load.z()},     {"name", net.node_id(node)}};
        ordered_json& written = nodes[std::to_string(node)];
        if (const auto support = elastic_support_at(net, form, node)) {
            for (const auto& row : support->stiffness.rowwise()) {
                written["support_stiffness"].push_back({row(0), row(1), row(2)});
            }
            const Eigen::Vector3d& place = support->place;
            written["support_place"] = {place.x(), place.y(), place.z()};
        }
        if (!runs.slides[node].empty()) {
            written["slides"] = runs.slides[node];
        }
    }
    return nodes;
}

/// COMPAS wants every node here, also those that no edge starts at.
ordered_json edges_json(const CableNet& net, const FormValues& values, const RunValues& runs) {
    const std::vector<bool> adjustable = adjustable_flags(net);
    ordered_json edges = ordered_json::object();
    for (int node = 0; node < net.node_count(); ++node) {
        edges[std::to_string(node)] = ordered_json::object();
    }
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto [s, t] = net.edges()[e];
        ordered_json& edge = edges[std::to_string(s)][std::to_string(t)];
        edge = {{"q", values.force_densities(e)},
                {"f", values.tensions(e)},
                {"l", values.lengths(e)},
                {"l0", net.unstressed_lengths()(e)},
                {"EA", values.axial_stiffness(e)},
                {"is_slack", values.is_slack(net, e)},
                {"is_adjustable", static_cast<bool>(adjustable[e])},
                {"name", net.edge_id(e)}};
        if (net.has_struts()) {
            edge["is_strut"] = net.is_strut(e);
        }
        if (net.sags()) {
            edge["sag_weight"] = net.data().sag_weight(e);
        }
        if (!runs.of_edges[e].empty()) {
            edge["run"] = runs.of_edges[e];
        }
        if (runs.friction[e]) {
            edge["friction"] = *runs.friction[e];
        }
    }
    return edges;
}

}  // namespace

std::string form_to_compas(const CableNet& net, const Points& form) {
    const FormValues values = form_values(net, form);
    const RunValues runs = run_values(net);
    const ordered_json document{
        {"dtype", "compas.datastructures/Graph"},
        {"data",
         {{"attributes", {{"name", net.name()}, {"force_unit", "N"}, {"length_unit", "m"}}},
          {"default_node_attributes", {{"x", 0.0}, {"y", 0.0}, {"z", 0.0}, {"is_support", false}}},
          {"default_edge_attributes", ordered_json::object()},
          {"node", nodes_json(net, form, runs)},
          {"edge", edges_json(net, values, runs)},
          {"max_node", net.node_count() - 1}}},
        {"name", net.name()}};
    try {
        return document.dump(1) + "\n";
    } catch (const nlohmann::json::exception&) {
        throw std::invalid_argument("the net holds a name that is not UTF-8");
    }
}

}  // namespace taut
