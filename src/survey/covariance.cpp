// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/covariance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace taut {
namespace {

Eigen::Matrix3d correlation_matrix(const Eigen::Vector3d& correlations) {
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    R(0, 1) = R(1, 0) = correlations(0);
    R(0, 2) = R(2, 0) = correlations(1);
    R(1, 2) = R(2, 1) = correlations(2);
    return R;
}

}  // namespace

bool are_possible_correlations(const Eigen::Vector3d& correlations) {
    // A distance that is known ten thousand times better than the direction, or the reverse.
    constexpr double least_eigenvalue = 1e-9;
    if (!correlations.allFinite() || correlations.cwiseAbs().maxCoeff() > 1.0) {
        return false;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(correlation_matrix(correlations),
                                                               Eigen::EigenvaluesOnly);
    return eigen.eigenvalues()(0) >= least_eigenvalue;
}

Eigen::Matrix3d covariance_of(const PlaceNoise& noise) {
    return noise.std_dev.asDiagonal() * correlation_matrix(noise.correlations) *
           noise.std_dev.asDiagonal();
}

PlaceNoise noise_of(const Eigen::Matrix3d& covariance) {
    const Eigen::Vector3d std_dev = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    const auto correlation = [&](int i, int k) {
        const double product = std_dev(i) * std_dev(k);
        return product > 0.0 ? covariance(i, k) / product : 0.0;
    };
    return {.std_dev = std_dev,
            .correlations = {correlation(0, 1), correlation(0, 2), correlation(1, 2)}};
}

Eigen::Matrix3d weight_of(const PlaceNoise& noise) {
    const Eigen::Matrix3d whitening = whitening_of(noise);
    return whitening.transpose() * whitening;
}

Eigen::Matrix3d whitening_of(const PlaceNoise& noise) {
    const Eigen::Vector3d weights = noise.std_dev.cwiseInverse();
    if (noise.correlations.isZero(0.0)) {
        return weights.asDiagonal();
    }
    const Eigen::Matrix3d L = correlation_matrix(noise.correlations).llt().matrixL();
    const Eigen::Matrix3d inverse =
        L.triangularView<Eigen::Lower>().solve(Eigen::Matrix3d::Identity());
    return inverse * weights.asDiagonal();
}

}  // namespace taut
