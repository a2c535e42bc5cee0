// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/control.hpp"

namespace taut {

/// control.json: format "taut-control", version 2; all numbers in SI units. One entry per strategy,
/// with the means of each round, and one per trial and round.
[[nodiscard]] TAUT_IO_EXPORT std::string control_to_json(const std::vector<ControlRecord>& records,
                                                         const CableNet& net,
                                                         const ControlSettings& settings,
                                                         const RunRecord& run = {});

/// One row per strategy, trial and round, with the same names.
[[nodiscard]] TAUT_IO_EXPORT std::string control_to_csv(const std::vector<ControlRecord>& records);

}  // namespace taut
