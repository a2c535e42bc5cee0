// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/interchange/imported_structure.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Reads a mesh or a network (graph) of COMPAS or JAX FDM: an object with "vertex" or "node", and
/// "face" or "edge", as it stands, or inside "data" beside a "dtype", or anywhere deeper in the
/// file. Edges are the sides of the faces, or the entries of "edge"; "edgedata" names them "(u, v)"
/// or "u-v", in either direction. Attributes not given are those of "dva", "dea" or
/// "default_..._attributes".
/// @param select key of the structure to read ("cablenet", "session/cablenet"); empty: the only one
/// @throws InputError at a line and column or a JSON pointer, for what is no JSON (as parse_net()),
///   no such structure or more than one, a vertex that is not there, a face of fewer than three
///   vertices, an attribute of another type, and an edge whose two directions contradict each other
[[nodiscard]] TAUT_IO_EXPORT ImportedStructure parse_compas(std::string_view text,
                                                            const std::string& file_name,
                                                            const std::string& select = "");

/// A form as a COMPAS Graph, which compas.json_load() opens and parse_compas() reads: nodes with
/// is_support and loads (px, py, pz), edges with q, f, l, l0, EA, is_slack and is_adjustable, in m
/// and N. Where a net has them: nodes with support_stiffness, support_place and slides (names of
/// runs), edges with is_strut, sag_weight, run and friction.
/// @param form 3 x n [m]
/// @throws std::invalid_argument for another size, a coordinate that is not finite, and an edge of
///   no length
[[nodiscard]] TAUT_IO_EXPORT std::string form_to_compas(const CableNet& net, const Points& form);

}  // namespace taut
