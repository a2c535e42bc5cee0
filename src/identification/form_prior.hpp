// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "taut/export/core.hpp"
#include "taut/identification/model.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// What is known of the form before any survey, docs/theory.md (form-prior): the length deviations'
/// prior, taken as normal, through the linearised statics J, and the remainder e = x - J d of the
/// training samples,
///
///   mean(e),   prior.std_dev()^2 J J' + cov(e),
///
/// with cov(e) shrunk towards its diagonal.
/// @param model of which nominal form, prior and length deviations are used
/// @param form_deviations that belong to these (3 n_I x n) [m]
/// @return without its inputs
[[nodiscard]] TAUT_CORE_EXPORT FormPrior
form_prior_of(const CableNet& net, const LengthModel& model,
              const Eigen::Ref<const Eigen::MatrixXd>& form_deviations);

/// Whether models of a net keep their form prior: its directions take (3 n_I)^2 numbers and time of
/// the third power, which a large net spends where a survey asks for it, and not before.
[[nodiscard]] TAUT_CORE_EXPORT bool keeps_form_prior(const CableNet& net);

/// What all that uses a prior relies on, to rounding.
[[nodiscard]] TAUT_CORE_EXPORT bool has_orthonormal_directions(const FormPrior& prior);

/// Makes the form prior of a model that has none, where many surveys will be asked of it.
TAUT_CORE_EXPORT void make_form_prior(const CableNet& net, LengthModel& model);

/// FormPrior::inputs of a prior that has all other parts.
[[nodiscard]] TAUT_CORE_EXPORT Eigen::MatrixXd inputs_along_directions(const LengthModel& model,
                                                                       const FormPrior& prior);

}  // namespace taut
