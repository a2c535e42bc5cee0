// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "files/json_value.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

/// Simulated jobs that their schema accepts.
/// @throws InputError where rounds or states are other than one a round, and one a trial and round
[[nodiscard]] ControlResult read_control(const JsonValue& root);

}  // namespace taut
