// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/forces.hpp"

namespace taut {

/// How force measurements are given.
struct ForceFormat {
    double unit = 1.0;           ///< of the file's numbers [N]
    double relative_std = 0.02;  ///< of measurements without std, as a part of each
    double std_dev = 0.0;        ///< of these, absolute; 0: relative_std holds [N]
};

/// Reads tensions, one edge a line: edge,tension[,std]. The header with these names may be left
/// out; empty lines and those that start with # are skipped. An edge is a name of the net, else an
/// index.
/// @param file_name for messages
/// @return in the order of the file, at least one
/// @throws InputError with the line, for anything else, an edge that is not of the net or comes
///   twice, a tension that is negative, a std that is not positive, and a tension of 0 whose std is
///   given as a part of it
[[nodiscard]] TAUT_IO_EXPORT std::vector<ForceMeasurement> parse_force_measurements(
    const CableNet& net, std::string_view text, const std::string& file_name,
    const ForceFormat& format = {});

/// Reads a list of edges, one a line, with or without the header "edge".
/// @return in the order of the file, at least one
/// @throws InputError with the line, for an edge that is not of the net or comes twice
[[nodiscard]] TAUT_IO_EXPORT std::vector<int> parse_edge_list(const CableNet& net,
                                                              std::string_view text,
                                                              const std::string& file_name);

/// Whether the first line with anything has one field: a list of edges, not force measurements.
/// @throws InputError as CSV
[[nodiscard]] TAUT_IO_EXPORT bool is_edge_list(std::string_view text, const std::string& file_name);

}  // namespace taut
