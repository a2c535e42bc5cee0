// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/adjustment.hpp"
#include "taut/study/error_statistics.hpp"

namespace taut {

/// The statistics of estimates whose truth is known.
/// @param truth, estimate length deviations (m_I x n_v) [m]
/// @throws std::invalid_argument for sizes that differ or are zero
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT LengthErrors
length_errors(const Eigen::Ref<const Eigen::MatrixXd>& truth,
              const Eigen::Ref<const Eigen::MatrixXd>& estimate);

/// Distances |r_i - r'_i| at the free nodes between two forms (eq. enomident).
/// @param coordinates, other r_I of both (3 n_I) [m]
/// @return n_I [m]
/// @throws std::invalid_argument for sizes that differ or are no multiple of 3
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT Eigen::VectorXd node_distances(
    const Eigen::Ref<const Eigen::VectorXd>& coordinates,
    const Eigen::Ref<const Eigen::VectorXd>& other);

/// The four numbers of one form.
/// @param distances at the free nodes (n_I), at least one [m]
/// @throws std::invalid_argument where there is none
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT FormErrorSummary
summarise(const Eigen::Ref<const Eigen::VectorXd>& distances);

/// Adds one of `count` summaries to the mean of each of their numbers.
/// @param mean 0 throughout at first
/// @param count positive
TAUT_ADJUSTMENT_EXPORT void add_to_mean(FormErrorSummary& mean, const FormErrorSummary& summary,
                                        int count);

}  // namespace taut
