// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/identification/model.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Estimates of many length deviations at once, before any form is predicted from them.
struct LengthEstimates {
    Eigen::MatrixXd mean;  ///< m_I x k [m]
    /// m_I x k [m]. Of the true length deviation: the process's own variance (eq. sigmax_*) and its
    /// noise variance sigma_w^2, the part of the length that the form does not show to it.
    Eigen::MatrixXd std_dev;
};

/// Eq. ident for k forms: their deviations from the model's nominal form (3 n_I x k) [m]. Edges
/// whose process could not be fitted get the prior's mean and standard deviation. That the model is
/// of this net is not checked: check_model() does.
/// @throws std::invalid_argument for deviations of another size than 3 n_I, or not finite
[[nodiscard]] TAUT_CORE_EXPORT LengthEstimates
estimate_lengths(const CableNet& net, const LengthModel& model,
                 const Eigen::Ref<const Eigen::MatrixXd>& form_deviations);

}  // namespace taut
