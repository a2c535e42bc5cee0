// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/net/cable_net.hpp"

namespace taut {

/// The data of a net with the self-weight of its edges among the loads. So a net that is made of
/// it has the weight of this one, whatever lengths it gets: a turned edge is no heavier.
inline CableNetData with_weight_as_load(const CableNet& net) {
    CableNetData data = net.data();
    data.loads = net.loads();
    data.mass.resize(0);
    return data;
}

}  // namespace taut
