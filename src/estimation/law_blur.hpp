// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/sampling/uncertain_parameter.hpp"

namespace taut {

/// What a linearisation cannot follow, represented as additional length deviations.
///
/// Tension laws are averaged over strains with these standard deviations, which smooths corners and
/// flat parts; what the tangents then miss counts as such a deviation, docs/theory.md
/// (blurred-law). So does the stiffness of each edge: an edge stiffer by some part is as tense as
/// one shorter by that part of its stretch, (own-stiffness).
struct LawBlur {
    Eigen::VectorXd strain_stds;  ///< m; empty: tension laws as they are [-]
    Eigen::VectorXd missed;       ///< m_I, variance of that deviation; empty with strain_stds [m2]
    Eigen::VectorXd stiffness;    ///< m_I, the same of the stiffness; empty where it is known [m2]

    /// Whether no standard deviation differs by more than a tenth.
    [[nodiscard]] bool agrees_with(const LawBlur& other) const;
    [[nodiscard]] bool empty() const { return strain_stds.size() + stiffness.size() == 0; }
    /// Variance of the additional deviations, all together (m_I) [m2].
    [[nodiscard]] Eigen::VectorXd length_variances(Eigen::Index count) const;
};

/// The blur before a fit, by the nominal stretch.
/// @param extension_std standard deviation of all extensions [m]
/// @param uncertain of the net
[[nodiscard]] LawBlur blur_by(const CableNet& net, double extension_std,
                              const std::vector<UncertainParameter>& uncertain = {});

}  // namespace taut
