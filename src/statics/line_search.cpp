// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/line_search.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr double armijo = 1e-4;
constexpr int max_trials = 60;

/// A slope below this share of the elastic energy predicts a decrease below the rounding errors of
/// the energy.
constexpr double drowned_slope = 1e-13;

}  // namespace

LineSearchStep search_line(const LocalNet& net, const NetState& state,
                           const Eigen::VectorXd& direction, NetState& trial) {
    const Eigen::Index n = direction.size();
    const double slope = state.forces().dot(direction);
    const bool drowned = -slope <= drowned_slope * state.stretch_energy();
    double length = 1.0;
    for (int k = 0; k < max_trials; ++k) {
        trial.form().reshaped().head(n) = state.form().reshaped().head(n) + length * direction;
        trial.update(net);
        const double trial_slope = trial.forces().dot(direction);
        const double decrease = -trial.energy_above(state, net);
        // Where V is convex and still falls at the trial point, it fell all the way. This test
        // needs no difference of energies, so it works if rounding errors hide the decrease. If
        // they hide any decrease, the smaller slope is better. Otherwise the Armijo rule decides.
        if ((net.is_convex() && trial_slope <= 0.0) || decrease >= -armijo * length * slope ||
            (drowned && std::abs(trial_slope) <= -slope)) {
            return {.accepted = std::isfinite(trial_slope),
                    .length = length,
                    .energy_decrease = decrease};
        }
        // Zero of the slope by the secant through both ends, kept away from them.
        const double root = slope / (slope - trial_slope);
        length *= std::isfinite(root) ? std::clamp(root, 0.01, 0.7) : 0.01;
    }
    return {};
}

}  // namespace taut
