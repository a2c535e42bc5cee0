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
    Eigen::VectorXd mean;     ///< mean(e_i) over the samples (m_I), eq. m_ei [m]
    Eigen::VectorXd std_dev;  ///< std(e_i) over the samples (m_I), divisor n_v, eq. std [m]
    double mse = 0.0;         ///< eq. MSE [m2]
    /// Eq. MRSE: over the edges, the mean of sum_k e_i^2 / sum_k true_i^2. Edges that never deviate
    /// are left out of the mean.
    double mrse = 0.0;

    /// max_i |mean(e_i)|; that there is an edge is not checked [m].
    [[nodiscard]] double mean_max_abs() const { return mean.cwiseAbs().maxCoeff(); }
    /// Mean of std(e_i) over the edges; likewise [m].
    [[nodiscard]] double std_mean() const { return std_dev.mean(); }
};

/// The four numbers of the paper's table of form errors [m].
struct FormErrorSummary {
    double max = 0.0;   ///< the largest distance of a node
    double min = 0.0;   ///< the smallest
    double mean = 0.0;  ///< over the free nodes
    double rmse = 0.0;  ///< root of the mean square
};

}  // namespace taut
