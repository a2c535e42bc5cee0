// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/expectation_propagation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/gauss_newton.hpp"
#include "estimation/length_likelihoods.hpp"
#include "numerics/truncated_mixture.hpp"

namespace taut {
namespace {

constexpr int most_rounds = 30;
constexpr int most_iterations = 20;

/// Where the means move by no more than this part of their standard deviations, root mean square.
constexpr double converged_part = 0.02;

/// Part of each change that is applied, so that edges known only together do not oscillate.
constexpr double site_damping = 0.8;

/// Least precision of a site, in that of the prior. Where the prior has no effect its site would be
/// infinitely wide, and a prior with two modes can widen a length, which no normal site can.
constexpr double least_precision = 1e-4;

/// Whether the edge may be slack under the prior: then its likelihood is not normal.
bool may_be_slack(const LengthPrior& prior, const LengthLikelihood& likelihood) {
    constexpr double small_probability = 0.01;
    return likelihood.extension < surely_taut_extension &&
           posterior_of(prior, likelihood).slack_probability > small_probability;
}

/// Distance of the tilted means from the fit's, in tilted standard deviations.
struct Distance {
    double squares = 0.0;
    int count = 0;

    void add(double tilted_mean, double fitted, double tilted_variance) {
        squares += std::pow(tilted_mean - fitted, 2) / tilted_variance;
        ++count;
    }
    [[nodiscard]] double rms() const { return std::sqrt(squares / std::max(1, count)); }
};

/// One round of (tilted) and (site).
void update_length_sites(const PriorKnowledge& knowledge, const LinearisedFit& fitted,
                         Observations& observations, Distance& distance) {
    const std::vector<LengthLikelihood> likelihoods = length_likelihoods(
        knowledge, fitted.model(), fitted.covariance, observations, fitted.iterate);
    const Eigen::VectorXd blur = fitted.model().blur.length_variances(observations.variance.size());
    for (int i = 0; i < blur.size(); ++i) {
        const LengthPrior& prior = knowledge.priors[i];
        LengthLikelihood cavity = likelihoods[i];
        if (may_be_slack(prior, cavity)) {
            continue;
        }
        cavity.extension = std::numeric_limits<double>::infinity();
        const auto [mean, variance] = moments_of(prior, cavity);  // (tilted)
        const double of_cavity = 1.0 / (cavity.std_dev * cavity.std_dev);
        const double precision = std::max(least_precision / (prior.std_dev() * prior.std_dev()),
                                          1.0 / variance - of_cavity);  // (site)
        const double pull = (precision + of_cavity) * mean - of_cavity * cavity.mean;
        // The fitted deviation includes that of the blur; this part is the edge's own.
        const double own = observations.variance(i) / (observations.variance(i) + blur(i));
        distance.add(
            mean,
            observations.mean(i) + own * (fitted.iterate.deviations(i) - observations.mean(i)),
            variance);
        const double old_precision = 1.0 / observations.variance(i);
        const double old_pull = old_precision * observations.mean(i);
        const double new_precision = old_precision + site_damping * (precision - old_precision);
        observations.variance(i) = 1.0 / new_precision;
        observations.mean(i) = (old_pull + site_damping * (pull - old_pull)) / new_precision;
    }
}

/// Sites of the tensions of edges seen taut, in addition to force measurements. Beside one whose
/// error is shared, what a site says of the shared error is left out.
class TautSites {
public:
    TautSites(const PriorKnowledge& knowledge, const Observations& observations)
        : m_edges(knowledge.forces.taut),
          m_measured(observations.tension),
          m_measured_weights(observations.tension_weights),
          m_measured_bias(observations.tension_bias),
          m_precision(Eigen::VectorXd::Zero(m_measured.size())),
          m_pull(m_precision) {}

    /// One round of (tilted-taut) and (site).
    void update(const LinearisedFit& fitted, Observations& observations, Distance& distance) {
        const Eigen::VectorXd tensions = fitted.model().tensions(fitted.iterate);
        const Eigen::VectorXd& variances = fitted.covariance.tensions;
        for (const int e : m_edges) {
            const double cavity_precision = 1.0 / variances(e) - m_precision(e);
            if (!(variances(e) > 0.0) || !(cavity_precision > 0.0)) {
                continue;
            }
            const double mean = (tensions(e) / variances(e) - m_pull(e)) / cavity_precision;
            const TruncatedNormal above_zero{.mean = mean,
                                             .std_dev = 1.0 / std::sqrt(cavity_precision),
                                             .lower = 0.0,
                                             .upper = std::numeric_limits<double>::infinity()};
            const TruncatedMixture tilted({above_zero});  // (tilted-taut)
            const auto [tilted_mean, variance] = tilted.moments();
            const double precision = std::max(0.0, 1.0 / variance - cavity_precision);
            const double pull =
                (precision + cavity_precision) * tilted_mean - cavity_precision * mean;
            distance.add(tilted_mean, tensions(e), variance);
            m_precision(e) += site_damping * (precision - m_precision(e));
            m_pull(e) += site_damping * (pull - m_pull(e));
            observations.tension_weights(e) = m_measured_weights(e) + m_precision(e);
            if (observations.tension_weights(e) > 0.0) {
                observations.tension(e) = (m_measured_weights(e) * m_measured(e) + m_pull(e)) /
                                          observations.tension_weights(e);
                // What a site says is of the tension itself.
                observations.tension_bias.row(e) = m_measured_weights(e) /
                                                   observations.tension_weights(e) *
                                                   m_measured_bias.row(e);
            }
        }
    }

private:
    const std::vector<int>& m_edges;
    Eigen::VectorXd m_measured;
    Eigen::VectorXd m_measured_weights;
    Eigen::MatrixXd m_measured_bias;
    Eigen::VectorXd m_precision;  ///< of the sites, by edge [1/N2]
    Eigen::VectorXd m_pull;       ///< precision times mean [1/N]
};

/// The sites where they converge, else nothing.
std::optional<Propagated> converged_sites(const PriorKnowledge& knowledge, LinearisedFit start,
                                          Observations sites, double tolerance) {
    const StaticsModel model = start.model();
    TautSites taut(knowledge, sites);
    std::optional<LinearisedFit> fit = std::move(start);
    for (int round = 0; fit && round < most_rounds; ++round) {
        Distance distance;
        update_length_sites(knowledge, *fit, sites, distance);
        taut.update(*fit, sites, distance);
        if (distance.rms() > converged_part) {
            fit = (*std::move(fit)).stepped(sites);  // one step a round
            continue;
        }
        GaussNewtonResult last = gauss_newton(model, sites, std::move(fit->iterate), tolerance,
                                              most_iterations, {}, std::move(fit->linearisation));
        if (!last.converged) {
            break;
        }
        Covariance covariance = last.linearisation->covariance();
        return Propagated{
            std::move(sites),
            {std::move(last.iterate), *std::move(last.linearisation), std::move(covariance)}};
    }
    return std::nullopt;
}

}  // namespace

Propagated propagate_prior(const PriorKnowledge& knowledge, LinearisedFit fitted,
                           const Observations& observations, double tolerance) {
    const bool is_normal = std::ranges::all_of(knowledge.priors, [](const LengthPrior& prior) {
        return prior.kind == LengthPrior::Kind::normal;
    });
    if (is_normal && knowledge.forces.taut.empty()) {
        return {observations, std::move(fitted)};
    }
    const StaticsModel model = fitted.model();
    const Iterate at = fitted.iterate;
    std::optional<Propagated> found =
        converged_sites(knowledge, std::move(fitted), observations, tolerance);
    return found ? *std::move(found)
                 : Propagated{observations, linearised_fit(model, at, observations)};
}

}  // namespace taut
