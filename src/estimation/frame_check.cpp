// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/frame_check.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "numerics/small_dense.hpp"

namespace taut {
namespace {

/// Chance exceeds this once in 10,000 surveys: chi-squared of six degrees of freedom.
constexpr double significant_motion = 27.9;

}  // namespace

bool FrameCheck::is_moved() const {
    return motion_statistic > significant_motion;
}

bool FrameCheck::is_scaled() const {
    return scale_std > 0.0 && std::abs(scale) > significant_std * scale_std;
}

FrameCheck check_frame(const LinearisedFit& fitted, const Observations& observations,
                       double scale) {
    const CableNet& net = fitted.model().net();
    const Eigen::Vector3d middle = net.nodes().rowwise().mean();
    const Points arms = net.nodes().colwise() - middle;
    const bool is_frame_given = !fitted.model().common.has_frame();
    const double reach = arms.colwise().norm().maxCoeff();
    std::vector<Points> rates{arms};
    for (int k = 0; is_frame_given && k < 6; ++k) {
        Points& motion = rates.emplace_back(3, net.node_count());
        for (int node = 0; node < net.node_count(); ++node) {
            const Eigen::Vector3d along = Eigen::Vector3d::Unit(k % 3);
            motion.col(node) = k < 3 ? along : Eigen::Vector3d(along.cross(arms.col(node)) / reach);
        }
    }
    const Linearisation::Score score =
        fitted.linearisation.score_of_survey(rates, fitted.iterate, observations);
    const Eigen::LDLT<Eigen::MatrixXd> factor(score.information);
    constexpr double rounding = 1e-9;
    if (!(factor.vectorD().minCoeff() > rounding * score.information.diagonal().maxCoeff())) {
        return {};
    }
    const auto count = std::ssize(rates);
    const Eigen::VectorXd values = factor.solve(score.gradient);
    const Eigen::MatrixXd covariance =
        scale * factor.solve(Eigen::MatrixXd::Identity(count, count));
    FrameCheck result{.scale = values(0), .scale_std = std::sqrt(covariance(0, 0))};
    if (is_frame_given) {
        const Eigen::VectorXd motion = values.tail<6>();
        result.translation = motion.head<3>();
        result.rotation = motion.tail<3>() / reach;
        result.motion_statistic =
            (motion.transpose() * symmetric_solution(covariance.bottomRightCorner<6, 6>(), motion))
                .value();
    }
    return result;
}

}  // namespace taut
