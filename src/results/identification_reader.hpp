// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "files/json_value.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

/// Reads an identification that its schema accepts.
/// @throws InputError at parts of another size than the net, with indices that it does not have, or
///   that contradict the rest
[[nodiscard]] IdentificationResult read_identification(const JsonValue& root);

}  // namespace taut
