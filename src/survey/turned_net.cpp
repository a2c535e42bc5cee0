// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/turned_net.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "net/weight_as_load.hpp"

namespace taut {

void check_turned(const CableNet& net, std::span<const EdgeTurned> turned) {
    std::vector<bool> is_named(net.edge_count(), false);
    for (const EdgeTurned& one : turned) {
        if (one.edge < 0 || one.edge >= net.edge_count() ||
            !std::ranges::binary_search(net.adjustable_edges(), one.edge)) {
            throw std::invalid_argument(fmt::format(
                "edge '{}' was turned, expected an adjustable one",
                one.edge >= 0 && one.edge < net.edge_count() ? net.edge_id(one.edge)
                                                             : std::to_string(one.edge)));
        }
        if (is_named[one.edge]) {
            throw std::invalid_argument(
                fmt::format("edge '{}' is turned a second time", net.edge_id(one.edge)));
        }
        is_named[one.edge] = true;
        const double most = most_turned_part * net.unstressed_lengths()(one.edge);
        if (!(std::abs(one.stroke) <= most)) {
            throw std::invalid_argument(
                fmt::format("edge '{}' was turned by {:g} m, expected at most {:.3g} m, a quarter "
                            "of its length",
                            net.edge_id(one.edge), one.stroke, most));
        }
        if (!(one.std_dev >= 0.0 && one.std_dev <= most)) {
            throw std::invalid_argument(
                fmt::format("edge '{}' was turned with a standard deviation of {:g} m, expected 0 "
                            "to {:.3g} m, a quarter of its length",
                            net.edge_id(one.edge), one.std_dev, most));
        }
    }
}

std::vector<EdgeTurned> all_turned(std::span<const std::vector<EdgeTurned>> steps) {
    std::map<int, EdgeTurned> sum;
    for (const std::vector<EdgeTurned>& step : steps) {
        for (const EdgeTurned& one : step) {
            EdgeTurned& all = sum[one.edge];
            all = {.edge = one.edge,
                   .stroke = all.stroke + one.stroke,
                   .std_dev = std::hypot(all.std_dev, one.std_dev)};
        }
    }
    std::vector<EdgeTurned> result;
    result.reserve(sum.size());
    for (const auto& [edge, all] : sum) {
        result.push_back(all);
    }
    return result;
}

CableNet turned_net(const CableNet& net, std::span<const EdgeTurned> turned) {
    CableNetData data = with_weight_as_load(net);
    for (const EdgeTurned& one : turned) {
        data.unstressed_lengths(one.edge) += one.stroke;
    }
    return CableNet(std::move(data));
}

}  // namespace taut
