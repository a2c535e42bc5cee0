// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/identification/model.hpp"

namespace taut::app {

/// train(), shown on a terminal and stopped by an interruption (taut::Interrupted).
[[nodiscard]] LengthModel train_with_progress(const CableNet& net, const DataSet& data,
                                              const std::vector<int>& samples,
                                              TrainingSettings settings, bool quiet);

}  // namespace taut::app
