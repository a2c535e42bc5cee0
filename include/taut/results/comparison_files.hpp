// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/export/io.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/comparison.hpp"

namespace taut {

/// comparison.json: format "taut-comparison", version 2; all numbers in SI units. Numbers that the
/// method of a row does not give are null.
[[nodiscard]] TAUT_IO_EXPORT std::string comparison_to_json(const Comparison& comparison,
                                                            const RunRecord& run = {});

/// Its rows as a table with the same names; null is an empty field.
[[nodiscard]] TAUT_IO_EXPORT std::string comparison_to_csv(const Comparison& comparison);

}  // namespace taut
