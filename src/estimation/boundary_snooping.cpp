// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/boundary_snooping.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/comparable_scores.hpp"
#include "estimation/data_snooping.hpp"
#include "numerics/dense.hpp"
#include "numerics/small_dense.hpp"

namespace taut {
namespace {

/// Part of all adjustable edges and supports that can be outliers; more, and none is named alone.
constexpr double most_released_part = 0.25;
constexpr int a_few_released = 3;

/// Supports are less likely to be wrong than anything else: they get a tenth of the false alarms.
constexpr double false_alarm_part_of_supports = 0.1;

/// A score below this part of the largest may be caused by it, however far away, at the other end
/// of a cable for instance.
constexpr double least_of_largest = 0.9;

/// A direction that the survey determines no better than this is not tested [m].
constexpr double weakest_shown = 1.0;

}  // namespace

BoundarySnooping::BoundarySnooping(const CableNet& net,
                                   const std::vector<UncertainParameter>& uncertain,
                                   double false_alarm_rate)
    : m_net(net) {
    std::vector<std::vector<int>> edges_at(net.node_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        for (const int node : net.edges()[e]) {
            edges_at[node].push_back(e);
        }
    }
    for (const int edge : net.adjustable_edges()) {
        m_hypotheses.push_back({.kind = BoundaryOutlier::Kind::adjustable_edge, .index = edge});
    }
    m_are_supports_uncertain = std_of(uncertain, UncertainParameter::Kind::supports) > 0.0;
    for (const int node : net.supports()) {
        m_hypotheses.push_back({.kind = BoundaryOutlier::Kind::support,
                                .index = node,
                                .edges = std::move(edges_at[node])});
    }
    const size_t count = std::max<size_t>(1, m_hypotheses.size());
    m_edge_threshold = snooping_threshold(false_alarm_rate, count, 1);
    m_support_threshold =
        snooping_threshold(false_alarm_part_of_supports * false_alarm_rate, count, 3);
    m_is_active = std::isfinite(m_edge_threshold) && !m_hypotheses.empty();
}

bool BoundarySnooping::is_released(const Hypothesis& hypothesis) const {
    return std::ranges::binary_search(released_like(hypothesis), hypothesis.index);
}

void BoundarySnooping::evaluate(const LinearisedStatics& statics, const Iterate& fitted,
                                const Observations& observations, double scale) {
    for (Hypothesis& hypothesis : m_hypotheses) {
        if (is_released(hypothesis)) {
            take_estimate(hypothesis, statics, fitted, scale);
        } else if (hypothesis.is_support() && m_are_supports_uncertain) {
            take_score(hypothesis, score_of_place(hypothesis.index, statics, fitted, observations),
                       scale);
        } else if (hypothesis.is_support()) {
            take_score(
                hypothesis,
                statics.score_of_support(hypothesis.index, hypothesis.edges, fitted, observations),
                scale);
        } else {
            take_score(hypothesis, statics.score_of_edge(hypothesis.index, fitted, observations),
                       scale);
        }
    }
}

/// Score of a shift of an uncertain support: with P the precision of its prior place and C the
/// posterior covariance of the place, the gradient is P (found - expected), with the covariance
/// P - P C P. C includes the variance of an unknown frame. Directions of which the survey shows
/// less than a quarter are not tested. docs/theory.md, (boundary)
LinearisedStatics::Score BoundarySnooping::score_of_place(int node,
                                                          const LinearisedStatics& statics,
                                                          const Iterate& fitted,
                                                          const Observations& observations) const {
    const Eigen::Vector3d precision = observations.support_weights.col(node);
    const Eigen::Vector3d shift = fitted.form.col(node) - m_net.nodes().col(node) -
                                  statics.common().support_motion(fitted.common).col(node);
    const Eigen::Matrix3d P = precision.asDiagonal();
    const Eigen::Matrix3d information = P - P * statics.form_covariance(node) * P;
    constexpr double least_part = 0.25;
    LinearisedStatics::Score score{.gradient = P * shift, .information = 0.0 * information};
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
void BoundarySnooping::take_score(Hypothesis& hypothesis, const LinearisedStatics::Score& score,
                                  double scale) const {
    hypothesis.found = {.kind = hypothesis.kind, .index = hypothesis.index};
    hypothesis.score = 0.0;
    hypothesis.tested.noncentrality = 0.0 * score.information;
    if (!score.information.allFinite()) {
        return;
    }
    const SymmetricEigen eigen = symmetric_eigen(score.information);
    for (Eigen::Index k = 0; k < score.gradient.size(); ++k) {
        const double information = eigen.values(k);
        if (information * weakest_shown * weakest_shown > 1.0) {
            const Eigen::VectorXd direction = eigen.vectors.col(k);
            const double along = direction.dot(score.gradient);
            hypothesis.tested.noncentrality +=
                information / scale * direction * direction.transpose();
            hypothesis.found.statistic += along * along / information / scale;
        }
    }
    hypothesis.score = comparable_score(hypothesis.found.statistic, threshold_of(hypothesis));
}

/// The test of a released one: its estimate is a parameter of the fit.
void BoundarySnooping::take_estimate(Hypothesis& hypothesis, const LinearisedStatics& statics,
                                     const Iterate& fitted, double scale) const {
    const CommonParameters& common = statics.common();
    const std::vector<int>& members = released_like(hypothesis);
    const auto place =
        static_cast<int>(std::ranges::lower_bound(members, hypothesis.index) - members.begin());
    const int count = hypothesis.is_support() ? 3 : 1;
    const int first =
        hypothesis.is_support() ? common.place_of_moved(place) : common.place_of_turned(place);
    const Eigen::VectorXd values = fitted.common.segment(first, count);
    const Eigen::MatrixXd covariance =
        statics.common_covariance().block(first, first, count, count);
    const double unit = CommonParameters::released_unit();
    hypothesis.found = {.kind = hypothesis.kind, .index = hypothesis.index};
    hypothesis.found.deviation.head(count) = unit * values;
    hypothesis.found.std.head(count) = unit * covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    hypothesis.found.statistic =
        (values.transpose() * symmetric_solution(covariance, values)).value() / scale;
    hypothesis.found.confounded_with = hypothesis.confounded_with;
    hypothesis.score = comparable_score(hypothesis.found.statistic, threshold_of(hypothesis));
}

/// A support moved along an edge has the effect of another length of that edge.
/// @return the edge or support that would explain nearly as much; -1: none
int BoundarySnooping::confounded_with_of(const Hypothesis& hypothesis) const {
    constexpr double nearly = 0.5;  // of the score
    int confounded_with = -1;
    double best = nearly * hypothesis.score;
    for (const Hypothesis& other : m_hypotheses) {
        const Hypothesis& support = other.is_support() ? other : hypothesis;
        const Hypothesis& edge = other.is_support() ? hypothesis : other;
        const bool is_confounded =
            other.kind != hypothesis.kind &&
            std::ranges::find(support.edges, edge.index) != support.edges.end();
        if (is_confounded && other.score > best) {
            best = other.score;
            confounded_with = other.index;
        }
    }
    return confounded_with;
}

void BoundarySnooping::set_member(const Hypothesis& hypothesis, bool is_member) {
    std::vector<int>& members = hypothesis.is_support() ? m_released.moved : m_released.turned;
    if (is_member) {
        members.insert(std::ranges::upper_bound(members, hypothesis.index), hypothesis.index);
    } else {
        std::erase(members, hypothesis.index);
    }
}

Eigen::VectorXd BoundarySnooping::scores() const {
    Eigen::VectorXd scores = Eigen::VectorXd::Zero(m_net.node_count());
    if (!m_is_active) {
        return scores;
    }
    for (const Hypothesis& hypothesis : m_hypotheses) {
        if (is_released(hypothesis) || hypothesis.is_readmitted) {
            continue;
        }
        if (hypothesis.is_support()) {
            scores(hypothesis.index) = std::max(scores(hypothesis.index), hypothesis.score);
        } else {
            for (const int node : m_net.edges()[hypothesis.index]) {
                scores(node) = std::max(scores(node), hypothesis.score);
            }
        }
    }
    return scores;
}

bool BoundarySnooping::release(const Eigen::VectorXd& other_scores, bool one_by_one) {
    if (!m_is_active) {
        return false;
    }
    const Eigen::VectorXd all = scores().cwiseMax(other_scores);
    const Eigen::VectorXd nearby = largest_nearby(m_net, all);
    const double least = std::max(1.0, one_by_one ? least_of_largest * all.maxCoeff() : 0.0);
    bool has_changed = false;
    for (Hypothesis& hypothesis : m_hypotheses) {
        const bool is_open = !is_released(hypothesis) && !hypothesis.is_readmitted;
        if (is_open && hypothesis.score > least && is_suspect(hypothesis, nearby)) {
            hypothesis.confounded_with = confounded_with_of(hypothesis);
            set_member(hypothesis, true);
            has_changed = true;
        }
    }
    return has_changed;
}

/// @param nearby the largest score near each node (n)
bool BoundarySnooping::is_suspect(const Hypothesis& hypothesis,
                                  const Eigen::VectorXd& nearby) const {
    const auto is_largest_at_ends = [&](int edge) {
        return std::ranges::all_of(m_net.edges()[edge],
                                   [&](int node) { return hypothesis.score >= nearby(node); });
    };
    return hypothesis.is_support() ? std::ranges::all_of(hypothesis.edges, is_largest_at_ends)
                                   : is_largest_at_ends(hypothesis.index);
}

bool BoundarySnooping::readmit() {
    bool has_changed = false;
    for (Hypothesis& hypothesis : m_hypotheses) {
        if (is_released(hypothesis) && hypothesis.score <= 1.0) {
            set_member(hypothesis, false);
            hypothesis.is_readmitted = true;
            has_changed = true;
        }
    }
    return has_changed;
}

void BoundarySnooping::reopen() {
    for (Hypothesis& hypothesis : m_hypotheses) {
        hypothesis.is_readmitted = false;
    }
}

bool BoundarySnooping::releases_too_many() const {
    return m_released.count() >
           std::max<double>(a_few_released,
                            most_released_part * static_cast<double>(m_hypotheses.size()));
}

int BoundarySnooping::not_released_count() const {
    return static_cast<int>(std::ranges::count_if(m_hypotheses, [&](const Hypothesis& hypothesis) {
        return !is_released(hypothesis) && hypothesis.score > 1.0;
    }));
}

bool BoundarySnooping::is_suspicious(const Eigen::VectorXd& suspects) const {
    const Eigen::VectorXd near = largest_nearby(m_net, largest_nearby(m_net, suspects));
    return std::ranges::any_of(m_hypotheses, [&](const Hypothesis& hypothesis) {
        const int node =
            hypothesis.is_support() ? hypothesis.index : m_net.edges()[hypothesis.index][0];
        return hypothesis.score > 1.0 || near(node) > 0.0;
    });
}

double BoundarySnooping::released_cost() const {
    const auto of = [](double threshold, size_t count) {
        return count > 0 ? threshold * static_cast<double>(count) : 0.0;
    };
    return of(m_edge_threshold, m_released.turned.size()) +
           of(m_support_threshold, m_released.moved.size());
}

double BoundarySnooping::detectable(BoundaryOutlier::Kind kind) const {
    std::vector<TestedItem> tested;
    for (const Hypothesis& hypothesis : m_hypotheses) {
        if (hypothesis.kind == kind && !is_released(hypothesis) &&
            hypothesis.tested.noncentrality.size() > 0) {
            tested.push_back(hypothesis.tested);
        }
    }
    return kind == BoundaryOutlier::Kind::support ? detectable_error(tested, m_support_threshold, 3)
                                                  : detectable_error(tested, m_edge_threshold, 1);
}

std::vector<BoundaryOutlier> BoundarySnooping::outliers() const {
    std::vector<BoundaryOutlier> result;
    for (const Hypothesis& hypothesis : m_hypotheses) {
        if (is_released(hypothesis)) {
            result.push_back(hypothesis.found);
        }
    }
    std::ranges::sort(result, std::greater{}, &BoundaryOutlier::statistic);
    return result;
}

}  // namespace taut
