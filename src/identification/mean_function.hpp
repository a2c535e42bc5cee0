// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/identification/model.hpp"

namespace taut {

/// Values of a mean function at k forms (m_I x k) [m], of the interior edges:
///   geometry: nominal l_0 (l(r) / l(nominal r) - 1), so that the strain is the nominal one.
/// @param nominal_form r_I that form deviations refer to (3 n_I) [m]
/// @param form_deviations 3 n_I x k [m]
[[nodiscard]] Eigen::MatrixXd mean_values(const CableNet& net, MeanFunction mean,
                                          const Eigen::Ref<const Eigen::VectorXd>& nominal_form,
                                          const Eigen::Ref<const Eigen::MatrixXd>& form_deviations);

/// Derivative of the interior edges' lengths with respect to the free coordinates (m_I x 3 n_I).
[[nodiscard]] Eigen::MatrixXd length_gradient(const CableNet& net,
                                              const Eigen::Ref<const Points>& form);

/// Derivative of the mean function's values at one form (m_I x 3 n_I).
[[nodiscard]] Eigen::MatrixXd mean_gradient(
    const CableNet& net, MeanFunction mean, const Eigen::Ref<const Eigen::VectorXd>& nominal_form,
    const Eigen::Ref<const Eigen::VectorXd>& form_deviation);

}  // namespace taut
