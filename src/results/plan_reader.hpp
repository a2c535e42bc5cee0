// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "files/json_value.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

/// Reads a plan that its schema accepts.
/// @throws InputError at parts of another size than the net, or with indices that it does not have
[[nodiscard]] PlanResult read_plan(const JsonValue& root);

}  // namespace taut
