// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/imbalance.hpp"

#include <cmath>
#include <limits>

#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

double Imbalance::share() const {
    if (largest == 0.0) {
        return 0.0;
    }
    return mean_tension > 0.0 ? largest / mean_tension : std::numeric_limits<double>::infinity();
}

Imbalance imbalance_of(const CableNet& net,
                       const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                       const Eigen::Ref<const Points>& form) {
    const Eigen::VectorXd forces = out_of_balance_forces(net, unstressed_lengths, form);
    Eigen::VectorXd tension = tensions_of(net, unstressed_lengths, form);
    const bool has_taut_cable = (mean_weights(net).array() * tension.array() > 0.0).any();
    for (int e = 0; e < net.edge_count(); ++e) {
        if (net.is_strut(e)) {
            tension(e) = has_taut_cable ? 0.0 : std::abs(tension(e));
        }
    }
    const auto taut_count = static_cast<double>((tension.array() > 0.0).count());
    return {.largest = forces.reshaped(3, net.free_node_count()).colwise().norm().maxCoeff(),
            .mean_tension = taut_count > 0.0 ? tension.sum() / taut_count : 0.0};
}

}  // namespace taut
