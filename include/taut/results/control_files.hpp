// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/control.hpp"

namespace taut {

/// control.json: format "taut-control", version 1; all numbers in SI units. One entry a strategy,
/// with means by round, and one a trial and round.
[[nodiscard]] TAUT_IO_EXPORT std::string control_to_json(const std::vector<ControlRecord>& records,
                                                         const CableNet& net,
                                                         const ControlSettings& settings,
                                                         const RunRecord& run = {});

/// One row a strategy, trial and round, with the same names.
[[nodiscard]] TAUT_IO_EXPORT std::string control_to_csv(const std::vector<ControlRecord>& records);

}  // namespace taut
