// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/over_priors.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <utility>

#include "estimation/perturbed_draws.hpp"
#include "identification/prior_mixture.hpp"
#include "identification/under_prior.hpp"

namespace taut {
namespace {

/// Distance of two standard deviations, as a logarithm.
double distance(double std_dev, const LengthPrior& prior) {
    return std::abs(std::log(std_dev / prior.std_dev()));
}

/// A fit with a prior far from the truth rejects sound targets and lengths. So it is repeated with
/// the prior that it shows, until that stays.
/// @return with the last prior
std::pair<Identification, AssumedPrior> identify_at_centre(
    IdentificationMethod method, const CableNet& net, const Survey& survey,
    const AssumedPrior& first, const IdentifyOptions& options, const Progress& progress) {
    constexpr double far = 0.25;
    constexpr int most_centres = 3;
    AssumedPrior prior = first;
    Identification result = identify_under_prior(method, net, survey, prior, options, progress);
    const PriorCheck by_given = result.prior_check;
    for (int k = 0; k < most_centres && result.status == IdentificationStatus::converged &&
                    !result.prior.exact && distance(result.prior.std_dev, prior.prior) > far;
         ++k) {
        prior.prior = central_prior(result.prior);
        result = identify_under_prior(method, net, survey, prior, options, progress);
    }
    if (options.prior && by_given.is_untenable() && !by_given.is_too_wide()) {
        result.contradicted_prior = by_given;
    }
    return {std::move(result), prior};
}

}  // namespace

Identification identify_over_priors(IdentificationMethod method, const CableNet& net,
                                    const Survey& survey, const IdentifyOptions& options,
                                    const Progress& progress) {
    constexpr double as_good_as = 0.05;
    const Hyperprior around =
        options.prior ? hyperprior_around(*options.prior) : broad_hyperprior();
    const PosteriorSettings wanted = wanted_by(net, options);
    AssumedPrior first{
        .prior = around.centre, .around = around, .has_trend = true, .wanted = wanted};
    if (can_be_chained(net)) {  // a mixture as a rule; else a fit more, which is short
        first.wanted.count = 0;
    }
    auto found = identify_at_centre(method, net, survey, first, options, progress);
    Identification& centre = found.first;
    const auto centre_alone = [&] {
        AssumedPrior by = found.second;
        if (method != IdentificationMethod::map || by.wanted.count == wanted.count) {
            return centre;
        }
        by.wanted = wanted;
        Identification drawn = identify_under_prior(method, net, survey, by, options, progress);
        drawn.contradicted_prior = centre.contradicted_prior;
        drawn.prior = centre.prior;
        return drawn;
    };
    PriorEstimate& prior = centre.prior;
    if (centre.status != IdentificationStatus::converged) {
        return centre;
    }
    if (prior.exact) {
        return centre_alone();
    }
    if (method == IdentificationMethod::gp && prior.nodes.size() > 1) {
        // Training takes long: one model for all.
        prior.nodes = {{.prior = central_prior(prior)}};
    }
    if (prior.nodes.size() == 1 && prior.nodes.front().prior.kind == centre.length_prior.kind &&
        distance(prior.nodes.front().prior.std_dev(), centre.length_prior) < as_good_as) {
        prior.nodes.front().prior = centre.length_prior;
        return centre_alone();
    }
    auto mixture = mixture_over(
        net, survey, prior.nodes, wanted, [&](size_t k, const PosteriorSettings& of_part) {
            return std::optional(identify_under_prior(
                method, net, survey,
                {.prior = prior.nodes[k].prior, .around = {}, .has_trend = true, .wanted = of_part},
                options, progress));
        });
    if (!mixture) {
        return centre_alone();
    }
    Identification result = *std::move(mixture);
    prior.common = result.prior.common;
    result.prior = std::move(prior);
    result.contradicted_prior = centre.contradicted_prior;
    result.description += fmt::format(
        "\n  over {} priors: standard deviation of a length {:.2f} +- {:.2f} mm",
        result.prior.nodes.size(), 1e3 * result.prior.std_dev, 1e3 * result.prior.std_std);
    return result;
}

}  // namespace taut
