// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/linearised_statics.hpp"

namespace taut {

struct GaussNewtonResult {
    Guess guess;
    bool converged = false;
    int iterations = 0;
};

/// Goes from a start to the form and lengths that fit all knowledge best under the statics (see
/// ConditionedStatics), until a step changes no place and no length by more than the tolerance [m].
/// The statics are left linearised at the result, to the tolerance.
/// @throws std::runtime_error where no factor is found
[[nodiscard]] GaussNewtonResult fit_under_statics(ConditionedStatics& statics,
                                                  const Knowledge& knowledge, Guess start,
                                                  double tolerance, int max_iterations);

}  // namespace taut
