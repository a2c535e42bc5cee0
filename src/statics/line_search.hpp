// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "statics/net_state.hpp"

namespace taut {

struct LineSearchStep {
    bool accepted = false;
    double length = 0.0;           ///< alpha, of the direction
    double energy_decrease = 0.0;  ///< V(r) - V(r + alpha d) >= 0 up to rounding errors [J]
};

/// Finds a step alpha in (0, 1] along a descent direction d (3 n_I) that lowers the energy, and
/// leaves the net at r + alpha d in `trial`. Does not allocate.
[[nodiscard]] LineSearchStep search_line(const LocalNet& net, const NetState& state,
                                         const Eigen::VectorXd& direction, NetState& trial);

}  // namespace taut
