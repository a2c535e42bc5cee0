// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <system_error>

#include "taut/export/core.hpp"

/// What the standard library does not tell of the machine: one source a platform, posix.cpp for
/// Linux and macOS.
namespace taut::platform {

/// Of the machine [bytes].
[[nodiscard]] TAUT_CORE_EXPORT double physical_memory();

[[nodiscard]] TAUT_CORE_EXPORT long process_id();

/// Makes an empty file with the mode that any new file gets.
/// @return std::errc::file_exists, say, where it cannot
[[nodiscard]] TAUT_CORE_EXPORT std::error_code make_new_file(const std::filesystem::path& path);

/// Waits until a file's content, or a directory's entries, are on the disk.
[[nodiscard]] TAUT_CORE_EXPORT std::error_code flush_file(const std::filesystem::path& path);
[[nodiscard]] TAUT_CORE_EXPORT std::error_code flush_directory(const std::filesystem::path& path);

}  // namespace taut::platform
