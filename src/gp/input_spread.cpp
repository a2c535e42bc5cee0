// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/input_spread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace taut::gp {
namespace {

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace

InputSpread input_spread(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                         const Eigen::MatrixXd& squared_distances) {
    // Inputs that should be the same can differ by rounding, and their distance by that of squares.
    const double rounding = 1e-14 * inputs.cwiseAbs().maxCoeff();
    const double same = std::max(rounding * rounding, 1e-14 * squared_distances.maxCoeff());
    std::vector<double> all;
    all.reserve(static_cast<size_t>(squared_distances.size() / 2));
    std::vector<double> nearest;
    for (Eigen::Index j = 0; j < squared_distances.cols(); ++j) {
        double smallest = std::numeric_limits<double>::infinity();
        for (Eigen::Index i = 0; i < squared_distances.rows(); ++i) {
            if (const double value = squared_distances(i, j); value > same) {
                if (i < j) {
                    all.push_back(value);
                }
                smallest = std::min(smallest, value);
            }
        }
        if (std::isfinite(smallest)) {
            nearest.push_back(smallest);
        }
    }
    if (all.empty()) {
        return {};
    }
    return {.distance = std::sqrt(median(all)), .distance_to_nearest = std::sqrt(median(nearest))};
}

}  // namespace taut::gp
