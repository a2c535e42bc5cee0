// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/interchange/imported_structure.hpp"
#include "taut/interchange/stress_strain_csv.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// How to make a net of another program's file, where the file leaves it open.
struct ImportSettings {
    /// Where the loads come from.
    enum class Loads {
        file,     ///< those of the file
        balance,  ///< those that hold the given form in equilibrium
        none,
    };
    /// Which cables run on through nodes, and slide there.
    enum class Slides {
        none,
        names,     ///< edges of one name but for the number at its end
        straight,  ///< edges that go on with a turn of less than 30 degrees
    };
    std::optional<double> axial_stiffness;      ///< of all edges [N]
    std::optional<double> young;                ///< of all edges, with a diameter [Pa]
    std::optional<StressStrain> stress_strain;  ///< of all edges, with a diameter or the file's r
    std::optional<double> diameter;             ///< of all edges [m]
    std::string diameter_attribute;             ///< name of the attribute that gives it [mm]
    std::optional<double> force_unit;           ///< of q, f and loads in the file [N]
    Loads loads = Loads::file;                  ///< which ones the net gets
    Slides slides = Slides::none;               ///< with a friction that is not known
};

/// "names", "straight" or "none".
/// @throws std::invalid_argument for another text
[[nodiscard]] TAUT_IO_EXPORT ImportSettings::Slides parse_slides(std::string_view text);

/// What was read, left out and assumed: a line each, for a person.
struct ImportReport {
    std::vector<std::string> read;            ///< what the net has from the file; its format first
    std::vector<std::string> left_out;        ///< what of the file the net has not
    std::vector<std::string> assumed;         ///< in place of what the file does not give
    std::vector<std::string> warnings;        ///< what is most likely wrong
    int inactive_edges = 0;                   ///< with is_edge false in the file; left out
    int edges_between_supports = 0;           ///< which are left out
    int isolated_nodes = 0;                   ///< without an edge that was taken; left out
    Eigen::Vector3d load_sum{0.0, 0.0, 0.0};  ///< over the free nodes [N]
    double largest_horizontal_load = 0.0;     ///< at one node [N]
    double largest_out_of_balance = 0.0;      ///< at one node, in the given form [N]
    double mean_tension = 0.0;                ///< over the taut edges, in the given form [N]
    double least_strain = 0.0;    ///< in the given form, negative where an edge is slack
    double largest_strain = 0.0;  ///< in the given form [-]
};

/// A net, and how it came about.
struct ImportedNet {
    CableNet net;         ///< its nodes are the given form
    ImportReport report;  ///< how it came about
};

/// Makes a net of what a reader found. The given form is the nominal form; edges between two
/// supports and nodes without edges are left out; edges at supports are adjustable. Where the file
/// gives unstressed lengths that agree with its forces, they are taken; else l_0 = l / (1 + strain
/// at T), T/EA where edges are linear, with T = q l, or T = f.
///
/// Cables that slide do so at all free nodes on their way, or as runs and nodes of the file say.
/// Struts are those of the attribute is_strut, else the edges in compression and those of type beam
/// or strut. Supports with a stiffness are elastic; without a place they balance the given form.
/// @throws InputError naming the node or edge: a cable in compression, a strain above 10 %, no
///   axial stiffness, a rule of CableNet that is broken, no cable that slides where they are asked
///   for
/// @throws std::invalid_argument for settings that are not positive, or exclude each other
[[nodiscard]] TAUT_IO_EXPORT ImportedNet import_net(const ImportedStructure& structure,
                                                    const ImportSettings& settings);

}  // namespace taut
