// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// How much longer tension makes edges at the net's nodes, negative in compressed struts (m): of a
/// straight edge l - l_0, 0 where slack, of a cable that sags T l_0 / EA [m].
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd elastic_stretches(const CableNet& net);

/// elastic_stretches() of cables in the mean [m].
[[nodiscard]] TAUT_CORE_EXPORT double mean_stretch(const CableNet& net);

}  // namespace taut
