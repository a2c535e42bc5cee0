// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/error_statistics.hpp"
#include "study/error_sums.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

namespace taut {

LengthErrors length_errors(const Eigen::Ref<const Eigen::MatrixXd>& truth,
                           const Eigen::Ref<const Eigen::MatrixXd>& estimate) {
    if (truth.size() == 0 || truth.rows() != estimate.rows() || truth.cols() != estimate.cols()) {
        throw std::invalid_argument(fmt::format(
            "{} x {} true and {} x {} estimated length deviations, expected as many, and "
            "at least one",
            truth.rows(), truth.cols(), estimate.rows(), estimate.cols()));
    }
    const Eigen::MatrixXd errors = truth - estimate;
    const Eigen::ArrayXd squared_errors = errors.rowwise().squaredNorm();
    const Eigen::ArrayXd squared_truths = truth.rowwise().squaredNorm();

    LengthErrors result;
    result.mean = errors.rowwise().mean();
    result.std_dev = (errors.colwise() - result.mean).array().square().rowwise().mean().sqrt();
    result.mse = errors.squaredNorm() / static_cast<double>(errors.size());
    const auto deviates = squared_truths > 0.0;
    const auto count = static_cast<double>(deviates.count());
    result.mrse =
        count > 0.0 ? deviates.select(squared_errors / squared_truths, 0.0).sum() / count : 0.0;
    return result;
}

Eigen::VectorXd node_distances(const Eigen::Ref<const Eigen::VectorXd>& coordinates,
                               const Eigen::Ref<const Eigen::VectorXd>& other) {
    if (coordinates.size() != other.size() || coordinates.size() % 3 != 0) {
        throw std::invalid_argument(
            fmt::format("forms of {} and {} coordinates, expected as many, three a node",
                        coordinates.size(), other.size()));
    }
    const Eigen::VectorXd difference = coordinates - other;
    return difference.reshaped(3, difference.size() / 3).colwise().norm().transpose();
}

FormErrorSummary summarise(const Eigen::Ref<const Eigen::VectorXd>& distances) {
    if (distances.size() == 0) {
        throw std::invalid_argument("no distances, expected at least one");
    }
    return {.max = distances.maxCoeff(),
            .min = distances.minCoeff(),
            .mean = distances.mean(),
            .rmse = std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size()))};
}

void add_to_mean(FormErrorSummary& mean, const FormErrorSummary& summary, int count) {
    mean.max += summary.max / count;
    mean.min += summary.min / count;
    mean.mean += summary.mean / count;
    mean.rmse += summary.rmse / count;
}

}  // namespace taut
