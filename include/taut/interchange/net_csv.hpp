// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/interchange/imported_structure.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The two CSV files of a net.
struct NetCsv {
    std::string nodes;  ///< content of the file of nodes
    std::string edges;  ///< content of the file of edges
};

/// Reads a pair of CSV files as JAX FDM uses them, each with a header.
/// Nodes: the first columns are id, x, y, z, whatever their header says; by their header are read
/// is_free (0: a support), u, v, w (displacements to the form, which are added to x, y, z) and px,
/// py, pz (loads). Edges: the first columns are the ids of the two nodes; then, by their header,
/// numbers as in ImportedEdge, where q may be qopt or q0, and id.
/// @param nodes_name, edges_name for messages
/// @throws InputError with the line
[[nodiscard]] TAUT_IO_EXPORT ImportedStructure parse_net_csv(const NetCsv& text,
                                                             const std::string& nodes_name,
                                                             const std::string& edges_name);

/// A form as such a pair: nodes id,x,y,z,is_free,u,v,w,px,py,pz and edges
/// u,v,q,f,l,l0,EA,is_slack,is_adjustable,id; in m and N.
/// @param form 3 x n [m]
/// @throws std::invalid_argument for another size, a coordinate that is not finite, and an edge of
///   no length
[[nodiscard]] TAUT_IO_EXPORT NetCsv form_to_net_csv(const CableNet& net, const Points& form);

}  // namespace taut
