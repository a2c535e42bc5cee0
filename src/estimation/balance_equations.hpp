// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>
#include <utility>
#include <vector>

#include "numerics/sparse_cholesky.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The balance of a known form, docs/theory.md (balance): h = 0 (eq. hq) is linear in the tensions,
/// and so in y, with T / l = T / l at the nominal length + EA / nominal y of the interior edges.
/// Where the edge is linear this is 1/l_0 = (1 + y) / nominal. Solved by sparse least squares, each
/// node's forces in terms of its move, so that soft parts count as much as stiff ones. Lengths that
/// the forces do not show stay nominal.
class BalanceEquations {
public:
    /// @param form 3 x n [m]
    /// @param slack edges (m) that carry nothing
    BalanceEquations(const CableNet& net, const Points& form, const std::vector<bool>& slack);

    /// y of least squares (m_I), by the normal equations and refinements, which bring back the
    /// digits that they lose.
    [[nodiscard]] Eigen::VectorXd solve() const;

    /// Edges (m_I) that have a part in a free state of self-stress, or are slack: the balance holds
    /// whatever their share of it. Each pass of inverse iteration takes most of what is not in the
    /// null space out of a vector that has a part in all of it.
    [[nodiscard]] std::vector<bool> undetermined() const;

private:
    Eigen::VectorXd m_forces;  ///< at y = 0
    Eigen::SparseMatrix<double> m_matrix;
    double m_shift = 0.0;
    std::optional<SparseCholesky> m_factor;  ///< of the normal equations
};

/// The least and the greatest l_0 of an edge with its y [m]; not positive where no positive length
/// has that tension. They differ where its tension law is flat.
[[nodiscard]] std::pair<double, double> unstressed_lengths_from(const CableNet& net, int edge,
                                                                double length, double y);

}  // namespace taut
