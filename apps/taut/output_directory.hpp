// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace taut::app {

/// Refuses a directory that could not be written to, before the work and without making it, and one
/// where an input would be written over.
/// @param names of the files that may be written there, at least one
/// @throws std::invalid_argument for an empty directory name
/// @throws OutputError
void check_output_directory(const std::filesystem::path& directory,
                            const std::vector<std::string>& names,
                            const std::vector<std::string>& inputs);

}  // namespace taut::app
