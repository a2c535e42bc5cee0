// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/line_search.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

constexpr double armijo = 1e-4;
constexpr int max_trials = 60;

/// A slope below this part of the energy stored in the edges promises a decrease that drowns in the
/// rounding errors of the energy.
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
        // V is convex, so it fell all the way to a point where it still falls: this needs no
        // difference of energies, and so holds when rounding hides the decrease. Where that hides
        // any, the smaller slope is the better form. Otherwise Armijo.
        if (trial_slope <= 0.0 || decrease >= -armijo * length * slope ||
            (drowned && trial_slope <= -slope)) {
            return {.accepted = std::isfinite(trial_slope),
                    .length = length,
                    .energy_decrease = decrease};
        }
        // Root of the slope by the secant through both ends, kept away from them.
        const double root = slope / (slope - trial_slope);
        length *= std::isfinite(root) ? std::clamp(root, 0.01, 0.7) : 0.01;
    }
    return {};
}

}  // namespace taut
