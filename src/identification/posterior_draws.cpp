// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/posterior_draws.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "identification/drawn_summary.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Between two order statistics; the outermost where the rank lies outside. (drawn)
double quantile(const Eigen::VectorXd& sorted, double p) {
    const auto last = static_cast<double>(sorted.size() - 1);
    const double rank = std::clamp(p * (last + 2.0) - 1.0, 0.0, last);
    const auto below = static_cast<Eigen::Index>(rank);
    const Eigen::Index above = std::min(below + 1, sorted.size() - 1);
    return sorted(below) + (rank - static_cast<double>(below)) * (sorted(above) - sorted(below));
}

}  // namespace

DrawnEstimate estimate_of(const Eigen::Ref<const Eigen::VectorXd>& values) {
    Eigen::VectorXd sorted = values;
    std::ranges::sort(sorted);
    const double mean = sorted.mean();
    const auto others = std::max(1.0, static_cast<double>(sorted.size() - 1));
    DrawnEstimate result{.mean = mean,
                         .std_dev = std::sqrt((sorted.array() - mean).square().sum() / others),
                         .lower = quantile(sorted, 0.025),
                         .upper = quantile(sorted, 0.975)};
    constexpr Eigen::Index fewest = 39;  // to have both ranks
    if (sorted.size() < fewest) {
        const double factor = boost::math::quantile(boost::math::students_t(others), 0.975) *
                              std::sqrt(1.0 + 1.0 / static_cast<double>(sorted.size()));
        result.lower = std::min(result.lower, mean - factor * result.std_dev);
        result.upper = std::max(result.upper, mean + factor * result.std_dev);
    }
    return result;
}

DrawnEstimate tension_of(const CableNet& net, int edge,
                         const Eigen::Ref<const Eigen::VectorXd>& forces) {
    DrawnEstimate result = estimate_of(forces);
    if (net.can_be_slack(edge)) {
        result.lower = std::max(result.lower, 0.0);
    }
    return result;
}

DrawnSummary summary_of(const PosteriorDraws& draws, const CableNet& net,
                        const std::vector<int>& missing) {
    DrawnSummary summary;
    for (int e = 0; e < draws.tensions.rows(); ++e) {
        const Eigen::VectorXd tension = draws.tensions.row(e);
        summary.tensions.push_back(
            {.edge = e,
             .tension = tension_of(net, e, tension),
             .slack_probability = net.can_be_slack(e)
                                      ? static_cast<double>((tension.array() <= 0.0).count()) /
                                            static_cast<double>(draws.count())
                                      : 0.0});
    }
    const Eigen::VectorXd means = draws.tensions.transpose() * mean_weights(net);
    summary.mean_tension = estimate_of(means);
    summary.mean_tension.lower = std::max(summary.mean_tension.lower, 0.0);  // of cables
    for (const int node : missing) {
        DrawnPlace place{.node = node};
        for (int k = 0; k < 3; ++k) {
            const Eigen::VectorXd values = draws.forms.row(3 * net.free_index(node) + k);
            const DrawnEstimate estimate = estimate_of(values);
            place.mean(k) = estimate.mean;
            place.std_dev(k) = estimate.std_dev;
            place.lower(k) = estimate.lower;
            place.upper(k) = estimate.upper;
        }
        summary.missing.push_back(place);
    }
    return summary;
}

}  // namespace taut
