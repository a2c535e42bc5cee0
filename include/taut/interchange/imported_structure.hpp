// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/abi.hpp"
#include "taut/export/io.hpp"

namespace taut {

/// A node as another program's file gives it.
struct ImportedNode {
    std::string id;                           ///< name, or number in the file; no two are alike
    std::string place;                        ///< in the file, for messages: JSON pointer or line
    Eigen::Vector3d position{0.0, 0.0, 0.0};  ///< [m]
    Eigen::Vector3d load{0.0, 0.0, 0.0};      ///< in the file's unit of force
    bool is_support = false;   ///< by the file, support_boundary() or support_named()
    bool is_boundary = false;  ///< at a side of one face only; without faces: at one edge only
    /// Of a support that gives way, in the file's unit of force per metre; empty: it is rigid, or
    /// no support.
    std::optional<Eigen::Matrix3d> support_stiffness = {};
    std::optional<Eigen::Vector3d> support_place = {};  ///< where it stands without load [m]
    /// Names of the runs that slide through the node.
    std::vector<std::string> slides = {};
    bool all_slide = false;  ///< all runs that pass the node slide through it

    /// Whether it is a support that does not give way.
    [[nodiscard]] bool is_rigid() const { return is_support && !support_stiffness; }
};

/// An edge as another program's file gives it.
struct ImportedEdge {
    std::string id;     ///< name; where it has none, those of its nodes, "a-b"; may come twice
    std::string place;  ///< in the file, for messages, as that of a node
    int s = 0;          ///< one end: index of ImportedStructure::nodes
    int t = 0;          ///< the other end
    /// What the file says of it in numbers, in the file's units, by the names that it uses; true
    /// and false are 1 and 0. Those that taut understands: q, f or force, l or length, l0, E, r,
    /// EA, px, py, pz, is_adjustable, is_strut, sag_weight, and of runs friction.
    std::map<std::string, double> numbers;
    std::string run = {};  ///< name of the cable run that the edge is part of; may be empty
    bool is_beam = false;  ///< by its type: a beam or a strut
};

/// What a reader found in another program's file, before taut makes a net of it. Every format is
/// read into this. Both ends of an edge must be indices of `nodes`: not checked.
struct ImportedStructure {
    std::string file;                  ///< name, for messages
    std::string format;                ///< in words: "COMPAS mesh"
    std::string name;                  ///< of the net in the file; may be empty
    std::vector<ImportedNode> nodes;   ///< those without edges, too
    std::vector<ImportedEdge> edges;   ///< each pair of nodes once
    int inactive_edges = 0;            ///< those whose is_edge is false, which are not in `edges`
    std::optional<double> force_unit;  ///< [N], where the file gives it
    std::vector<std::string> notes;  ///< what the reader left out or took for granted, a line each
};

/// Marks the nodes at the boundary as supports: ImportedNode::is_boundary.
TAUT_IO_EXPORT void support_boundary(ImportedStructure& structure);

/// Marks the nodes that a text names as supports: ids between blanks, commas, semicolons or ends of
/// lines; # starts a comment.
/// @param file_name of the text, for messages
/// @throws InputError with the line, for a name that is no node's, and where there is none
TAUT_IO_EXPORT void support_named(ImportedStructure& structure, std::string_view text,
                                  const std::string& file_name);

}  // namespace taut
