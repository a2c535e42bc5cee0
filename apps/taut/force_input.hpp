// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/sampling/uncertain_parameter.hpp"
#include "taut/survey/forces.hpp"
#include "taut/survey/survey.hpp"

namespace taut::app {

/// --forces, --force-unit, --force-noise, --taut, --slack, --frequencies, --frequency-noise,
/// --free-length-std, --sag, as given.
struct ForceOptions {
    std::string forces;
    std::string force_unit = "N";
    std::string force_noise = "2%";
    std::string taut;  ///< a file, or "all"
    std::string slack;
    std::string frequencies;
    std::string frequency_noise = "1%";
    std::string free_length_std = "10mm";
    std::string sag;

    /// Files among them, for check_outputs().
    [[nodiscard]] std::vector<std::string> files() const;
};

/// --forces, --force-unit, --force-noise.
/// @param help of --forces
std::vector<CLI::Option*> add_force_measurement_options(CLI::App& command, ForceOptions& options,
                                                        const std::string& help);

/// --frequency-noise, --free-length-std.
std::vector<CLI::Option*> add_frequency_noise_options(CLI::App& command, ForceOptions& options);

/// Of --frequency-noise.
/// @throws std::invalid_argument for what is not above 0 %
[[nodiscard]] double frequency_part(const ForceOptions& options);

/// All of ForceOptions.
void add_force_options(CLI::App& command, ForceOptions& options);

/// Reads the force measurements, frequencies and the edges seen taut or slack; warns where a unit
/// is most likely another.
/// @param survey of the net: its form is that in which cables vibrate and sag
/// @throws InputError as parse_force_measurements(), parse_frequencies(), tension_by_frequency(),
///   parse_sag_points(), tensions_by_sag(), parse_edge_list(), and for an edge that is measured
///   twice, given as both taut and slack, or as slack and measured
Forces read_forces(const CableNet& net, const ForceOptions& options, const Survey& survey);

/// The force measurements of a survey that is planned: as read_forces(), or of a file that only
/// names edges, whose designed tensions are then taken as measured.
Forces read_planned_forces(const CableNet& net, const ForceOptions& options);

/// The edges that a file names, one a line.
/// @throws InputError as parse_edge_list()
[[nodiscard]] std::vector<int> read_edge_list(const CableNet& net, const std::string& file);

/// --prior of a net.
/// @throws std::invalid_argument as parse_length_prior()
/// @throws InputError where it is too wide for this net
[[nodiscard]] LengthPrior prior_for(const CableNet& net, const std::string& text,
                                    const std::string& net_file);

/// --uncertain, as given.
struct UncertainOptions {
    std::vector<std::string> texts;  ///< NAME:WIDTH[@GROUP], or "none"

    /// Whether what is not given gets the widths of a site: with_site_assumptions().
    [[nodiscard]] bool assume_site() const;
    /// @throws std::invalid_argument as parse_uncertain_parameter()
    /// @throws InputError where they are not of this net
    [[nodiscard]] std::vector<UncertainParameter> given(const CableNet& net,
                                                        const std::string& net_file) const;
    /// given() and, where assume_site(), with_site_assumptions().
    [[nodiscard]] std::vector<UncertainParameter> assumed(const CableNet& net,
                                                          const std::string& net_file) const;
};

/// --uncertain NAME:WIDTH[@GROUP]|none, any number of times.
/// @param note for the help: what holds where it is not given
CLI::Option* add_uncertain_option(CLI::App& command, UncertainOptions& options,
                                  const std::string& note = "");

/// The note of commands that assume a site.
extern const char* const assumes_site;

}  // namespace taut::app
