// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/comparable_scores.hpp"

#include <algorithm>

namespace taut {

double comparable_score(double statistic, double threshold) {
    constexpr double unit = 20.0;  // about the threshold of one degree of freedom
    return std::max(0.0, 1.0 + (statistic - threshold) / unit);
}

Eigen::VectorXd largest_nearby(const CableNet& net, const Eigen::VectorXd& scores) {
    Eigen::VectorXd result = scores;
    for (const auto& [s, t] : net.edges()) {
        result(s) = std::max(result(s), scores(t));
        result(t) = std::max(result(t), scores(s));
    }
    return result;
}

}  // namespace taut
