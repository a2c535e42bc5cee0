// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"

/// @file
/// The equilibrium as the paper computes it: the second-order cone program of eq. SOCP, solved by
/// the interior point method of Clarabel. With loads p and w = sqrt(EA/l_0) times the extension:
///
///     minimise    v/2 - sum_s p_s . r_s          (ConeForm::paper)
///                 w'w/2 - sum_s p_s . r_s        (ConeForm::quadratic)
///     subject to  sqrt(EA/l_0) (|r_s - r_t| - l_0) <= w_(s,t),   w >= 0,
///                 |(2w, 1 - v)| <= 1 + v         (ConeForm::paper)
///
/// The quadratic form is the default: it takes two thirds of the iterations and half of the time
/// (built-in net, +-5 mm: 12 and 0.05 s, against 17 and 0.1 s), and its form agrees with Newton's
/// to some 1e-8 m where the paper's is off by up to 1e-6 m, since the large cone couples all edges
/// and loses digits near its boundary.
///
/// An edge with a piecewise linear tension law has a w for each straight part, with the part's own
/// stiffness and start T_0 (T_0 times its extension is added to the objective), no larger than its
/// width, and the sum of all in place of w / sqrt(EA/l_0).
///
/// Both have the equilibrium as their optimum and its energy V as their value: at the optimum v =
/// w'w, and edges that are not taut have w = 0. EquilibriumSolver finds the same faster; this one
/// shares no code with it, needs no start, and so is its check.
namespace taut {

/// How the cone program is written.
enum class ConeForm {
    quadratic,  ///< one small cone an edge, the energy as a quadratic objective
    paper,      ///< a linear objective, and one more cone that holds all of w
};

/// "quadratic", "paper".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string_view to_string(ConeForm form);

/// How to solve it, and when to stop.
struct ConeProgramSettings {
    ConeForm form = ConeForm::quadratic;  ///< which of both programs is solved
    int max_iterations = 100;             ///< of the interior point method
};

/// How the conic solver ended.
enum class ConeStatus {
    solved,         ///< to the full tolerances
    almost_solved,  ///< to reduced ones
    infeasible,     ///< never so in exact numbers: every net has an equilibrium
    iteration_limit,
    numerical_error,  ///< or no more progress
};

/// "solved", "almost solved", "infeasible", "iteration limit", "numerical error".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string_view to_string(ConeStatus status);

/// What the conic solver found, back in SI units.
struct ConeSolution {
    Points form;         ///< 3 x n, supports included [m]
    Points edge_forces;  ///< 3 x m, f of statics/duality.hpp, from the dual variables [N]
    ConeStatus status = ConeStatus::numerical_error;  ///< how the solver ended
    int iterations = 0;                               ///< of the interior point method
    double primal_objective = 0.0;                    ///< [J]
    double dual_objective = 0.0;                      ///< [J]
    double primal_residual = 0.0;  ///< of the constraints, relative, as the solver tells it
    double dual_residual = 0.0;    ///< of the balance of forces, likewise

    /// The form is an equilibrium to the full or the reduced tolerances.
    [[nodiscard]] bool solved() const {
        return status == ConeStatus::solved || status == ConeStatus::almost_solved;
    }
};

/// Whether this taut was built with the conic solver.
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT bool cone_solver_available();

/// Solves the cone program. Inside, lengths are in mean unstressed lengths, from the net's nodes;
/// forces in mean tensions at the net's nodes (mean loads, or axial stiffnesses, where all edges
/// are slack there): nets behave alike whatever their size.
/// @param unstressed_lengths l_0 of all edges (m) [m]
/// @throws std::invalid_argument for wrong sizes, a length that is not positive and finite, and
///   where this taut was built without the conic solver
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT ConeSolution
solve_cone_program(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                   ConeProgramSettings settings = {});

}  // namespace taut
