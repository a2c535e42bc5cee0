// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/survey_gain.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "numerics/dense.hpp"

namespace taut {
namespace {

/// Deviations A from the mean of the samples, so that A A' is the covariance.
Eigen::MatrixXd anomalies(const Eigen::MatrixXd& draws) {
    return (draws.colwise() - draws.rowwise().mean()) /
           std::sqrt(static_cast<double>(draws.cols() - 1));
}

/// With N samples each coordinate of a target seems to explain 1 / N of the variance of independent
/// numbers by chance. A target must explain so many times as much.
constexpr double times_chance = 2.0;

}  // namespace

std::vector<SurveyGain> gains_of_targets(const Eigen::MatrixXd& forms,
                                         const Eigen::MatrixXd& numbers, double noise_std,
                                         int most) {
    std::vector<SurveyGain> result;
    if (forms.cols() < 2) {
        return result;
    }
    Eigen::MatrixXd Y = anomalies(forms);
    Eigen::MatrixXd X = anomalies(numbers);
    const Eigen::Index places = forms.rows() / 3;
    const double by_chance = times_chance * 3.0 / static_cast<double>(forms.cols());
    const Eigen::Matrix3d noise = noise_std * noise_std * Eigen::Matrix3d::Identity();
    std::vector<bool> is_taken(static_cast<size_t>(places), false);
    while (std::ssize(result) < most) {
        Eigen::Index best = -1;
        double best_gain = by_chance * X.squaredNorm();
        const Eigen::MatrixXd covariances = X * Y.transpose();
        for (Eigen::Index s = 0; s < places; ++s) {
            const auto at = Y.middleRows(3 * s, 3);
            const Eigen::LLT<Eigen::Matrix3d> factor(at * at.transpose() + noise);
            const double gain =
                factor.matrixL().solve(covariances.middleCols(3 * s, 3).transpose()).squaredNorm();
            if (!is_taken[static_cast<size_t>(s)] && gain > best_gain) {
                best = s;
                best_gain = gain;
            }
        }
        if (best < 0) {
            break;
        }
        is_taken[static_cast<size_t>(best)] = true;
        // (survey-gain): T^2 = 1 - Y_s' (Y_s Y_s' + noise)^-1 Y_s
        // With Y_s Y_s' = U S^2 U' and r = sqrt(S^2 + noise): T = 1 - Y_s' U (r (r + noise_std))^-1
        // U' Y_s
        const Eigen::MatrixXd at = Y.middleRows(3 * best, 3);
        const SymmetricEigen eigen = symmetric_eigen(at * at.transpose());
        const Eigen::Array3d r = (eigen.values.array().max(0.0) + noise_std * noise_std).sqrt();
        const Eigen::Matrix3d seen = eigen.vectors *
                                     (r * (r + noise_std)).inverse().matrix().asDiagonal() *
                                     eigen.vectors.transpose();
        X -= (X * at.transpose()) * (seen * at);
        Y -= (Y * at.transpose()) * (seen * at);
        result.push_back(
            {.place = static_cast<int>(best),
             .remaining_std = std::sqrt(X.squaredNorm() / static_cast<double>(X.rows()))});
    }
    return result;
}

}  // namespace taut
