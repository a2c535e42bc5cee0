// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/survey/cable_frequency.hpp"

namespace taut {

/// Reads a vibration record as apps of phones and sensors write it: a line a sample, of its time
/// and one or more signals, with or without a line of titles. Separated by commas, semicolons,
/// tabs or blanks; with decimal commas where the separator is another. The time is the column that
/// titles call elapsed, else time (or Zeit, t, timestamp), else the first; other columns of times
/// are left out. It is in s, or in the unit of its title: (ms), (us), (ns).
/// @param file_name for messages
/// @param rate of samples without times [Hz]: then all columns are signals
/// @throws InputError with the line for what is no finite number, another number of fields, a time
///   that does not ascend and a gap; for one column without a rate, and times beside one
[[nodiscard]] TAUT_IO_EXPORT VibrationRecord parse_vibration_record(
    std::string_view text, const std::string& file_name, std::optional<double> rate = {});

/// The fundamental of an edge for identify: edge,frequency,mode,std with mode 1, in Hz.
/// @param edge its name in the net, or its index
[[nodiscard]] TAUT_IO_EXPORT std::string frequency_to_csv(const std::string& edge,
                                                          const Fundamental& fundamental);

}  // namespace taut
