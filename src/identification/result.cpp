// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/result.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace taut {

std::string_view to_string(IdentificationStatus status) {
    switch (status) {
        case IdentificationStatus::converged:
            return "converged";
        case IdentificationStatus::iteration_limit:
            return "iteration limit";
        case IdentificationStatus::survey_does_not_fit:
            return "survey does not fit";
        case IdentificationStatus::survey_not_exact:
            return "survey not exact";
        case IdentificationStatus::no_equilibrium:
            return "no equilibrium";
    }
    return "unknown";
}

Points FrameOffset::motion_of(const Points& places) const {
    Points motion = places;
    for (auto place : motion.colwise()) {
        place = translation + rotation.cross(Eigen::Vector3d(place - about));
    }
    return motion;
}

Eigen::VectorXd residuals_in_use(const Identification& result, const Survey& survey) {
    if (result.residuals.size() != 0 && result.residuals.size() != std::ssize(survey.surveyed)) {
        throw std::invalid_argument(fmt::format("{} residuals of a survey of {} targets",
                                                result.residuals.size(), survey.surveyed.size()));
    }
    std::vector<int> in_use;
    for (int i = 0; i < static_cast<int>(result.residuals.size()); ++i) {
        if (std::ranges::find(result.outliers, survey.surveyed[i], &Outlier::node) ==
            result.outliers.end()) {
            in_use.push_back(i);
        }
    }
    return result.residuals(in_use);
}

}  // namespace taut
