// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <mutex>

namespace taut {

/// What a path leads to: through symbolic links, also where that is not there yet; the path itself
/// where it is no link.
[[nodiscard]] std::filesystem::path follow_links(std::filesystem::path path);

/// Locked while outputs take their places: remove_temporary_files() waits for it.
[[nodiscard]] std::unique_lock<std::recursive_mutex> lock_output_places();

/// What remove_temporary_files() is to remove. Under the lock, as its making and its renaming.
void remember_temporary(const std::filesystem::path& path);
void forget_temporary(const std::filesystem::path& path);

}  // namespace taut
