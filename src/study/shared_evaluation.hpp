// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "study/evaluation.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// The result of evaluate(), with the surveys shared among the processes of the group.
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT MethodResult
evaluate_together(const CableNet& net, const Method& method, const std::vector<Trial>& trials,
                  const Progress& progress);

}  // namespace taut
