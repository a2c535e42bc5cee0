// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// A net as it might be built, for simulations: the unstressed lengths of its interior edges drawn
/// from a prior, all else as designed. It differs from all samples that a Sampler draws with this
/// seed.
/// @throws std::invalid_argument as check_prior()
[[nodiscard]] TAUT_CORE_EXPORT CableNet built_net(const CableNet& net, const LengthPrior& prior,
                                                  std::uint64_t seed);

}  // namespace taut
