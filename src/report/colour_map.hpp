// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace taut::report {

/// A colour of the map "viridis", which grows evenly brighter and is read alike with every kind of
/// colour vision: dark violet at 0, yellow at 1.
/// @param position in [0, 1]; outside, the nearer end
/// @return "#rrggbb"
[[nodiscard]] std::string viridis(double position);

}  // namespace taut::report
