// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/study/comparison.hpp"

namespace taut::app {

/// A table for each axis of a comparison, as text.
[[nodiscard]] std::string comparison_table(const Comparison& comparison);

}  // namespace taut::app
