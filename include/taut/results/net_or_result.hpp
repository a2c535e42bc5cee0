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

/// A net as designed, or as an identification found it built.
struct NetOrResult {
    /// Of an identification: unstressed lengths of interior edges = nominal + length_deviation,
    /// nodes at the predicted form, all else as in its "cable_net", unknown keys included.
    NetFile file;
    bool is_identified = false;  ///< false: `file` is the net as designed
    /// Interior edges whose length the survey does not tell; they have the estimate all the same.
    std::vector<int> slack;
    std::vector<int> not_determined;  ///< EdgeStatus::not_determined, those above EdgeStatus::slack
};

/// Reads a net (parse_net()) or a saved identification (parse_result()), told apart by "format".
/// @throws InputError as these two, and for a result of another kind, which is not of one built net
[[nodiscard]] TAUT_IO_EXPORT NetOrResult parse_net_or_result(std::string_view text,
                                                             const std::string& file_name);

/// Reads a file as parse_net_or_result().
/// @throws InputError as parse_net_or_result() and read_file(), and for units that cannot be meant
[[nodiscard]] TAUT_IO_EXPORT NetOrResult read_net_or_result(const std::filesystem::path& path);

}  // namespace taut
