// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// How a search for equilibrium ended.
enum class EquilibriumStatus {
    converged,        ///< all forces balance, and the form is unique
    slack_mechanism,  ///< all forces balance, but slack edges leave some nodes loose
    iteration_limit,  ///< forces do not balance within the tolerance
    unstable,         ///< all forces balance, but struts give way: no minimum of the energy
};

/// "converged", "slack mechanism", "unstable", "iteration limit".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(EquilibriumStatus status);

/// Whether a net can stand in a form that was found so: converged, or slack mechanism.
[[nodiscard]] constexpr bool is_balanced(EquilibriumStatus status) {
    return status == EquilibriumStatus::converged || status == EquilibriumStatus::slack_mechanism;
}

/// Stopping criteria.
struct EquilibriumSettings {
    int max_iterations = 500;  ///< Newton and interior-point steps together, 0 or more
    /// Largest out-of-balance force at a node that counts as balanced, relative to the mean tension
    /// of the taut edges (to the mean load if all are slack; of struts the size counts). The solver
    /// continues below it until rounding errors stop it or a hundredth of it is reached. Forces
    /// within the rounding error of the coordinates (some 1e-15 times the largest coordinate times
    /// EA/l_0) also count as balanced. They exceed the tolerance in nets that are barely tense, or
    /// whose stiffnesses differ by orders of magnitude. If they exceed 1e-4 of the mean tension and
    /// of the mean load, and 1e-13 of EA, the net is not balanced.
    double relative_tolerance = 1e-10;
};

/// The form a net takes: the minimiser of its energy, with struts a local one.
struct Equilibrium {
    Points form;  ///< 3 x n, supports included [m]
    /// As given; where runs slide, between the nodes after that (m) [m].
    Eigen::VectorXd unstressed_lengths = {};
    EquilibriumStatus status = EquilibriumStatus::iteration_limit;  ///< how the iterations ended
    int iterations = 0;  ///< Newton and interior-point steps taken
    /// Largest norm of a nodal force h_s, or where runs slide the largest difference of tensions
    /// that slides no further [N].
    double out_of_balance = 0.0;
    /// Over the taut cables; where none is taut, the mean size of the forces of struts [N].
    double mean_tension = 0.0;
    std::vector<int> slack_edges;  ///< ascending
    /// Of each step, summed edge by edge; never negative except for rounding errors. All
    /// interior-point steps together make one entry, if they lower the energy [J].
    std::vector<double> energy_decreases;

    /// is_balanced() of the status.
    [[nodiscard]] bool balanced() const { return is_balanced(status); }
};

/// Solves for the equilibrium of one net with many sets of unstressed lengths. The symbolic work is
/// done once, and the iteration does not allocate. Use one object a thread: solve() works in memory
/// of the object. It holds a copy of what it needs of the net. A moved-from object may only be
/// assigned to or destroyed.
class TAUT_CORE_EXPORT EquilibriumSolver {
public:
    /// @throws std::invalid_argument for a negative max_iterations, or a relative_tolerance that is
    ///   not positive and finite
    explicit EquilibriumSolver(const CableNet& net, EquilibriumSettings settings = {});
    ~EquilibriumSolver();
    EquilibriumSolver(EquilibriumSolver&&) noexcept;             ///< moves
    EquilibriumSolver& operator=(EquilibriumSolver&&) noexcept;  ///< moves
    EquilibriumSolver(const EquilibriumSolver&) = delete;
    EquilibriumSolver& operator=(const EquilibriumSolver&) = delete;

    /// The form r_I = f^-1(l_0) of the paper (eqs. finv, SOCP): Newton's method on the convex
    /// energy, with a line search, and a diagonal shift if slack edges make the stiffness singular.
    /// If many edges go slack or taut on the way, the line search cuts steps short, or 30 steps do
    /// not suffice. Then a primal-dual interior-point method first brings the net near its form.
    /// With struts the energy is not convex: steps are shifted until it falls along them, and no
    /// longer than a quarter of the mean edge, so that the form found is one near the start.
    /// Where runs slide (CableRun::slides_at), length passes on at their nodes from the lengths as
    /// given until tensions balance, docs/theory.md (sliding).
    /// @param unstressed_lengths l_0 of all edges (m), positive [m]
    /// @param start where to begin (3 x n); supports are taken from the net. A node farther from
    /// them
    ///   than ten times the net's total length of cable is moved to this distance [m]
    /// @throws std::invalid_argument for wrong sizes, a length that is not positive and
    ///   finite, or a start that is not finite. Forces that do not balance throw nothing: see
    ///   Equilibrium::status.
    [[nodiscard]] Equilibrium solve(const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                    const Eigen::Ref<const Points>& start);

private:
    struct Workspace;
    std::unique_ptr<Workspace> m_workspace;
};

/// Equilibrium of the net with its own unstressed lengths, from its own nodes: the nominal form.
/// @throws std::invalid_argument as EquilibriumSolver
[[nodiscard]] TAUT_CORE_EXPORT Equilibrium solve_equilibrium(const CableNet& net,
                                                             EquilibriumSettings settings = {});

}  // namespace taut
