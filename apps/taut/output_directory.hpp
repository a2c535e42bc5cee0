// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace taut::app {

/// Refuses a directory that could not be written to, before the work and without making it.
/// @throws std::invalid_argument for an empty name
/// @throws OutputError
void check_output_directory(const std::filesystem::path& directory);

}  // namespace taut::app
