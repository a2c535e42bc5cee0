// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/sampling/unknown.hpp"
#include "taut/survey/forces.hpp"

namespace taut::app {

/// --forces, --force-unit, --force-noise, --taut, --slack, as they were told.
struct ForceOptions {
    std::string forces;
    std::string force_unit = "N";
    std::string force_noise = "2%";
    std::string taut;  ///< a file, or "all"
    std::string slack;

    /// Files among them, for check_outputs().
    [[nodiscard]] std::vector<std::string> files() const;
};

/// --forces, --force-unit, --force-noise.
/// @param help of --forces
std::vector<CLI::Option*> add_reading_options(CLI::App& command, ForceOptions& options,
                                              const std::string& help);

/// The same, --taut and --slack.
void add_force_options(CLI::App& command, ForceOptions& options);

/// Reads what was told of forces; warns of a unit that is most likely another.
/// @throws InputError as parse_force_readings(), parse_edge_list(), and for an edge that is told
///   both taut and slack, or slack and read
Forces read_forces(const CableNet& net, const ForceOptions& options);

/// The readings of read_forces(), or names of edges alone: these are taken to be read as designed.
Forces read_planned_forces(const CableNet& net, const ForceOptions& options);

/// What --uncertain and --unknown say.
struct UncertainOptions {
    std::vector<std::string> uncertain;  ///< "none", or with what else is assumed
    std::vector<std::string> unknowns;   ///< with nothing else

    /// Whether what is not given is as on a site: with_site_assumptions().
    [[nodiscard]] bool assume_site() const;
    /// @throws std::invalid_argument for both options, and as parse_unknown()
    /// @throws InputError where they are not of this net
    [[nodiscard]] std::vector<Unknown> given(const CableNet& net,
                                             const std::string& net_file) const;
};

/// --uncertain NAME:WIDTH[@GROUP]|none and, as before 0.3, --unknown, any number of times.
/// @param needed an option that both need, or null
void add_uncertain_option(CLI::App& command, UncertainOptions& options,
                          CLI::Option* needed = nullptr);

/// --uncertain NAME:WIDTH[@GROUP], any number of times; before 0.3 --unknown.
CLI::Option* add_unknown_option(CLI::App& command, std::vector<std::string>& unknowns);

/// @throws std::invalid_argument as parse_unknown()
/// @throws InputError where they are not unknowns of this net
std::vector<Unknown> unknowns_of(const CableNet& net, const std::vector<std::string>& texts,
                                 const std::string& net_file);

}  // namespace taut::app
