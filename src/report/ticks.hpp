// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace taut::report {

/// Where an axis is marked.
struct Ticks {
    std::vector<double> values;       ///< ascending multiples of the step
    std::vector<std::string> labels;  ///< of each value, all with as many decimals
};

/// The multiples of 1, 2 or 5 times a power of ten in [low, high]: the smallest such step that
/// gives at most `intervals` intervals. An empty or reversed range gives no ticks.
/// @param smallest_step no step below it: 1 for an axis that counts; 0 for none
[[nodiscard]] Ticks nice_ticks(double low, double high, int intervals, double smallest_step = 0.0);

/// Of a logarithmic axis over [10^low, 10^high]: marks at powers of ten and, the fewer of them
/// there are, at multiples of these. The values are logarithms.
[[nodiscard]] Ticks decade_ticks(double low, double high);

}  // namespace taut::report
