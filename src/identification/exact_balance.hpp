// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Lengths from an exact survey of all free nodes, where the prior matters for slack edges only:
/// the balance of its form, h = 0 (eq. hq), is linear in 1/l_0, and solved by sparse least squares,
/// docs/theory.md (balance). The status reports a survey that is not exact: no lengths give its
/// form.
[[nodiscard]] Identification identify_by_exact_balance(const CableNet& net, const Survey& survey,
                                                       const LengthPrior& prior);

/// Exactness alone: whether lengths within the prior's reach give the form. For methods that cannot
/// show it.
/// @return status and message; edges and predicted form are those of the balance
[[nodiscard]] Identification check_exactness(const CableNet& net, const Survey& survey,
                                             const LengthPrior& prior);

}  // namespace taut
