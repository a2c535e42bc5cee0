// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "estimation/hypotheses.hpp"
#include "taut/estimation/outlier.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/forces.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// A gross error of each target and of each force measurement, and one of all of these together.
/// @param survey with its supports as targets; where it is exact there is no test
/// @param false_alarm_rate of all these tests together; 0: no test
[[nodiscard]] std::vector<Hypothesis> measurement_hypotheses(
    const Survey& survey, const std::vector<ForceMeasurement>& forces, double false_alarm_rate);

/// Posterior covariance C of a node's place [m2].
using FormCovariance = std::function<Eigen::Matrix3d(int node)>;

/// Tests each target at a fit. With the residual e of a target, its noise Sigma and the posterior
/// covariance C of its node's place,
///
///   T = e' Q^-1 e,   Q = Sigma - C in use,   Sigma + C rejected,
///
/// has a chi-squared distribution of three degrees of freedom where there is no gross error.
/// docs/theory.md, (snooping). Where the median of all is significantly too large, the noise given
/// is too small, and all are divided by the median's scale, (robust-scale).
/// @param noise positive where surveyed (3 x n) [m]
/// @param inflation factor on the noise that the fit was made with; where above 1, the scale of
///   the residuals always follows from the median of the statistics, but is no smaller than that of
///   the true noise. docs/theory.md, (continuation)
void test_targets(Hypotheses& hypotheses, const Survey& survey, const Points& noise,
                  const Points& fitted_form, const FormCovariance& covariance,
                  double inflation = 1.0);

/// Posterior variance of a weighted sum of measured tensions, weights by edge (m) [N2 of the
/// weights].
using SumVariance = std::function<double(const Eigen::VectorXd& weights)>;

/// The same, after it, of each force measurement, with one degree of freedom, and of all of them
/// together: whether they fit only if each is off by the same part, (common-bias).
/// @param tensions measured ones by the fit, with the error that they share (m) [N]
/// @param variances of these, posterior (m) [N2]
void test_forces(Hypotheses& hypotheses, const std::vector<ForceMeasurement>& forces,
                 const Eigen::VectorXd& tensions, const Eigen::VectorXd& variances,
                 const SumVariance& sum_variance, double inflation = 1.0);

/// The rejected targets, the largest statistic first.
/// @param noise as test_targets()
[[nodiscard]] std::vector<Outlier> target_outliers(const Hypotheses& hypotheses,
                                                   const Survey& survey, const Points& noise);
/// The rejected force measurements, likewise; then those in use that are doubted (doubtful_rate).
/// @param without tests of the same at a fit without any of them, or null: a fit that follows a
///   precise measurement far away is linearised there, and its tests may find nothing
[[nodiscard]] std::vector<ForceOutlier> force_outliers(const Hypotheses& hypotheses,
                                                       const std::vector<ForceMeasurement>& forces,
                                                       const Hypotheses* without);
/// Part by which all force measurements are too high, where they were rejected together for that,
/// or are doubted.
[[nodiscard]] std::optional<ForceBias> force_bias(const Hypotheses& hypotheses);
/// DetectableErrors::force: rejected or doubted; of those in use at the fit.
[[nodiscard]] double detectable_force(const Hypotheses& hypotheses,
                                      const std::vector<ForceMeasurement>& forces);
/// DetectableErrors::force_scale, likewise.
[[nodiscard]] double detectable_force_scale(const Hypotheses& hypotheses);

}  // namespace taut
