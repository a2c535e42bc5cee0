// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// Nodes at which a net, as given, is not in equilibrium though it is at all others: a cable or a
/// load may be missing there.
struct NetImbalance {
    std::vector<int> nodes;  ///< free ones, ascending
    double largest = 0.0;    ///< force out of balance at one of them [N]
    double share = 0.0;      ///< of the mean tension
};

/// @return empty where the net is in equilibrium, and where it is nowhere, since its places are
/// then
///   a first guess
[[nodiscard]] std::optional<NetImbalance> local_imbalance(const CableNet& net);

/// One sentence.
[[nodiscard]] std::string to_text(const CableNet& net, const NetImbalance& found);

}  // namespace taut
