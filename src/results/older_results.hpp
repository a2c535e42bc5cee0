// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

namespace taut {

/// Converts a result of version 1 (taut 0.1 and 0.2) to the keys of version 2:
/// docs/compatibility.md. Misplaced keys stay as they are, and the schema refuses them.
/// @param root an object with a known "format"
[[nodiscard]] nlohmann::json with_new_keys(nlohmann::json root);

}  // namespace taut
