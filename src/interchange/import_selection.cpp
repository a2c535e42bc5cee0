// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/import_selection.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "taut/files/input_error.hpp"

namespace taut {
namespace {

void check(const ImportedStructure& structure) {
    if (structure.edges.empty()) {
        throw InputError(structure.file, "",
                         fmt::format("the {} holds no edges", structure.format));
    }
    if (std::ranges::none_of(structure.nodes, [](const ImportedNode& node) {
            return node.is_support || node.support_stiffness;
        })) {
        throw InputError(structure.file, "",
                         "marks no supports (is_anchor, is_fixed, is_support, or is_free 0): name "
                         "them, or take the boundary");
    }
}

void count(std::vector<std::string>& lines, int number, const std::string& what) {
    if (number > 0) {
        lines.push_back(fmt::format("{} {}", number, what));
    }
}

}  // namespace

ImportedStructure select_net(const ImportedStructure& structure, ImportReport& report) {
    check(structure);
    const auto node = [&structure](int index) -> const ImportedNode& {
        return structure.nodes[index];
    };
    ImportedStructure net = structure;
    std::erase_if(net.edges, [&node](const ImportedEdge& edge) {
        return node(edge.s).is_rigid() && node(edge.t).is_rigid();
    });
    std::vector<int> new_index(structure.nodes.size(), -1);
    for (const ImportedEdge& edge : net.edges) {
        new_index[edge.s] = new_index[edge.t] = 0;
    }
    net.nodes.clear();
    for (size_t i = 0; i < structure.nodes.size(); ++i) {
        if (new_index[i] == 0) {
            new_index[i] = static_cast<int>(net.nodes.size());
            net.nodes.push_back(structure.nodes[i]);
        }
    }
    for (ImportedEdge& edge : net.edges) {
        edge.s = new_index[edge.s];
        edge.t = new_index[edge.t];
    }
    if (net.edges.empty()) {
        throw InputError(structure.file, "", "joins supports only, expected free nodes");
    }
    report.inactive_edges = structure.inactive_edges;
    report.edges_between_supports = static_cast<int>(structure.edges.size() - net.edges.size());
    report.isolated_nodes = static_cast<int>(structure.nodes.size() - net.nodes.size());
    count(report.left_out, report.inactive_edges, "sides that are no edges (is_edge false)");
    count(report.left_out, report.edges_between_supports, "edges between two supports");
    count(report.left_out, report.isolated_nodes, "nodes without edges");
    report.left_out.insert(report.left_out.end(), structure.notes.begin(), structure.notes.end());
    return net;
}

}  // namespace taut
