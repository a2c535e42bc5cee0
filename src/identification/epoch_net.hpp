// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "taut/identification/epochs.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What was turned until a survey, together.
[[nodiscard]] std::vector<EdgeTurned> turned_until(std::span<const Epoch> epochs, size_t k);

/// The net at a survey, turned and loaded, with its nodes in equilibrium: a fit begins there.
/// @throws std::runtime_error where it finds no equilibrium
[[nodiscard]] CableNet net_at_survey(const CableNet& net, std::span<const Epoch> epochs, size_t k);

/// Standard deviation of the length of an adjustable edge that nothing is known of [m].
[[nodiscard]] double widest_turn(const CableNet& net);

}  // namespace taut
