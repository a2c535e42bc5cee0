// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/identification/model.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Normal distribution of the free coordinates' deviations from the nominal form.
struct FormDistribution {
    Eigen::VectorXd mean;        ///< 3 n_I [m]
    Eigen::MatrixXd covariance;  ///< 3 n_I x 3 n_I [m2]
};

/// What is known of the form before any survey: the length deviations' law, taken as normal,
/// through the linearised statics J, and the remainder e = x - J d of the model's training samples:
///   mean(e),   law.std()^2 J J' + cov(e).
/// Thus the error of the linearisation is known for what it is (Kaipio and Somersalo's
/// approximation error). cov(e) is shrunk towards its diagonal, by as much as the number of samples
/// asks for (Schaefer and Strimmer 2005, target D): a sample covariance of fewer samples than
/// coordinates denies most directions any remainder at all.
[[nodiscard]] FormDistribution form_before_survey(const CableNet& net, const LengthModel& model);

}  // namespace taut
