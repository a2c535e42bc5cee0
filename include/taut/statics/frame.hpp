// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The stiffness of a frame, condensed to the nodes of a net that it supports.
struct FrameStiffness {
    std::vector<int> supports;  ///< k nodes of the net
    /// K, 3k x 3k: the force at x, y, z of each support by a shift of each. Symmetric to a
    /// millionth of its largest entry, and positive definite [N/m].
    Eigen::MatrixXd stiffness;
};

/// The net on this frame: its supports among those of the frame become elastic ones that pass
/// forces on to each other. Springs that they have are replaced. They stand where the frame
/// balances the nominal form.
/// @throws std::invalid_argument for a node that is no support, comes twice or stands on a frame
///   already, and for a stiffness of another size, that is not finite or not symmetric
/// @throws NetError for one that is not positive definite
[[nodiscard]] TAUT_CORE_EXPORT CableNet on_frame(const CableNet& net, const FrameStiffness& frame);

}  // namespace taut
