// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "taut/net/cable_net.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {

/// A net in equilibrium under some strokes.
struct StrokedNet {
    Eigen::VectorXd unstressed_lengths;  ///< m [m]
    Equilibrium equilibrium;
    /// Tensions of all edges (m). A slack edge has a negative one: its initial stiffness times the
    /// strain it lacks to be taut. Then the reaction at each limited support, as a norm [N].
    Eigen::VectorXd forces;
};

/// The change of form and forces with strokes, to first order.
struct StrokeRates {
    Eigen::MatrixXd form;    ///< 3 n_I x k [m/m]
    Eigen::MatrixXd forces;  ///< as StrokedNet::forces, x k [N/m]
};

/// How one net under one set of loads answers to strokes: exact equilibria and exact derivatives.
class StrokeResponse {
public:
    /// @param edges that may be turned (k)
    /// @param reactions supports whose reactions are computed
    StrokeResponse(const CableNet& net, std::vector<int> edges, std::vector<int> reactions);

    /// @param lengths unstressed, before the strokes (m) [m]
    /// @param start form at which the solver starts (3 x n) [m]
    [[nodiscard]] StrokedNet at(const Eigen::Ref<const Eigen::VectorXd>& lengths,
                                const Eigen::Ref<const Eigen::VectorXd>& strokes,
                                const Points& start);
    [[nodiscard]] StrokeRates rates(const StrokedNet& stroked) const;

    /// A copy for another thread.
    [[nodiscard]] StrokeResponse fresh() const { return of(*m_net); }
    /// The response of another net with the same edges and supports.
    [[nodiscard]] StrokeResponse of(const CableNet& net) const {
        return {net, m_edges, m_reactions};
    }

    [[nodiscard]] const CableNet& net() const { return *m_net; }

private:
    [[nodiscard]] Eigen::VectorXd forces_of(const Eigen::VectorXd& lengths,
                                            const Points& form) const;

    const CableNet* m_net;
    std::vector<int> m_edges;
    std::vector<int> m_reactions;
    EquilibriumSolver m_solver;
};

}  // namespace taut
