// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/export/io.hpp"
#include "taut/results/results_json.hpp"
#include "taut/study/comparison.hpp"

namespace taut {

/// comparison.json: format "taut-comparison", version 1; all numbers in SI units. Numbers that a
/// row does not have, since its method gave none, are null.
[[nodiscard]] TAUT_IO_EXPORT std::string comparison_to_json(const Comparison& comparison,
                                                            const RunRecord& run = {});

/// The rows of it as a table, with the same names; what is null there is empty here.
[[nodiscard]] TAUT_IO_EXPORT std::string comparison_to_csv(const Comparison& comparison);

}  // namespace taut
