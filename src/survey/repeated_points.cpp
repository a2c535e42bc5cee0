// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/repeated_points.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "survey/covariance.hpp"

namespace taut {
namespace {

constexpr double farthest_repeat = 0.02;  ///< of points that are one [m]
constexpr double most_deviations = 10.0;

void check_repeat(const SurveyPoint& first, const SurveyPoint& again, double noise_std) {
    const double distance = (again.position - first.position).norm();
    const double std_dev = again.noise_std ? again.noise_std->maxCoeff() : noise_std;
    const double limit = std::max(farthest_repeat, most_deviations * std_dev);
    if (distance > limit) {
        throw SurveyError(
            again.line,
            fmt::format("surveys '{}' a second time, {:.4g} mm from where line {} has it, expected "
                        "at most {:.4g} mm: are these two points?",
                        again.id, 1e3 * distance, first.line, 1e3 * limit));
    }
}

}  // namespace

AveragedPoints average_repeated(std::vector<SurveyPoint> points, double noise_std) {
    std::map<std::string, std::vector<size_t>> places;
    for (size_t i = 0; i < points.size(); ++i) {
        if (!points[i].id.empty()) {
            places[points[i].id].push_back(i);
        }
    }
    std::vector<bool> is_averaged(points.size(), false);
    size_t count = 0;
    double worst = 0.0;
    std::string worst_name;
    for (const auto& [name, indices] : places) {
        if (indices.size() == 1) {
            continue;
        }
        ++count;
        SurveyPoint& first = points[indices.front()];
        Eigen::Vector3d offsets = Eigen::Vector3d::Zero();
        Eigen::Matrix3d covariances = Eigen::Matrix3d::Zero();
        bool has_std = true;
        for (const size_t i : indices) {
            check_repeat(first, points[i], noise_std);
            // Less the first: coordinates of a national grid lose nothing.
            offsets += points[i].position - first.position;
            has_std = has_std && points[i].noise_std;
            covariances +=
                covariance_of({.std_dev = points[i].noise_std.value_or(Eigen::Vector3d::Zero()),
                               .correlations = points[i].noise_correlations});
        }
        const auto n = static_cast<double>(indices.size());
        const Eigen::Vector3d mean = first.position + offsets / n;
        double squares = 0.0;
        for (const size_t i : indices) {
            squares += (points[i].position - mean).squaredNorm();
            is_averaged[i] = i != indices.front();
        }
        const double scatter = std::sqrt(squares / (3.0 * (n - 1.0)));
        if (scatter >= worst) {
            worst = scatter;
            worst_name = name;
        }
        first.position = mean;
        const PlaceNoise noise = noise_of(covariances / (n * n));
        first.noise_std = has_std ? std::optional(noise.std_dev) : std::nullopt;
        first.noise_correlations = has_std ? noise.correlations : Eigen::Vector3d::Zero();
    }
    AveragedPoints result;
    for (size_t i = 0; i < points.size(); ++i) {
        if (!is_averaged[i]) {
            result.points.push_back(std::move(points[i]));
        }
    }
    if (count > 0) {
        result.note = fmt::format(
            "{} {} measured several times, averaged: a coordinate scatters by {:.3g} mm at most, "
            "'{}' (standard deviation)",
            count, count == 1 ? "point was" : "points were", 1e3 * worst, worst_name);
    }
    return result;
}

}  // namespace taut
