// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/boundary_tests.hpp"

#include <algorithm>
#include <functional>

#include "numerics/dense.hpp"
#include "numerics/small_dense.hpp"

namespace taut {
namespace {
using Score = Linearisation::Score;

/// Score of a shift of an uncertain support: with P the precision of its prior place and C the
/// posterior covariance of the place, the gradient is P (found - expected), with the covariance
/// P - P C P. C includes the variance of an unknown frame. Directions of which the survey shows
/// less than a quarter are not tested. docs/theory.md, (boundary)
Score score_of_place(int node, const StaticsModel& model, const Covariance& covariance,
                     const Iterate& fitted, const Observations& observations) {
    const Eigen::Vector3d precision = observations.support_weights.col(node);
    const Eigen::Vector3d shift = model.support_deviations(fitted).col(node);
    const Eigen::Matrix3d P = precision.asDiagonal();
    const Eigen::Matrix3d information = P - P * covariance.places[node] * P;
    constexpr double least_part = 0.25;
    Score score{.gradient = P * shift, .information = 0.0 * information};
    if (information.allFinite()) {
        const SymmetricEigen eigen = symmetric_eigen(information);
        for (Eigen::Index k = 0; k < 3; ++k) {
            if (eigen.values(k) > least_part * precision.minCoeff()) {
                const Eigen::VectorXd direction = eigen.vectors.col(k);
                score.information += eigen.values(k) * direction * direction.transpose();
            }
        }
    }
    return score;
}

/// (boundary)
/// @param scale residual_scale of all statistics
void take_score(Hypothesis& hypothesis, const Score& score, double scale) {
    // A direction that the survey determines no better than this is not tested [m].
    constexpr double weakest_shown = 1.0;
    hypothesis.test = Hypothesis::Test::in_use;
    hypothesis.statistic = 0.0;
    hypothesis.noncentrality.setZero();
    if (!score.information.allFinite()) {
        return;
    }
    const SymmetricEigen eigen = symmetric_eigen(score.information);
    const Eigen::Index count = score.gradient.size();
    for (Eigen::Index k = 0; k < count; ++k) {
        const double information = eigen.values(k);
        if (information * weakest_shown * weakest_shown > 1.0) {
            const Eigen::VectorXd direction = eigen.vectors.col(k);
            const double along = direction.dot(score.gradient);
            hypothesis.noncentrality.topLeftCorner(count, count) +=
                information / scale * direction * direction.transpose();
            hypothesis.statistic += along * along / information / scale;
        }
    }
}

/// The test of a released one: its estimate is a parameter of the fit.
void take_estimate(Hypothesis& hypothesis, const CommonParameters& common,
                   const Eigen::MatrixXd& common_covariance, const Iterate& fitted, double scale) {
    const bool is_support = hypothesis.kind == Suspect::support;
    const std::vector<int>& members =
        is_support ? common.released().moved : common.released().turned;
    const auto place =
        static_cast<int>(std::ranges::find(members, hypothesis.index) - members.begin());
    const int count = hypothesis.degrees_of_freedom;
    const int first = is_support ? common.place_of_moved(place) : common.place_of_turned(place);
    const Eigen::VectorXd values = fitted.common.segment(first, count);
    const Eigen::MatrixXd covariance = common_covariance.block(first, first, count, count);
    const double unit = CommonParameters::released_unit();
    hypothesis.test = Hypothesis::Test::released;
    hypothesis.deviation.head(count) = unit * values;
    hypothesis.covariance.topLeftCorner(count, count) = unit * unit * covariance;
    hypothesis.statistic =
        (values.transpose() * symmetric_solution(covariance, values)).value() / scale;
}

}  // namespace

std::vector<Hypothesis> boundary_hypotheses(const CableNet& net, double false_alarm_rate) {
    // Supports are less likely to be wrong than anything else.
    constexpr double false_alarm_part_of_supports = 0.1;
    const size_t count = std::max<size_t>(1, net.adjustable_edges().size() + net.supports().size());
    const double edge_threshold = snooping_threshold(false_alarm_rate, count, 1);
    const double support_threshold =
        snooping_threshold(false_alarm_part_of_supports * false_alarm_rate, count, 3);
    std::vector<Hypothesis> result;
    result.reserve(count);
    std::vector<int> edges = net.adjustable_edges();  // in any order, as the supports
    std::ranges::sort(edges);
    for (const int edge : edges) {
        const auto [s, t] = net.edges()[edge];
        result.push_back({.kind = Suspect::adjustable_edge,
                          .index = edge,
                          .nodes = {s, t, -1},
                          .threshold = edge_threshold});
    }
    std::vector<int> supports = net.supports();
    std::ranges::sort(supports);
    for (const int node : supports) {
        result.push_back({.kind = Suspect::support,
                          .index = node,
                          .nodes = {node, -1, -1},
                          .degrees_of_freedom = 3,
                          .threshold = support_threshold});
    }
    return result;
}

void test_boundary(Hypotheses& hypotheses, const Linearisation& linearisation,
                   const Covariance& covariance, const Iterate& fitted,
                   const Observations& observations) {
    const StaticsModel& model = linearisation.model();
    const auto score_of = [&](const Hypothesis& hypothesis) {
        if (hypothesis.kind == Suspect::adjustable_edge) {
            return linearisation.score_of_edge(hypothesis.index, covariance, fitted, observations);
        }
        if (model.are_supports_uncertain()) {
            return score_of_place(hypothesis.index, model, covariance, fitted, observations);
        }
        const std::span<const int> edges = model.net().edges_at(hypothesis.index);
        return linearisation.score_of_support(hypothesis.index, {edges.begin(), edges.end()},
                                              covariance, fitted, observations);
    };
    for (const Suspect kind : {Suspect::adjustable_edge, Suspect::support}) {
        for (Hypothesis& hypothesis : hypotheses.of(kind)) {
            if (hypothesis.is_released()) {
                take_estimate(hypothesis, model.common, covariance.common, fitted,
                              hypotheses.residual_scale);
            } else {
                take_score(hypothesis, score_of(hypothesis), hypotheses.residual_scale);
            }
        }
    }
}

BoundaryReleases boundary_releases(const Hypotheses& hypotheses) {
    return {.turned = hypotheses.released(Suspect::adjustable_edge),
            .moved = hypotheses.released(Suspect::support)};
}

std::vector<BoundaryOutlier> boundary_outliers(const Hypotheses& hypotheses) {
    std::vector<BoundaryOutlier> result;
    for (const Suspect kind : {Suspect::adjustable_edge, Suspect::support}) {
        for (const Hypothesis& one : hypotheses.found(kind)) {
            result.push_back({.kind = kind == Suspect::support
                                          ? BoundaryOutlier::Kind::support
                                          : BoundaryOutlier::Kind::adjustable_edge,
                              .index = one.index,
                              .deviation = one.deviation,
                              .std_dev = one.std_dev(),
                              .statistic = one.statistic,
                              .confounded_with = one.confounded_with});
        }
    }
    std::ranges::stable_sort(result, std::greater{}, &BoundaryOutlier::statistic);
    return result;
}

}  // namespace taut
