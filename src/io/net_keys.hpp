// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace taut {

inline constexpr std::string_view net_format = "taut-net";
inline constexpr int net_version = 1;

/// The keys that the native net format gives a meaning.
inline constexpr std::array<std::string_view, 28> net_keys{"format",
                                                           "version",
                                                           "name",
                                                           "nodes",
                                                           "supports",
                                                           "edges",
                                                           "axial_stiffness",
                                                           "unstressed_lengths",
                                                           "adjustable",
                                                           "loads",
                                                           "node_ids",
                                                           "edge_ids",
                                                           "tension_laws",
                                                           "tension_law",
                                                           "groups",
                                                           "mass",
                                                           "expansion",
                                                           "breaking_load",
                                                           "bending_stiffness",
                                                           "cable_ends",
                                                           "thread",
                                                           "runs",
                                                           "support_stiffness",
                                                           "support_place",
                                                           "support_couplings",
                                                           "kind",
                                                           "buckling_load",
                                                           "sag_weight"};

constexpr bool is_net_key(std::string_view key) {
    return std::ranges::find(net_keys, key) != net_keys.end();
}

}  // namespace taut
