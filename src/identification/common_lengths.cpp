// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/common_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "taut/estimation/length_posterior.hpp"

namespace taut {
namespace {

/// The rows of the gains for these edges.
Eigen::MatrixXd gains_of(const std::vector<int>& edges, const CableNet& fit_net,
                         const LengthTrend& trend) {
    std::vector<Eigen::Index> rows(edges.size());
    std::ranges::transform(edges, rows.begin(), [&](int edge) {
        return std::ranges::lower_bound(fit_net.interior_edges(), edge) -
               fit_net.interior_edges().begin();
    });
    return trend.length_gains(rows, Eigen::all);
}

}  // namespace

void take_up_trend(Identification& result, const LengthTrend& trend, const CableNet& fit_net) {
    std::vector<int> edges;
    std::ranges::transform(result.edges, std::back_inserter(edges), &IdentifiedEdge::edge);
    const Eigen::MatrixXd gains = gains_of(edges, fit_net, trend);
    const Eigen::VectorXd shifts = gains * trend.mean;
    const Eigen::VectorXd stds = (gains * trend.root).rowwise().norm();
    for (size_t i = 0; i < result.edges.size(); ++i) {
        IdentifiedEdge& edge = result.edges[i];
        if (edge.status == EdgeStatus::slack || !(edge.std > 0.0)) {
            continue;
        }
        const auto k = static_cast<Eigen::Index>(i);
        const double std = std::hypot(edge.std, stds(k));
        const double wider = std / edge.std;
        const double before = edge.length_deviation;
        edge.length_deviation += shifts(k);
        edge.lower = edge.length_deviation - wider * (before - edge.lower);
        edge.upper = edge.length_deviation + wider * (edge.upper - before);
        edge.std = std;
        edge.status = status_of(result.length_prior.std(), {.std = std, .slack_probability = 0.0});
    }
    Eigen::Index common = 0;
    for (ParameterEstimate& one : result.uncertain) {
        Eigen::RowVectorXd gain = Eigen::RowVectorXd::Zero(trend.mean.size());
        if (one.edge < 0 && one.node < 0) {
            gain = one.parameter.std * trend.common_gains.row(common++);
        } else if (one.parameter.kind == UncertainParameter::Kind::adjustable) {
            gain = gains_of({one.edge}, fit_net, trend);
            one.prior_std = std::hypot(one.prior_std, trend.adjustable_std);
        }
        one.mean += gain * trend.mean;
        one.std = std::hypot(one.std, (gain * trend.root).norm());
    }
}

LengthCovariance covariance_of(const std::vector<int>& edges, const CableNet& fit_net,
                               const Linearisation& linearisation, const LengthTrend& trend,
                               const Identification& result) {
    Eigen::MatrixXd linearised = linearisation.length_covariance(edges);
    if (!trend.empty()) {
        const Eigen::MatrixXd common = gains_of(edges, fit_net, trend) * trend.root;
        linearised += common * common.transpose();
    }
    Eigen::VectorXd scale(edges.size());
    for (Eigen::Index k = 0; k < scale.size(); ++k) {
        const auto edge = std::ranges::find(result.edges, edges[k], &IdentifiedEdge::edge);
        const double std = std::sqrt(linearised(k, k));
        scale(k) = std > 0.0 ? edge->std / std : 0.0;
    }
    return {.edges = edges, .covariance = linearised.cwiseProduct(scale * scale.transpose())};
}

}  // namespace taut
