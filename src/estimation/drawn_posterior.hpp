// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "estimation/prior_knowledge.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The posterior that draws are of: a fit, what it was made of, and what all draws share.
struct DrawnPosterior {
    /// Keeps references.
    /// @param sites_of_fit with the prior that the fit was made with
    DrawnPosterior(const LinearisedFit& fitted, const Observations& sites_of_fit,
                   const PriorKnowledge& known, std::uint64_t seed_of_draws);

    const LinearisedFit& fit;
    const Observations& sites;
    const PriorKnowledge& knowledge;
    std::uint64_t seed;
    /// Of draws that are fitted by themselves: no cable carries pressure, and tension laws are
    /// their own, (rounded-law).
    StaticsModel tensile_model;
    /// The fit with every edge stretched at least as in the nominal form: a slack edge does not
    /// find its way back to tension.
    Iterate all_taut;

    [[nodiscard]] const CableNet& net() const { return fit.model().net(); }
    [[nodiscard]] const StaticsModel& model(bool is_refitted) const {
        return is_refitted ? tensile_model : fit.model();
    }
    /// Smallest standard deviation of a surveyed coordinate [m].
    [[nodiscard]] double smallest_noise() const;
    /// LawBlur::length_variances() of model() (m_I) [m2].
    [[nodiscard]] Eigen::VectorXd blur_variances(bool is_refitted) const;
};

}  // namespace taut
