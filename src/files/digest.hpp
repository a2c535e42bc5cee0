// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace taut {

/// The line that ends a file, with the digest of all before it: FNV-1a, 64 bit. Any change of a
/// single byte gives another digest, any other change all but surely.
[[nodiscard]] std::string digest_line(std::string_view content);

/// Reads a file to its end.
/// @return whether its last line is such a line
/// @throws InputError where the digest is another one, or the file cannot be read
[[nodiscard]] bool check_digest(const std::filesystem::path& path);

}  // namespace taut
