// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/predicted_precision.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "estimation/length_posterior.hpp"
#include "identification/planned_fit.hpp"
#include "net/sliding_nodes.hpp"
#include "numerics/parallel.hpp"
#include "taut/identification/identify.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// The most probable status of a taut edge, over deviations from the prior and errors of the survey
/// at evenly spaced quantiles of both. Both are symmetric, so half of them tell.
/// @param std_dev of the length deviation after the survey, to first order [m]
EdgeStatus probable_status(const LengthPrior& prior, double std_dev) {
    LengthLikelihood likelihood = without_prior(0.0, prior.std_dev(), 0.0, std_dev);
    if (!std::isfinite(likelihood.std_dev)) {
        return EdgeStatus::not_determined;
    }
    constexpr int count = 10;
    const LengthPrior errors{LengthPrior::Kind::normal, likelihood.std_dev};
    std::array<int, 4> found{};
    for (int i = 0; i < count / 2; ++i) {
        for (int k = 0; k < count; ++k) {
            likelihood.mean = prior.draw((i + 0.5) / count) + errors.draw((k + 0.5) / count);
            const EdgeStatus status = status_of(prior.std_dev(), posterior_of(prior, likelihood));
            ++found.at(static_cast<size_t>(status));
        }
    }
    return static_cast<EdgeStatus>(std::ranges::max_element(found) - found.begin());
}

/// Of the length deviations (m_I) [m2].
Eigen::VectorXd length_variances(const PlannedFit& planned, const LengthPrior& prior) {
    const CableNet& net = planned.net();
    const double of_prior = prior.std_dev() * prior.std_dev();
    const Eigen::VectorXd blur =
        planned.model().blur.length_variances(planned.fit_net().interior_edge_count());
    const Eigen::VectorXd& found = planned.covariance().lengths;
    const bool has_all = planned.fit_net().interior_edge_count() > net.interior_edge_count();
    Eigen::VectorXd result(net.interior_edge_count());
    for (int k = 0; k < result.size(); ++k) {
        const int i = has_all ? net.interior_edges()[k] : k;
        // At loose nodes rounding errors can exceed a variance: then the prior applies. With a
        // stiffness of its own per edge the fit finds the sum of both.
        const double own = of_prior / (of_prior + blur(i));
        result(k) = found(i) > 0.0 ? own * blur(i) + own * own * found(i) : of_prior;
    }
    for (const std::vector<int>& stretch : sliding_stretches(net)) {
        const Eigen::VectorXd variances = planned.variances_between_nodes(stretch);
        for (Eigen::Index k = 0; k < variances.size(); ++k) {
            if (const int i = net.interior_index(stretch[static_cast<size_t>(k)]); i >= 0) {
                result(i) = variances(k);
            }
        }
    }
    return result;
}

void add_tensions(const PlannedFit& planned, double relative_force_std,
                  PredictedPrecision& result) {
    const CableNet& net = planned.net();
    const Eigen::VectorXd& variances = planned.covariance().tensions;
    const Eigen::VectorXd weights = mean_weights(net);
    const Eigen::VectorXd with_mean = planned.linearisation().covariances_with(weights);
    const double of_mean = weights.dot(with_mean);
    const std::vector<bool> slides = edges_that_slide(net);
    result.mean_tension = weights.dot(planned.tensions());
    result.mean_tension_std = std::sqrt(std::max(0.0, of_mean));
    for (int e = 0; e < net.edge_count(); ++e) {
        const double tension = planned.tensions()(e);
        if (planned.is_measured(e) || !(tension > 0.0 || net.is_strut(e)) ||
            !(variances(e) > 0.0) || slides[e]) {
            continue;
        }
        const double noise = relative_force_std * std::abs(tension);
        const double left = of_mean - with_mean(e) * with_mean(e) / (variances(e) + noise * noise);
        result.force_candidates.push_back({.edge = e,
                                           .tension = tension,
                                           .std_dev = std::sqrt(variances(e)),
                                           .mean_std_if_measured = std::sqrt(std::max(0.0, left))});
    }
    std::ranges::sort(result.force_candidates, {}, [](const TensionPrecision& t) {
        return std::pair(t.mean_std_if_measured, t.edge);
    });
}

}  // namespace

int PredictedPrecision::count(EdgeStatus status) const {
    return static_cast<int>(std::ranges::count(edges, status, &EdgePrecision::status));
}

double PredictedPrecision::rms_std() const {
    double sum = 0.0;
    for (const EdgePrecision& e : edges) {
        sum += e.std_dev * e.std_dev;
    }
    return edges.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(edges.size()));
}

PredictedPrecision predicted_precision(const CableNet& net, const Eigen::Ref<const Points>& form,
                                       const Survey& survey, const LengthPrior& prior,
                                       const PredictOptions& options, const Progress& progress) {
    progress.throw_if_stopped();
    const PlannedFit planned(
        net, form, survey, prior, options.forces,
        options.assume_site && survey.is_noisy()
            ? with_site_assumptions(net, options.uncertain, measured_by(options.forces))
            : options.uncertain);
    progress.throw_if_stopped();
    const Eigen::VectorXd variances = length_variances(planned, prior);
    const std::vector<int> slack = slack_edges(net, net.unstressed_lengths(), form);
    const double slip_std = planned.model().common.slip_std();
    const std::vector<bool> slides = edges_that_slide(net);
    PredictedPrecision result{.prior_std = prior.std_dev(), .edges = {}};
    result.edges.resize(net.interior_edges().size());
    parallel_for(0, net.interior_edge_count(), [&](int i) {
        progress.throw_if_stopped();
        const int edge = net.interior_edges()[i];
        const double std_dev = std::sqrt(variances(i));
        const bool is_slack = std::ranges::binary_search(slack, edge);
        result.edges[static_cast<size_t>(i)] = {
            .edge = edge,
            .std_dev = std_dev,
            .status = is_slack       ? EdgeStatus::slack
                      : slides[edge] ? status_of(std::hypot(prior.std_dev(), slip_std), std_dev)
                                     : probable_status(prior, std_dev)};
    });
    add_tensions(planned, options.relative_force_std, result);
    return result;
}

}  // namespace taut
