// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "taut/interchange/imported_structure.hpp"

/// Small nets as other programs write them.
namespace taut::test {

/// A square of anchors around one free node, in COMPAS's old layout: four faces, four edges to the
/// middle, and four borders that are not edges. q = 2, E = 210 GPa, r = 1 mm.
///
///   3 --- 2
///   | \ / |
///   |  4  |
///   | / \ |
///   0 --- 1
inline nlohmann::json old_compas_mesh() {
    using nlohmann::json;
    return {
        {"attributes", {{"name", "tent"}}},
        {"dva", {{"z", 0.0}, {"is_anchor", true}, {"px", 0.0}, {"py", 0.0}, {"pz", 0.0}}},
        {"dea", {{"q", 2.0}, {"E", 210.0}, {"r", 0.001}, {"l0", 0.0}, {"is_edge", true}}},
        {"vertex",
         {{"0", {{"x", 0}, {"y", 0}}},
          {"1", {{"x", 2}, {"y", 0}}},
          {"2", {{"x", 2}, {"y", 2}}},
          {"3", {{"x", 0}, {"y", 2}}},
          {"4", {{"x", 1}, {"y", 1}, {"z", 0.5}, {"is_anchor", false}, {"pz", -1.5}}}}},
        {"face", {{"7", {0, 1, 4}}, {"8", {"1", "2", "4"}}, {"9", {2, 3, 4}}, {"10", {3, 0, 4}}}},
        {"edgedata",
         {{"(0, 1)", {{"is_edge", false}}},
          {"(2, 1)", {{"is_edge", false}}},
          {"2-3", {{"is_edge", false}}},
          {"(3,0)", {{"is_edge", false}}},
          {"(4, 0)", {{"q", 3.0}}},
          {"(0, 4)", {{"size", "6"}}}}}};
}

/// A chain A - B - C as a present-day COMPAS graph: text keys in Python's quotes, B free.
inline nlohmann::json new_compas_graph() {
    return {{"dtype", "compas.datastructures/Graph"},
            {"data",
             {{"attributes", nlohmann::json::object()},
              {"default_node_attributes", {{"x", 0.0}, {"y", 0.0}, {"z", 0.0}}},
              {"default_edge_attributes", {{"q", 0.0}}},
              {"node",
               {{"'A'", {{"is_support", true}}},
                {"'B'", {{"x", 1.0}}},
                {"'C'", {{"x", 2.0}, {"is_support", true}}}}},
              {"edge",
               {{"'A'", {{"'B'", {{"q", 5.0}}}}},
                {"'B'", nlohmann::json::object()},
                {"'C'", {{"'B'", {{"q", 5.0}, {"name", "right"}}}}}}}}}};
}

inline const ImportedEdge& edge_named(const ImportedStructure& structure, const std::string& id) {
    for (const ImportedEdge& edge : structure.edges) {
        if (edge.id == id) {
            return edge;
        }
    }
    throw std::out_of_range("no edge " + id);
}

}  // namespace taut::test
