// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/io/net_json.hpp"

namespace taut {

/// A net as designed, or as built by an identification.
struct NetOrResult {
    /// For an identification: unstressed lengths of interior edges = nominal + length_deviation,
    /// nodes at the predicted form, all else as in its "cable_net", with its unknown keys.
    NetFile file;
    bool is_identified = false;       ///< false: `file` is the net as designed
    std::vector<int> slack;           ///< edges with EdgeStatus::slack; their estimate is used
    std::vector<int> not_determined;  ///< edges with EdgeStatus::not_determined; likewise
};

/// Reads a net (parse_net()) or a saved identification (parse_result()), by its "format".
/// @throws InputError as these two, and for other results, which are not of one built net
[[nodiscard]] TAUT_IO_EXPORT NetOrResult parse_net_or_result(std::string_view text,
                                                             const std::string& file_name);

/// Reads a file as parse_net_or_result().
/// @throws InputError as parse_net_or_result() and read_file(), and for implausible units
[[nodiscard]] TAUT_IO_EXPORT NetOrResult read_net_or_result(const std::filesystem::path& path);

}  // namespace taut
