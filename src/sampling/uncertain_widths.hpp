// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// check_uncertain_parameters() for what has one survey.
/// @throws std::invalid_argument likewise, and for a creep
TAUT_CORE_EXPORT void check_for_one_survey(const CableNet& net,
                                           const std::vector<UncertainParameter>& uncertain);

/// Adds slips, where runs of the net slide and none are given: 0.1 m, at most a tenth of the
/// shortest edge that slides, so that nothing is assumed of them.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<UncertainParameter> with_slips(
    const CableNet& net, std::vector<UncertainParameter> given);

/// The edges that a stiffness, temperature or creep applies to, ascending: those of its group, or
/// all.
/// @throws std::out_of_range for a group that the net does not have
[[nodiscard]] TAUT_CORE_EXPORT std::vector<int> edges_of(const CableNet& net,
                                                         const UncertainParameter& parameter);

/// The standard deviation of one kind; 0 where it is exact.
[[nodiscard]] TAUT_CORE_EXPORT double std_of(const std::vector<UncertainParameter>& uncertain,
                                             UncertainParameter::Kind kind);

/// Standard deviation of each edge's own stiffness, relative (m); 0 where it is exact.
/// @throws std::out_of_range as edges_of()
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd own_stiffness_stds(
    const CableNet& net, const std::vector<UncertainParameter>& uncertain);

}  // namespace taut
