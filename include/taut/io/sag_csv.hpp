// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/cable_sag.hpp"

namespace taut {

/// Reads points on sagging cables, one a line: edge,x,y,z[,std], in m, in the frame of the net. The
/// header with these names may be left out; empty lines and those that start with # are skipped. An
/// edge is a name of the net, else an index; it comes as often as it has points.
/// @param file_name for messages
/// @param std_dev of points without one [m]
/// @return in the order of the file, at least one
/// @throws InputError with the line, for anything else, an edge that is not of the net, and a std
///   that is not positive
[[nodiscard]] TAUT_IO_EXPORT std::vector<SagPoint> parse_sag_points(const CableNet& net,
                                                                    std::string_view text,
                                                                    const std::string& file_name,
                                                                    double std_dev);

}  // namespace taut
