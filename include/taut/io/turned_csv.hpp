// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/turned_net.hpp"

namespace taut {

/// Reads what was turned, one edge a line: edge,stroke[,std] in m, positive lengthens. The header
/// with these names may be left out. Or the list of turns of a plan, by its header: the strokes of
/// all passes over an edge (stroke_mm) add up.
/// @param file_name for messages
/// @throws InputError with the line, for a file without a line, an edge that is not of the net, not
///   adjustable, or comes twice (in the list of a plan: twice in one pass), a number that is none,
///   and a stroke or std that is more than a quarter of the edge
[[nodiscard]] TAUT_IO_EXPORT std::vector<EdgeTurned> parse_turned(const CableNet& net,
                                                                  std::string_view text,
                                                                  const std::string& file_name);

}  // namespace taut
