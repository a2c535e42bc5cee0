// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "taut/net/cable_net.hpp"

namespace taut {

/// The supports on the rigid frame, then the elastic ones.
[[nodiscard]] inline std::vector<int> all_supports(const CableNetData& data) {
    std::vector<int> result = data.supports;
    for (const ElasticSupport& support : data.elastic_supports) {
        result.push_back(support.node);
    }
    return result;
}
[[nodiscard]] inline std::vector<int> all_supports(const CableNet& net) {
    return all_supports(net.data());
}

/// Whether a node is on the frame, rigid or elastic.
[[nodiscard]] inline bool is_support(const CableNet& net, int node) {
    return net.free_index(node) < 0 ||
           std::ranges::find(net.elastic_supports(), node, &ElasticSupport::node) !=
               net.elastic_supports().end();
}

/// Places of all of these, of elastic ones without load (3 x count) [m].
[[nodiscard]] inline Points places_without_load(const CableNet& net) {
    Points result(3, std::ssize(net.supports()) + std::ssize(net.elastic_supports()));
    Eigen::Index next = 0;
    for (const int node : net.supports()) {
        result.col(next++) = net.nodes().col(node);
    }
    for (const ElasticSupport& support : net.elastic_supports()) {
        result.col(next++) = support.place;
    }
    return result;
}

}  // namespace taut
