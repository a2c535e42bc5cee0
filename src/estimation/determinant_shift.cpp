// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/determinant_shift.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "estimation/draw_fit.hpp"
#include "estimation/imagined_observations.hpp"
#include "estimation/marginal_mode.hpp"
#include "estimation/prestress_shift.hpp"
#include "numerics/parallel.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// Fits to perturbed sites, other ones than the draws, with the determinant at each.
std::vector<PerturbedFit> fits_with_determinants(const DrawnPosterior& posterior,
                                                 const Observations& sites, bool by_fits,
                                                 const Progress& progress) {
    constexpr int samples = 40;  // the mean of a normal number is then known to 0.16
    constexpr std::uint32_t other_than_draws = 0x40000000U;
    const Observations leading = with_leading_means(posterior.sites);
    const Eigen::VectorXd weights = mean_weights(posterior.net());
    std::vector<std::optional<PerturbedFit>> fits(samples);
    PerThread<std::optional<Linearisation>> linearisations;
    parallel_for(0, samples, [&](int k) {
        progress.throw_if_stopped();
        isolate([&] {
            std::optional<Linearisation>& last = linearisations.local();
            RandomNumbers random(posterior.seed, other_than_draws + static_cast<std::uint32_t>(k));
            std::optional<DrawFit> found = fit_perturbed(posterior, sites, by_fits, random, last);
            if (!found) {
                return;
            }
            last = linearise(posterior.model(found->is_refitted), found->iterate, leading,
                             std::move(last));
            if (last) {
                fits[k] = {.iterate = std::move(found->iterate),
                           .mean_tension = weights.dot(found->tensions),
                           .half_log_determinant = last->half_log_determinant(leading)};
            }
        });
    });
    std::vector<PerturbedFit> result;
    for (auto& fit : fits) {
        if (fit) {
            result.push_back(*std::move(fit));
        }
    }
    return result;
}

/// All that is observed and assumed, moved so that fits move by this, to first order.
Observations moved_sites(const DrawnPosterior& posterior, const Iterate& shift) {
    const StaticsModel& model = posterior.fit.model();
    const Observations& sites = posterior.sites;
    const Iterate& fitted = posterior.fit.iterate;
    const Iterate at = fitted.moved(shift);
    Observations result = sites;
    result.form += shift.form;
    result.support_mean += model.support_deviations(at) - model.support_deviations(fitted);
    result.mean += shift.deviations;
    result.load_mean += shift.loads;
    result.common_mean += shift.common;
    result.tension += sites.measured(model.tensions(at), at.common) -
                      sites.measured(model.tensions(fitted), fitted.common);
    if (sites.evidence) {
        result.evidence_pull +=
            sites.evidence->information * shift.lengths_and_common(result.evidence_pull.size());
    }
    return result;
}

/// The part of a change of deviations (m_I) that is of lengths, and not of the stiffness of each
/// edge, (own-stiffness) (m_I) [m].
Eigen::VectorXd without_own_stiffness(const DrawnPosterior& posterior, Eigen::VectorXd deviations,
                                      bool is_refitted) {
    const Eigen::VectorXd& of_stiffness = posterior.fit.model().blur.stiffness;
    if (of_stiffness.size() > 0) {
        const Eigen::VectorXd all =
            posterior.sites.variance + posterior.blur_variances(is_refitted);
        deviations.array() *= 1.0 - of_stiffness.array() / all.array();
    }
    return deviations;
}

}  // namespace

ShiftedSites shifted_by_determinant(const DrawnPosterior& posterior, bool by_fits,
                                    const Progress& progress) {
    constexpr double large = 1.0;  // it changes the determinant's slope: once more, from there
    ShiftedSites result{.sites = posterior.sites, .length_shift = {}};
    const auto shift = [&] {
        return prestress_shift(fits_with_determinants(posterior, result.sites, by_fits, progress));
    };
    std::optional<PrestressShift> found = shift();
    if (!found) {
        return result;
    }
    result.sites = moved_sites(posterior, found->by);
    if (found->size < large) {
        return result;
    }
    if (std::optional<PrestressShift> again = shift()) {
        found = std::move(again);
        result.sites = moved_sites(posterior, found->by);
    }
    const Eigen::VectorXd slid =
        posterior.fit.model().common.slip_rates(posterior.net().interior_edges()) *
        found->by.common;
    result.length_shift =
        without_own_stiffness(posterior, std::move(found->by.deviations), by_fits) + slid;
    return result;
}

}  // namespace taut
