// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/abi.hpp"
#include "taut/export/core.hpp"

namespace taut {

/// l_0 = l / (1 + T/EA): the lengths to cut edges to, so that they carry the tensions T when
/// stretched to the lengths l; negative tensions are those of compressed struts. All arguments have
/// one entry an edge; lengths [m], forces [N].
/// @throws std::invalid_argument for sizes that differ, lengths or stiffnesses that are not
///   positive and finite, or tensions that are not finite or not above -EA.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd unstressed_lengths_for(
    const Eigen::Ref<const Eigen::VectorXd>& lengths,
    const Eigen::Ref<const Eigen::VectorXd>& tensions,
    const Eigen::Ref<const Eigen::VectorXd>& axial_stiffness);

}  // namespace taut
