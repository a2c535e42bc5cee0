// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/export/core.hpp"
#include "taut/identification/model.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What is known of the form before any survey, docs/theory.md (form-prior): the length deviations'
/// law, taken as normal, through the linearised statics J, and the remainder e = x - J d of the
/// training samples,
///
///   mean(e),   law.std()^2 J J' + cov(e),
///
/// with cov(e) shrunk towards its diagonal.
/// @param model of which nominal form, law and length deviations are used
/// @param form_deviations that belong to these (3 n_I x n) [m]
/// @return without its inputs
[[nodiscard]] TAUT_CORE_EXPORT FormPrior
form_prior_of(const CableNet& net, const LengthModel& model,
              const Eigen::Ref<const Eigen::MatrixXd>& form_deviations);

/// What all that uses a prior relies on, to rounding.
[[nodiscard]] TAUT_CORE_EXPORT bool has_orthonormal_directions(const FormPrior& prior);

/// FormPrior::inputs of a model that has all other parts of its form prior.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd inputs_along_directions(const LengthModel& model);

}  // namespace taut
