// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "files/json_value.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

/// Reads simulated jobs that their schema accepts.
/// @throws InputError where there is not one entry per round, and one per trial and round
[[nodiscard]] ControlResult read_control(const JsonValue& root);

}  // namespace taut
