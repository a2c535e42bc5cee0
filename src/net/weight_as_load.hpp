// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"

namespace taut {

/// The data of a net with the self-weight of its edges moved to the loads. A net made from it keeps
/// this weight whatever lengths it gets: turning an edge does not change its mass.
inline CableNetData with_weight_as_load(const CableNet& net) {
    CableNetData data = net.data();
    data.loads = net.loads();
    data.mass.resize(0);
    return data;
}

/// The data of a net with other lengths, whose edges weigh as much as before.
inline CableNetData with_lengths_of_same_weight(const CableNet& net,
                                                const Eigen::VectorXd& unstressed_lengths) {
    CableNetData data = net.data();
    data.unstressed_lengths = unstressed_lengths;
    if (data.mass.size() > 0) {
        data.mass =
            data.mass.cwiseProduct(net.unstressed_lengths().cwiseQuotient(unstressed_lengths));
    }
    return data;
}

/// The self-weight of the edges, as loads (3 x n) [N].
inline Points self_weight(const CableNet& net) {
    const Points& loads = net.data().loads;
    return loads.cols() > 0 ? Points(net.loads() - loads) : net.loads();
}

}  // namespace taut
