// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/common_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "estimation/length_posterior.hpp"
#include "identification/stretch_lengths.hpp"

namespace taut {
namespace {

/// The rows of the gains for these edges, of their lengths as marked.
Eigen::MatrixXd gains_of(const std::vector<int>& edges, const StaticsModel& model,
                         const LengthTrend& trend) {
    std::vector<Eigen::Index> rows(edges.size());
    std::ranges::transform(edges, rows.begin(),
                           [&](int edge) { return model.numbering().interior_of[edge]; });
    return trend.length_gains(rows, Eigen::all);
}

/// The same with what slides.
Eigen::MatrixXd gains_between_nodes(const std::vector<int>& edges, const StaticsModel& model,
                                    const LengthTrend& trend) {
    return gains_of(edges, model, trend) + model.common.slip_rates(edges) * trend.common_gains;
}

}  // namespace

void take_up_trend(Identification& result, const LengthTrend& trend,
                   const PriorKnowledge& knowledge, const LinearisedFit& fitted) {
    const StaticsModel& model = fitted.model();
    std::vector<int> edges;
    std::ranges::transform(result.edges, std::back_inserter(edges), &IdentifiedEdge::edge);
    const Eigen::MatrixXd gains = gains_between_nodes(edges, model, trend);
    const Eigen::VectorXd shifts = gains * trend.mean;
    const Eigen::VectorXd stds = (gains * trend.root).rowwise().norm();
    for (size_t i = 0; i < result.edges.size(); ++i) {
        IdentifiedEdge& edge = result.edges[i];
        if (edge.status == EdgeStatus::slack || !(edge.std_dev > 0.0)) {
            continue;
        }
        const auto k = static_cast<Eigen::Index>(i);
        const double std_dev = std::hypot(edge.std_dev, stds(k));
        const double wider = std_dev / edge.std_dev;
        const double before = edge.length_deviation;
        edge.length_deviation += shifts(k);
        edge.lower = edge.length_deviation - wider * (before - edge.lower);
        edge.upper = edge.length_deviation + wider * (edge.upper - before);
        edge.std_dev = std_dev;
        edge.status = status_of(std_before(result, edge.edge, result.length_prior.std_dev()),
                                {.std_dev = std_dev, .slack_probability = 0.0});
    }
    int common = 0;
    int slip = model.common.first_of_slips();
    for (ParameterEstimate& one : result.uncertain) {
        Eigen::RowVectorXd gain = Eigen::RowVectorXd::Zero(trend.mean.size());
        if (one.edge < 0 && one.node < 0) {
            gain = one.parameter.std_dev * trend.common_gains.row(common++);
        } else if (one.parameter.kind == UncertainParameter::Kind::adjustable) {
            gain = gains_of({one.edge}, model, trend);
            one.prior_std = std::hypot(one.prior_std, trend.adjustable_std);
        } else if (one.parameter.kind == UncertainParameter::Kind::slip) {
            gain = one.parameter.std_dev * trend.common_gains.row(slip++);
        }
        one.mean += gain * trend.mean;
        one.std_dev = std::hypot(one.std_dev, (gain * trend.root).norm());
    }
    for (size_t k = 0; k < result.stretches.size(); ++k) {
        StretchLength& one = result.stretches[k];
        const Eigen::RowVectorXd gain = gains_of(one.edges, model, trend).colwise().sum();
        one.std_dev = std::hypot(one.std_dev, (gain * trend.root).norm());
        const Eigen::RowVectorXd of_tension =
            knowledge.stretches[k].unit() *
            trend.common_gains.row(model.common.first_of_stretches() + static_cast<int>(k));
        one.tension_std = std::hypot(one.tension_std, (of_tension * trend.root).norm());
    }
}

LengthCovariance covariance_of(const std::vector<int>& edges, const LinearisedFit& fitted,
                               const Observations& sites, const LengthTrend& trend,
                               const Identification& result) {
    Eigen::MatrixXd linearised = result.stretches.empty()
                                     ? fitted.linearisation.length_covariance(edges)
                                     : covariance_between_nodes(fitted, sites, edges);
    if (!trend.empty()) {
        const Eigen::MatrixXd common =
            gains_between_nodes(edges, fitted.model(), trend) * trend.root;
        linearised += common * common.transpose();
    }
    Eigen::VectorXd scale(edges.size());
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
        const auto edge = std::ranges::find(result.edges, edges[k], &IdentifiedEdge::edge);
        const double std_dev = std::sqrt(linearised(k, k));
        scale(k) = std_dev > 0.0 ? edge->std_dev / std_dev : 0.0;
    }
    return {.edges = edges, .covariance = linearised.cwiseProduct(scale * scale.transpose())};
}

}  // namespace taut
