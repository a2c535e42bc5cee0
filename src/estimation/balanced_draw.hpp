// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "estimation/draw_fit.hpp"
#include "estimation/drawn_posterior.hpp"
#include "numerics/random_numbers.hpp"
#include "taut/sampling/model_perturbation.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {

/// A draw of the posterior in exact equilibrium.
struct BalancedDraw {
    Eigen::VectorXd deviations;  ///< of lengths between nodes, with what slid (m_I) [m]
    Points form;                 ///< 3 x n [m]
    Eigen::VectorXd tensions;    ///< of all edges (m) [N]
    /// What deviates from the net besides lengths, if anything can.
    std::optional<ModelPerturbation> perturbation;
    /// Squared distance of form and measured tensions from those of the fit, in standard deviations
    /// of the observations.
    double squared_departure = 0.0;
    double squared_tension_departure = 0.0;  ///< the same of the tensions of all edges [N2]
};

/// Brings a fit to exact equilibrium, with a length and a stiffness for each edge.
/// @param solver of the posterior's net
/// @return nothing where a length is not positive, or there is no equilibrium
[[nodiscard]] std::optional<BalancedDraw> balanced_draw(const DrawnPosterior& posterior,
                                                        const DrawFit& fit, RandomNumbers& random,
                                                        EquilibriumSolver& solver);

}  // namespace taut
