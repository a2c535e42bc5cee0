// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "files/json_value.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

// Readers of documents that their schema accepts. All throw InputError at parts of another size
// than the net, with indices that it does not have, or that contradict others.

[[nodiscard]] IdentificationResult read_identification(const JsonValue& root);
[[nodiscard]] PlanResult read_plan(const JsonValue& root);
[[nodiscard]] ControlResult read_control(const JsonValue& root);

}  // namespace taut
