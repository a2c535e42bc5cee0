// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "taut/export/core.hpp"
#include "taut/identification/model.hpp"

namespace taut {

/// Models with several settings on the same samples, trained in one: the decompositions are of the
/// inputs alone, and serve all. They have no form priors, and so are for exact and whole surveys.
/// @param settings all with the isotropic kernel; their `fit` is not looked at
/// @throws as train_model()
[[nodiscard]] TAUT_CORE_EXPORT std::vector<LengthModel> train_together(
    const CableNet& net, const DataSet& data, const std::vector<int>& samples,
    const std::vector<TrainingSettings>& settings, const Progress& progress = {});

}  // namespace taut
