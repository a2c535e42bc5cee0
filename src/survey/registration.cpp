// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/registration.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "numerics/small_dense.hpp"
#include "survey/covariance.hpp"
#include "survey/mean_edge_length.hpp"
#include "survey/node_names.hpp"

namespace taut {
namespace {

/// Points count as on a line up to this ratio of their second largest to their largest spread: a
/// rotation about that line would be ill determined.
constexpr double line_ratio = 1e-3;

constexpr double scale_tolerance = 0.01;

/// How far a point in the frame of the net may lie from its known place, in mean edge lengths.
constexpr double frame_tolerance = 0.1;

void check_spread(const Eigen::Matrix3Xd& points, const char* which) {
    const Eigen::Vector3d spread = spread_of(points);
    if (!(spread(1) > line_ratio * spread(2))) {
        throw SurveyError(0, fmt::format("the {} places of the {} control points lie on a line, "
                                         "expected three that do not",
                                         which, points.cols()));
    }
}

void check_scale(const Eigen::Matrix3Xd& known, const Eigen::Matrix3Xd& measured) {
    const double scale = measured.norm() / known.norm();
    if (std::abs(scale - 1.0) > scale_tolerance) {
        throw SurveyError(
            0, fmt::format("the control points are measured {:.4g} times as far apart as they are, "
                           "expected 1: is the survey of this net, and in metres?",
                           scale));
    }
}

/// Isotropic noise stays so in every frame; turning it would add correlations by rounding.
bool is_isotropic(const SurveyPoint& point) {
    return point.noise_correlations.isZero(0.0) &&
           (point.noise_std->array() == point.noise_std->x()).all();
}

}  // namespace

double root_mean_square(const std::vector<ControlResidual>& residuals) {
    double sum = 0.0;
    for (const ControlResidual& r : residuals) {
        sum += r.residual.squaredNorm();
    }
    return residuals.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(residuals.size()));
}

Registration register_rigidly(const std::vector<ControlPoint>& points) {
    constexpr size_t needed = 3;
    if (points.size() < needed) {
        throw SurveyError(0, fmt::format("holds {} named supports or control points, expected at "
                                         "least {} to find the frame",
                                         points.size(), needed));
    }
    const auto count = static_cast<Eigen::Index>(points.size());
    Eigen::Matrix3Xd known(3, count);
    Eigen::Matrix3Xd measured(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        known.col(i) = points[i].known;
        measured.col(i) = points[i].measured;
    }
    Registration result;
    result.motion.from = measured.rowwise().mean();
    result.motion.to = known.rowwise().mean();
    const Eigen::Matrix3Xd a = measured.colwise() - result.motion.from;
    const Eigen::Matrix3Xd b = known.colwise() - result.motion.to;
    check_spread(b, "known");
    check_spread(a, "measured");
    check_scale(b, a);
    result.motion.rotation = rigid_motion(a, b).topLeftCorner<3, 3>();
    for (Eigen::Index i = 0; i < count; ++i) {
        result.residuals.push_back(
            {.id = points[i].id, .residual = result.motion.rotation * a.col(i) - b.col(i)});
    }
    return result;
}

std::vector<ControlPoint> support_control_points(const CableNet& net,
                                                 const std::vector<SurveyPoint>& points) {
    std::map<std::string, int> support_of;
    constexpr size_t fewest = 3;  // that fix a frame: else elastic ones must, where they stand
    for (const int node : net.supports().size() < fewest ? net.all_supports() : net.supports()) {
        support_of.emplace(net.node_id(node), node);
    }
    std::vector<ControlPoint> control;
    for (const SurveyPoint& point : points) {
        if (const auto found = support_of.find(point.id); found != support_of.end()) {
            control.push_back({.id = point.id,
                               .known = net.nodes().col(found->second),
                               .measured = point.position,
                               .line = point.line});
        }
    }
    return control;
}

std::vector<ControlPoint> split_off_control_points(const CableNet& net,
                                                   const std::vector<SurveyPoint>& known,
                                                   std::vector<SurveyPoint>& points) {
    std::map<std::string, Eigen::Vector3d> place_of;
    for (const SurveyPoint& point : known) {
        if (point.id.empty() || !place_of.emplace(point.id, point.position).second) {
            throw SurveyError(point.line, "expected a control point with a name of its own");
        }
    }
    const std::map<std::string, int> nodes = nodes_by_name(net);
    std::vector<ControlPoint> control;
    std::erase_if(points, [&](const SurveyPoint& point) {
        const auto found = place_of.find(point.id);
        if (found == place_of.end()) {
            return false;
        }
        control.push_back({.id = point.id,
                           .known = found->second,
                           .measured = point.position,
                           .line = point.line});
        return !nodes.contains(point.id);
    });
    return control;
}

bool in_frame_of_net(const CableNet& net, const std::vector<ControlPoint>& points) {
    const double limit = frame_tolerance * mean_edge_length(net);
    return std::ranges::all_of(points, [&](const ControlPoint& point) {
        return (point.measured - point.known).norm() <= limit;
    });
}

std::vector<SurveyPoint> moved(std::vector<SurveyPoint> points, const RigidMotion& motion) {
    for (SurveyPoint& point : points) {
        point.position = motion(point.position);
        if (point.noise_std && !is_isotropic(point)) {
            const Eigen::Matrix3d covariance = covariance_of(
                {.std_dev = *point.noise_std, .correlations = point.noise_correlations});
            const PlaceNoise noise =
                noise_of(motion.rotation * covariance * motion.rotation.transpose());
            point.noise_std = noise.std_dev;
            point.noise_correlations = noise.correlations;
        }
    }
    return points;
}

}  // namespace taut
