// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "taut/net/cable_net.hpp"

namespace taut {

/// The indices of all nodes by CableNet::node_id().
[[nodiscard]] inline std::map<std::string, int> nodes_by_name(const CableNet& net) {
    std::map<std::string, int> node_of;
    for (int node = 0; node < net.node_count(); ++node) {
        node_of.emplace(net.node_id(node), node);
    }
    return node_of;
}

}  // namespace taut
