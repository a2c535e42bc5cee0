// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "identification/epoch_chain.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/trust.hpp"

namespace taut {

/// Reports surveys with the same errors, which would count twice.
/// @param chain of the surveys, converged
void add_repeats(Trust& trust, const EpochChain& chain);

}  // namespace taut
