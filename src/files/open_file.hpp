// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

namespace taut {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
/// Owns an open file.
using File = std::unique_ptr<std::FILE, CloseFile>;

/// Opens a file for reading.
/// @throws InputError where it is missing, a directory or unreadable
[[nodiscard]] File open_file(const std::filesystem::path& path);

}  // namespace taut
