// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/epoch_net.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "net/weight_as_load.hpp"
#include "taut/numerical_error.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/survey/turned_net.hpp"

namespace taut {

double widest_turn(const CableNet& net) {
    constexpr double wide = 0.05;  // [m]
    constexpr double most = 0.25;  // of the shortest edge: no more may be uncertain
    const Eigen::VectorXd lengths = net.unstressed_lengths()(net.adjustable_edges());
    if (lengths.size() == 0) {
        return 0.0;
    }
    const double width = std::min(wide, most * lengths.minCoeff());
    const double digit = std::pow(10.0, std::floor(std::log10(width)));
    return digit * std::floor(width / digit);  // as one would give it
}

std::vector<EdgeTurned> turned_until(std::span<const Epoch> epochs, size_t k) {
    std::vector<std::vector<EdgeTurned>> steps;
    for (const Epoch& epoch : epochs.first(k + 1)) {
        steps.push_back(epoch.turned);
    }
    return all_turned(steps);
}

CableNet net_at_survey(const CableNet& net, std::span<const Epoch> epochs, size_t k) {
    const std::vector<EdgeTurned> turned = turned_until(epochs, k);
    if (turned.empty() && !epochs[k].is_loaded()) {
        return net;
    }
    CableNetData data =
        with_lengths_of_same_weight(net, turned_net(net, turned).unstressed_lengths());
    if (epochs[k].is_loaded()) {
        data.loads = data.loads.cols() > 0 ? Points(data.loads + epochs[k].loads) : epochs[k].loads;
    }
    const Equilibrium equilibrium = solve_equilibrium(CableNet(CableNetData(data)));
    if (!equilibrium.balanced()) {
        throw NumericalError(
            fmt::format("the net finds no equilibrium after the turns of {} edges{}", turned.size(),
                        epochs[k].is_loaded() ? " and under the loads hung on it" : ""));
    }
    data.nodes = equilibrium.form;
    return CableNet(std::move(data));
}

}  // namespace taut
