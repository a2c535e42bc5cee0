// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/sampling/length_prior.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// Posterior variances of the length deviations (m_I) [m2], linearised at given lengths and their
/// form: the diagonal of (J' S J + I / prior.std_dev()^2)^-1 with J = dr_I/dl_0 and S the weights 1
/// / noise_std^2 of the surveyed coordinates. At the truth they are the mean squared errors that no
/// method on average falls below, to first order and but for the shape of the prior.
/// @param unstressed_lengths l_0 of all edges (m) [m]
/// @param form their equilibrium (3 x n) [m]
/// @param survey which nodes, and their noise; its form is not used
/// @throws std::invalid_argument as tensions_of() and LengthPrior::check()
/// @throws SurveyError as check_survey()
/// @throws std::runtime_error where the statics are singular at this form: a slack mechanism
[[nodiscard]] TAUT_CORE_EXPORT Eigen::VectorXd cramer_rao_variances(
    const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
    const Eigen::Ref<const Points>& form, const Survey& survey, const LengthPrior& prior);

}  // namespace taut
