// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/marginal_mode.hpp"

#include <Eigen/LU>
#include <limits>
#include <utility>

namespace taut {

DeterminantSlope::DeterminantSlope(const LinearisedFit& fitted, const Observations& observations)
    : m_fitted(&fitted),
      m_observations(&observations),
      m_determinant(fitted.linearisation.half_log_determinant(observations)) {}

double DeterminantSlope::change(const Observations& moved) {
    const Iterate there =
        m_fitted->iterate.moved(m_fitted->linearisation.step(m_fitted->iterate, moved));
    m_last = linearise(m_fitted->model(), there, *m_observations, std::move(m_last));
    return m_last ? m_last->half_log_determinant(*m_observations) - m_determinant
                  : std::numeric_limits<double>::quiet_NaN();
}

Observations with_marginal_mode(const LinearisedFit& fitted, Observations observations, int count) {
    DeterminantSlope slope(fitted, observations);
    // A mean moved by 1 moves the parameter by its posterior variance.
    Eigen::VectorXd shift(count);
    for (int k = 0; k < count; ++k) {
        Observations moved = observations;
        moved.common_mean(k) += 1.0;
        shift(k) = -slope.change(moved);
    }
    const Eigen::MatrixXd covariance = fitted.covariance.common.topLeftCorner(count, count);
    const Eigen::VectorXd by = covariance.inverse() * shift;  // (marginal-mode)
    if (by.allFinite()) {
        observations.common_mean.head(count) += by;
    }
    return observations;
}

}  // namespace taut
