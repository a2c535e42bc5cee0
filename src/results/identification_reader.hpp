// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "files/json_value.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

/// An identification that its schema accepts.
/// @throws InputError at what is of another size than the net, names what it does not have, or
///   contradicts the rest
[[nodiscard]] IdentificationResult read_identification(const JsonValue& root);

}  // namespace taut
