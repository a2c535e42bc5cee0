// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

namespace taut {

/// A result of version 1 (taut 0.1 and 0.2) under the keys of version 2: docs/compatibility.md.
/// What is not where it should be stays, for the schema to refuse.
/// @param root an object with a known "format"
[[nodiscard]] nlohmann::json with_new_keys(nlohmann::json root);

}  // namespace taut
