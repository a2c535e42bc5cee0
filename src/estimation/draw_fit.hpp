// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "estimation/drawn_posterior.hpp"
#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "numerics/random_numbers.hpp"

namespace taut {

/// Draws that are fitted come to their tension laws in stages, each from the one before it: laws
/// are blurred by these parts of the blur of the fit.
inline constexpr std::array blurs_of_draws{1.0, 0.5, 0.25, 0.125};

/// A draw before it is in exact equilibrium: a fit to perturbed observations, (perturbed), or a
/// sample of a chain, (hamiltonian).
struct DrawFit {
    Iterate iterate;
    Eigen::VectorXd tensions;    ///< of all edges in it (m) [N]
    Eigen::VectorXd prior_mean;  ///< drawn, of the length deviations (m_I) [m]
    bool is_refitted = false;    ///< DrawnPosterior::model()
};

/// Perturbs observations and priors, and fits these, docs/theory.md (perturbed): by steps with the
/// factor of the fit, or where these do not contract on a linear net, by a fit of its own.
/// @param sites of the posterior, perhaps moved
/// @param by_fits whether to fit in any case
/// @param last linearisation of a fit on this thread, whose memory is used again
/// @return nothing where there is no fit
[[nodiscard]] std::optional<DrawFit> fit_perturbed(const DrawnPosterior& posterior,
                                                   const Observations& sites, bool by_fits,
                                                   RandomNumbers& random,
                                                   std::optional<Linearisation>& last);

}  // namespace taut
