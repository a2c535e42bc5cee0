// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace taut::app {

/// Refuses a directory that cannot be written to, before the work and without making it, and one
/// where an input would be overwritten.
/// @param names of the files that may be written there, at least one
/// @throws std::invalid_argument for an empty directory name
/// @throws OutputError
void check_output_directory(const std::filesystem::path& directory,
                            const std::vector<std::string>& names,
                            const std::vector<std::string>& inputs);

/// Writes a result, further files, and the report where this taut can make one.
/// @param name of the result's file; it comes first
void write_with_report(const std::filesystem::path& directory, const std::string& name,
                       const std::string& json,
                       std::vector<std::pair<std::string, std::string>> further);

/// Where the report of a directory is, or why there is none.
[[nodiscard]] std::string report_text(const std::filesystem::path& directory);

}  // namespace taut::app
