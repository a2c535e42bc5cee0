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
    converged,        ///< all forces balance, and the form is the only one that does this
    slack_mechanism,  ///< all forces balance, but slack edges leave some nodes loose
    iteration_limit,  ///< forces do not balance within the tolerance
};

/// "converged", "slack mechanism", "iteration limit".
[[nodiscard]] TAUT_CORE_EXPORT std::string_view to_string(EquilibriumStatus status);

/// When to stop.
struct EquilibriumSettings {
    int max_iterations = 500;  ///< Newton and interior-point steps together, 0 or more
    /// Largest out-of-balance force at a node that counts as balanced, in mean tensions of the taut
    /// edges (in mean loads where all are slack). The solver goes on below it until rounding errors
    /// stop it or a hundredth is reached. Forces that are but the rounding error of the coordinates
    /// (some 1e-15 times the largest coordinate times EA/l_0) count as balanced, too: they exceed
    /// the tolerance in a net that is barely tense, or whose stiffnesses differ by orders of
    /// magnitude. Where they exceed a ten thousandth of the mean tension, too, and of the mean load
    /// and a billionth of EA, nothing balances.
    double relative_tolerance = 1e-10;
};

/// The form a net takes: the minimiser of its energy.
struct Equilibrium {
    Points form;  ///< 3 x n, supports included [m]
    EquilibriumStatus status = EquilibriumStatus::iteration_limit;  ///< how the search ended
    int iterations = 0;            ///< Newton and interior-point steps taken
    double out_of_balance = 0.0;   ///< largest norm of a nodal force h_s [N]
    double mean_tension = 0.0;     ///< over the taut edges [N]
    std::vector<int> slack_edges;  ///< ascending
    /// Of each step, summed edge by edge; never negative but for rounding errors. All
    /// interior-point steps together make one entry, if they lower the energy [J].
    std::vector<double> energy_decreases;

    /// Forces balance: status is not iteration_limit.
    [[nodiscard]] bool balanced() const { return status != EquilibriumStatus::iteration_limit; }
};

/// Solves for the equilibrium of one net with many sets of unstressed lengths. Does the symbolic
/// work once; the iteration allocates nothing. One object a thread: solve() works in memory of the
/// object. Holds a copy of what it needs of the net. Once moved from, it may only be assigned to or
/// destroyed.
class TAUT_CORE_EXPORT EquilibriumSolver {
public:
    /// @throws std::invalid_argument for a negative max_iterations, or a relative_tolerance that is
    ///   not positive and finite
    explicit EquilibriumSolver(const CableNet& net, EquilibriumSettings settings = {});
    ~EquilibriumSolver();
    /// Leaves the other one without a net.
    EquilibriumSolver(EquilibriumSolver&&) noexcept;
    /// Leaves the other one without a net.
    EquilibriumSolver& operator=(EquilibriumSolver&&) noexcept;
    EquilibriumSolver(const EquilibriumSolver&) = delete;
    EquilibriumSolver& operator=(const EquilibriumSolver&) = delete;

    /// The form r_I = f^-1(l_0) of the paper (eqs. finv, SOCP): Newton's method on the convex
    /// energy, with a line search and a diagonal shift where slack edges make the stiffness
    /// singular. Where the line search cuts its steps short or 30 do not do, since many edges go
    /// slack or taut on the way, a primal-dual interior-point method first brings the net near its
    /// form.
    /// @param unstressed_lengths l_0 of all edges (m), positive [m]
    /// @param start where to begin (3 x n); supports are taken from the net, and a node farther
    /// from
    ///   these than tenfold the net's length in cable is brought that near [m]
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
