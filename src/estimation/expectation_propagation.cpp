// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/expectation_propagation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "estimation/length_likelihoods.hpp"

namespace taut {
namespace {

constexpr int most_rounds = 30;
constexpr int most_iterations = 20;

/// Where the means move by no more than this part of their standard deviations, root mean square.
constexpr double settled_part = 0.02;

/// A part of each change is left out, so that edges that are known only together do not swing
/// between each other.
constexpr double site_damping = 0.8;

/// Least precision of a site in that of the law. Where the law does not show, its site would be
/// infinitely wide; and a law with two modes can widen a length, which no normal prior does.
constexpr double least_precision = 1e-4;

/// Under the law: then its likelihood is no normal one.
bool may_be_slack(const LengthLaw& law, const LengthLikelihood& likelihood) {
    constexpr double surely_taut = 4.0;  // standard deviations
    constexpr double small_probability = 0.01;
    return likelihood.extension < surely_taut &&
           posterior_of(law, likelihood).slack_probability > small_probability;
}

/// One round of (tilted) and (site).
/// @return root mean square distance of the tilted means from the fit's, in tilted standard
///   deviations
double update_sites(const CableNet& net, const LengthLaw& law, const LinearisedStatics& statics,
                    const Iterate& fitted, Observations& observations) {
    const std::vector<LengthLikelihood> likelihoods =
        length_likelihoods(net, statics, observations, fitted);
    const double law_precision = 1.0 / (law.std() * law.std());
    double squares = 0.0;
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        LengthLikelihood cavity = likelihoods[i];
        if (may_be_slack(law, cavity)) {
            continue;
        }
        cavity.extension = std::numeric_limits<double>::infinity();
        const auto [mean, variance] = moments_of(law, cavity);  // (tilted)
        const double of_cavity = 1.0 / (cavity.std * cavity.std);
        const double precision =
            std::max(least_precision * law_precision, 1.0 / variance - of_cavity);  // (site)
        const double pull = (precision + of_cavity) * mean - of_cavity * cavity.mean;
        squares += std::pow(mean - fitted.deviations(i), 2) / variance;
        const double old_precision = 1.0 / observations.variance(i);
        const double old_pull = old_precision * observations.mean(i);
        const double new_precision = old_precision + site_damping * (precision - old_precision);
        observations.variance(i) = 1.0 / new_precision;
        observations.mean(i) = (old_pull + site_damping * (pull - old_pull)) / new_precision;
    }
    return std::sqrt(squares / std::max(1, net.interior_edge_count()));
}

/// One step of the fit to the sites as they now are.
/// @return false where it leads nowhere
bool follow_sites(LinearisedStatics& statics, Propagated& state) {
    if (!statics.linearise(state.iterate, state.observations)) {
        return false;
    }
    statics.invert();
    const Iterate step = statics.step(state.iterate, state.observations);
    state.iterate = {.form = state.iterate.form + step.form,
                     .deviations = state.iterate.deviations + step.deviations};
    return step.form.allFinite() && step.deviations.allFinite();
}

}  // namespace

Propagated propagate_law(const CableNet& net, const LengthLaw& law, LinearisedStatics& statics,
                         const Observations& observations, const Iterate& fitted,
                         double tolerance) {
    Propagated result{.observations = observations, .iterate = fitted};
    if (law.kind == LengthLaw::Kind::normal) {
        return result;
    }
    bool has_settled = false;
    for (int round = 0; round < most_rounds; ++round) {
        const double moved = update_sites(net, law, statics, result.iterate, result.observations);
        // One step a round; the last ones are gauss_newton()'s.
        if (moved <= settled_part || !follow_sites(statics, result)) {
            GaussNewtonResult fit = gauss_newton(statics, result.observations, result.iterate,
                                                 tolerance, most_iterations);
            result.iterate = std::move(fit.iterate);
            has_settled = fit.converged && moved <= settled_part;
            break;
        }
    }
    if (!has_settled) {
        result = {.observations = observations, .iterate = fitted};
        (void)statics.linearise(fitted, observations);
    }
    statics.invert();
    return result;
}

}  // namespace taut
