// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/cable_vibration.hpp"

namespace taut {

/// Standard deviation of frequencies without std, as a part of each.
inline constexpr double frequency_part = 0.01;

/// Reads natural frequencies, one edge a line: edge,frequency[,mode][,std], in Hz; the mode is 1
/// where there is none. The header with these names may be left out; empty lines and those that
/// start with # are skipped. An edge is a name of the net, else an index.
/// @param file_name for messages
/// @param relative_std of frequencies without std
/// @return in the order of the file, at least one
/// @throws InputError with the line, for anything else, an edge that is not of the net or comes
///   twice, a frequency that is not between 0.01 and 100,000 Hz, a mode that is no whole number
///   from 1 to 50, a std that is not positive
[[nodiscard]] TAUT_IO_EXPORT std::vector<FrequencyMeasurement> parse_frequencies(
    const CableNet& net, std::string_view text, const std::string& file_name,
    double relative_std = frequency_part);

}  // namespace taut
