// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/draw_fit.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "estimation/feasible_descent.hpp"
#include "estimation/imagined_observations.hpp"
#include "estimation/perturbed_draws.hpp"

namespace taut {
namespace {

/// Steps with the factor of the fit, each with the misfit and the forces at the result of the one
/// before; shorter ones where these overshoot. Nothing where they do not converge.
std::optional<DrawFit> followed(const DrawnPosterior& posterior, const Observations& observations) {
    constexpr double small_step = 0.1;  // of the smallest standard deviation of the survey
    constexpr double slow_contraction = 0.7;
    constexpr double least_part = 0.1;
    const bool is_linear = posterior.net().is_linear();
    const int most_steps = is_linear ? 20 : 60;
    const double small = small_step * posterior.smallest_noise();
    const Linearisation& linearisation = posterior.fit.linearisation;
    Iterate iterate = posterior.fit.iterate;
    double before = std::numeric_limits<double>::infinity();
    double part = 1.0;
    for (int k = 0; k < most_steps; ++k) {
        const Iterate change = linearisation.step(iterate, observations);
        const double size = linearisation.size_of(change);
        if (!(size < slow_contraction * before)) {
            // On a linear net the draw is then fitted by itself.
            part *= 0.5;
            if (is_linear || part < least_part || !std::isfinite(size)) {
                return std::nullopt;
            }
        }
        iterate = iterate.moved(change, part);
        if (size < small) {
            DrawFit fit;
            fit.tensions = posterior.fit.model().tensions(iterate);
            fit.iterate = std::move(iterate);
            return fit;
        }
        before = size;
    }
    return std::nullopt;
}

/// A fit of its own; of a net with tension laws the last stage that converged.
std::optional<DrawFit> refitted(const DrawnPosterior& posterior, const Observations& observations,
                                std::optional<Linearisation>& last) {
    constexpr double small_decrement = 0.05;
    // A sample that takes more is far from normal: chains can follow it.
    constexpr int most_before_chains = 60;
    const int most = can_be_chained(posterior.net()) ? most_before_chains : most_descents;
    Iterate start = posterior.all_taut;
    StaticsModel model = posterior.tensile_model;
    std::optional<DrawFit> found;
    for (const double part : blurs_of_draws) {
        model.blur.strain_stds = part * posterior.tensile_model.blur.strain_stds;
        GaussNewtonResult fit = feasible_descent(model, observations, start, small_decrement, most,
                                                 {}, std::move(last));
        last = std::move(fit.linearisation);
        if (!fit.converged) {
            break;
        }
        start = std::move(fit.iterate);
        found.emplace();
        found->iterate = start;
        found->tensions = model.tensions(start);
        found->is_refitted = true;
        if (posterior.net().is_linear()) {
            break;
        }
    }
    return found;
}

}  // namespace

std::optional<DrawFit> fit_perturbed(const DrawnPosterior& posterior, const Observations& sites,
                                     bool by_fits, RandomNumbers& random,
                                     std::optional<Linearisation>& last) {
    const CableNet& net = posterior.net();
    Observations of_mean = with_drawn_mean(sites, random);
    const Observations again = perturbed(net, of_mean, posterior.blur_variances(by_fits), random);
    std::optional<DrawFit> fit = by_fits ? std::nullopt : followed(posterior, again);
    if (!fit && (by_fits || (net.is_linear() && can_be_fitted(net)))) {
        fit = refitted(posterior, again, last);
    }
    if (fit) {
        fit->prior_mean = std::move(of_mean.mean);
    }
    return fit;
}

}  // namespace taut
