// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/settling.hpp"

namespace taut {

/// trials.json: format "taut-trials", version 1; all numbers in SI units. One entry a net, with one
/// a survey in it.
[[nodiscard]] TAUT_IO_EXPORT std::string settling_to_json(
    const std::vector<SettlingRecord>& records, const SettlingSettings& settings,
    const RunRecord& run = {});

/// One row a survey, with the same names.
[[nodiscard]] TAUT_IO_EXPORT std::string settling_to_csv(const std::vector<SettlingRecord>& records,
                                                         const SettlingSettings& settings);

}  // namespace taut
