// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/result.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Lengths from an exact survey of all free nodes, which leaves the prior nothing to say but of
/// slack edges: the balance of its form, h = 0 (eq. hq), is linear in 1/l_0, and solved by sparse
/// least squares, docs/theory.md (balance). A survey that is not exact, though it is taken for it,
/// is told by the status: its form is that of no lengths.
[[nodiscard]] Identification identify_by_exact_balance(const CableNet& net, const Survey& survey,
                                                       const LengthPrior& prior);

/// The same question of exactness alone, without what the form tells of single lengths: whether
/// lengths within the prior's reach give it. For methods that cannot tell.
/// @return status and message; edges and predicted form are those of the balance
[[nodiscard]] Identification check_exactness(const CableNet& net, const Survey& survey,
                                             const LengthPrior& prior);

}  // namespace taut
