// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// Which interior edges' unstressed lengths follow from a form, and how well. The form gives all
/// lengths l; the adjustable edges' l_0 are known, so their tensions are, too. What is left to
/// find is linear in 1/l_0 (eq. h): with the equilibrium matrix A_I of the taut interior edges,
///
///     B (1/l_0) = known forces,   B = A_I diag(EA l)
///
/// A length is determined if no solution of B x = 0 has this entry: if no state of self-stress
/// among the interior edges alone passes through its edge. A slack edge is not determined: the form
/// only shows that l_0 >= l.
struct Identifiability {
    std::vector<int> determined;    ///< interior edges, ascending
    std::vector<int> undetermined;  ///< taut, but in a free self-stress; ascending
    std::vector<int> slack;         ///< interior edges without tension, ascending
    int free_self_stress = 0;       ///< independent states of self-stress of the interior edges
    /// Of the map from determined 1/l_0 to forces, whatever the undetermined ones are: the largest
    /// and the smallest factor by which it stretches; 0 where nothing is determined [N m].
    double largest_singular_value = 0.0;
    double smallest_singular_value = 0.0;  ///< the smallest, likewise [N m]

    /// By how much a relative error can be larger in 1/l_0 than in the forces, at most [-].
    [[nodiscard]] double condition() const {
        return smallest_singular_value > 0.0 ? largest_singular_value / smallest_singular_value
                                             : 0.0;
    }
};

/// Which lengths follow from a form.
/// @param unstressed_lengths l_0 of all edges (m) [m]
/// @param form an equilibrium form for them (3 x n) [m]
/// @throws std::invalid_argument for wrong sizes, lengths that are not positive and finite,
///   coordinates that are not finite
[[nodiscard]] TAUT_CORE_EXPORT Identifiability
identifiability(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                const Eigen::Ref<const Points>& form);

}  // namespace taut
