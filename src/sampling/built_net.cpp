// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/sampling/built_net.hpp"

#include "net/weight_as_load.hpp"
#include "taut/sampling/data_set.hpp"

namespace taut {

CableNet built_net(const CableNet& net, const LengthPrior& prior, std::uint64_t seed) {
    check_prior(net, prior);
    constexpr std::uint64_t after_all_samples = std::uint64_t{1} << 63U;
    CableNetData data = with_weight_as_load(net);
    data.unstressed_lengths = with_length_deviations(
        net, draw_length_deviations(prior, seed, after_all_samples, net.interior_edge_count()));
    return CableNet(std::move(data));
}

}  // namespace taut
