// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "taut/interchange/imported_structure.hpp"

namespace taut {

/// The edges that a reader comes across: each pair of nodes once, in the order of the nodes.
class EdgeCollection {
public:
    /// Notes an edge, at the first place where it is met.
    void add(int s, int t, const std::string& place) {
        m_edges.emplace(std::minmax(s, t), Entry{.place = place});
    }

    /// Notes a side of a face.
    void add_side(int s, int t, const std::string& place) {
        add(s, t, place);
        ++m_edges[std::minmax(s, t)].faces;
    }

    [[nodiscard]] bool contains(int s, int t) const { return m_edges.contains(std::minmax(s, t)); }

    /// The edges of the structure, named by their nodes; marks its boundary.
    void write_to(ImportedStructure& structure) const {
        std::vector<int> edges_at(structure.nodes.size(), 0);
        bool has_faces = false;
        for (const auto& [nodes, entry] : m_edges) {
            const auto [s, t] = nodes;
            has_faces |= entry.faces > 0;
            ++edges_at[s];
            ++edges_at[t];
            structure.edges.push_back({.id = node(structure, s).id + "-" + node(structure, t).id,
                                       .place = entry.place,
                                       .s = s,
                                       .t = t,
                                       .numbers = {}});
        }
        for (const auto& [nodes, entry] : m_edges) {
            for (const int end : {nodes.first, nodes.second}) {
                node(structure, end).is_boundary |=
                    has_faces ? entry.faces == 1 : edges_at[end] == 1;
            }
        }
    }

private:
    struct Entry {
        std::string place;
        int faces = 0;  ///< that have it as a side
    };
    static ImportedNode& node(ImportedStructure& structure, int index) {
        return structure.nodes[index];
    }

    std::map<std::pair<int, int>, Entry> m_edges;
};

}  // namespace taut
