// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/measured_scale.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace taut {
namespace {

constexpr double false_alarm = 1e-3;  ///< of the test, in a survey that is right
/// 1 mm in 10 m: a smaller one does not matter to a net.
constexpr double least_departure = 1e-4;

}  // namespace

bool MeasuredScale::is_significant() const {
    const boost::math::students_t distribution(redundancy);
    const double limit =
        boost::math::quantile(boost::math::complement(distribution, 0.5 * false_alarm));
    return std::abs(scale - 1.0) > limit * std_dev;
}

std::optional<MeasuredScale> measured_scale(const std::vector<ControlPoint>& points) {
    Registration fit;
    try {
        fit = register_rigidly(points);
    } catch (const SurveyError&) {
        return std::nullopt;
    }
    double products = 0.0;
    double squares = 0.0;
    double residuals = 0.0;  // of scale 1
    for (size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector3d b = points[i].known - fit.motion.to;
        const Eigen::Vector3d& excess = fit.residuals[i].residual;  // a - b
        products += excess.dot(b);
        squares += b.squaredNorm();
        residuals += excess.squaredNorm();
    }
    // With e = a - b and d = k - 1: d = sum e . b / sum |b|^2, and the sum of |a - k b|^2 = |e - d
    // b|^2 is that of |e|^2 - d^2 |b|^2.
    const double departure = products / squares;
    const double left = std::max(0.0, residuals - departure * departure * squares);
    const int redundancy = 3 * static_cast<int>(points.size()) - 7;
    return MeasuredScale{.scale = 1.0 + departure,
                         .std_dev = std::sqrt(left / (redundancy * squares)),
                         .redundancy = redundancy};
}

std::vector<std::string> scale_warnings(const std::vector<ControlPoint>& points) {
    const auto found = measured_scale(points);
    if (!found || std::abs(found->scale - 1.0) <= least_departure || !found->is_significant()) {
        return {};
    }
    return {fmt::format(
        "its {} supports or control points are measured {:.6g} times as far apart as they are "
        "(standard error {:.1g}). Check whether it is in a map grid and the instrument's scale "
        "(ppm), or divide its coordinates by that scale",
        points.size(), found->scale, found->std_dev)};
}

}  // namespace taut
