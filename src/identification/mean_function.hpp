// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>

#include "taut/identification/model.hpp"

namespace taut {

/// Values of a mean function at k forms (m_I x k) [m], of the interior edges:
///   geometry: nominal l_0 (l(r) / l(nominal r) - 1), so that the strain is the nominal one.
/// @param nominal_form r_I that form deviations refer to (3 n_I) [m]
/// @param form_deviations 3 n_I x k [m]
[[nodiscard]] Eigen::MatrixXd mean_values(const CableNet& net, MeanFunction mean,
                                          const Eigen::Ref<const Eigen::VectorXd>& nominal_form,
                                          const Eigen::Ref<const Eigen::MatrixXd>& form_deviations);

/// One row an edge: zero but at the coordinates of its ends.
using EdgeGradient = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Derivative of the interior edges' lengths with respect to the free coordinates (m_I x 3 n_I).
[[nodiscard]] EdgeGradient length_gradient(const CableNet& net,
                                           const Eigen::Ref<const Points>& form);

/// What length_gradient() of an edge is to be multiplied by for the derivative of the mean
/// function's value (m_I).
[[nodiscard]] Eigen::VectorXd mean_rates(const CableNet& net, MeanFunction mean,
                                         const Eigen::Ref<const Eigen::VectorXd>& nominal_form);

}  // namespace taut
