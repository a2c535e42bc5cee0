// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/abi.hpp"
#include "taut/export/adjustment.hpp"

namespace taut {

/// Statistics of the errors e_i(k) = true - estimated length deviation (eq. ei) of m_I interior
/// edges over n_v validation samples, as the paper defines them.
struct LengthErrors {
    Eigen::VectorXd mean;  ///< mean(e_i) over the samples (m_I), eq. m_ei [m]
    Eigen::VectorXd std;   ///< std(e_i) over the samples (m_I), divisor n_v, eq. std [m]
    double mse = 0.0;      ///< eq. MSE [m2]
    /// Eq. MRSE: over the edges, the mean of sum_k e_i^2 / sum_k true_i^2. Edges that never deviate
    /// are left out of the mean.
    double mrse = 0.0;

    /// max_i |mean(e_i)|; that there is an edge is not checked [m].
    [[nodiscard]] double mean_max_abs() const { return mean.cwiseAbs().maxCoeff(); }
    /// Mean of std(e_i) over the edges; likewise [m].
    [[nodiscard]] double std_mean() const { return std.mean(); }
};

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

/// The four numbers of the paper's table of form errors [m].
struct FormErrorSummary {
    double max = 0.0;   ///< the largest distance of a node
    double min = 0.0;   ///< the smallest
    double mean = 0.0;  ///< over the free nodes
    double rmse = 0.0;  ///< root of the mean square
};

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
