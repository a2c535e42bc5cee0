// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// A net as it stands in a file.
struct NetFile {
    CableNet net;  ///< all that taut knows of the file
    /// A JSON object of the top-level keys that taut does not know, to be written back.
    std::string unknown_keys = "{}";
};

/// Reads a net in taut's own JSON format, version 1:
///
///     {"format": "taut-net", "version": 1, "name": text, "nodes": [[x, y, z]...] [m],
///      "supports": [node...], "edges": [[s, t]...], "axial_stiffness": [N...] or one number [N],
///      "unstressed_lengths": [m...], "adjustable": [edge...], "loads": [[x, y, z]...] [N],
///      "node_ids": [text...], "edge_ids": [text...],
///      "tension_laws": [{"name": text, "strain": [0, ...], "tension": [0, ...] [N]}...],
///      "tension_law": [index or null, one an edge], "groups": {name: [edge...]},
///      "mass": [kg/m...] or one number, "expansion": [1/K...] or one number,
///      "breaking_load": [N...] or one number,
///      "bending_stiffness": [N m2...] or one number, "cable_ends": ["hinged", "fixed" or
///      "unknown", one an edge] or one of them, "thread": ["right" or "left", one an entry of
///      "adjustable"], "support_stiffness": [null, one number, [x, y, z] or a matrix of 3 x 3
///      [N/m], one a support] or one number, "support_place": [null or [x, y, z] [m], one a
///      support] or "balanced", "support_couplings": [[support, support, matrix of 3 x 3 [N/m]]...,
///      of two with a stiffness: force on the first by a shift of the second], "kind": ["cable" or
///      "strut", one an edge], "buckling_load": [N or null, one an edge] or one number of all
///      struts, "sag_weight": [N/m, one an edge], one number of all cables or "mass"}
///
/// A support with a stiffness is elastic, ElasticSupport. Its place without load is by default that
/// of its node; "balanced" places are those of with_supports_in_balance().
/// Optional are name (default: the file's, without its ending), adjustable (default: the edges at a
/// support), loads, node_ids, edge_ids and all behind them. An edge with a tension law
/// makes no use of its axial_stiffness. Other keys are kept. An index is written without fraction
/// or exponent.
/// @param file_name for messages, and for the net's default name
/// @throws InputError at a line and column for what is no JSON (RFC 8259, UTF-8, no key twice in an
///   object, no number too large for a double, at most 64 levels deep), and at a JSON pointer
///   for what is missing, of another type, or breaks a rule of CableNet
[[nodiscard]] TAUT_IO_EXPORT NetFile parse_net(std::string_view text, const std::string& file_name);

/// Reads a file as parse_net().
/// @throws InputError as parse_net() and read_file(), and for units that cannot be meant, as
///   refuse_impossible_units()
[[nodiscard]] TAUT_IO_EXPORT NetFile read_net(const std::filesystem::path& path);

/// The net as parse_net() reads it, numbers to the last bit: one node or edge a line.
/// @param unknown_keys a JSON object, as in NetFile
/// @throws std::invalid_argument for unknown_keys that are no JSON object or name a key of the
///   format, and for a name in the net that is not UTF-8
[[nodiscard]] TAUT_IO_EXPORT std::string net_to_json(const CableNet& net,
                                                     const std::string& unknown_keys = "{}");

}  // namespace taut
