// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "taut/export/adjustment.hpp"
#include "taut/net/cable_net.hpp"

/// @file
/// The equilibrium as the paper computes it: the second-order cone program of eq. SOCP, solved by
/// Clarabel's interior-point method. With loads p and w = sqrt(EA/l_0) times the extension:
///
///     minimise    v/2 - sum_s p_s . r_s          (ConeForm::paper)
///                 w'w/2 - sum_s p_s . r_s        (ConeForm::quadratic)
///     subject to  sqrt(EA/l_0) (|r_s - r_t| - l_0) <= w_(s,t),   w >= 0,
///                 |(2w, 1 - v)| <= 1 + v         (ConeForm::paper)
///
/// The quadratic form is the default. It needs two thirds of the iterations and half of the time
/// (built-in net, +-5 mm: 12 and 0.05 s, against 17 and 0.1 s). Its result agrees with Newton's to
/// some 1e-8 m; that of the paper's form only to 1e-6 m, since the large cone couples all edges and
/// loses digits near its boundary.
///
/// An edge with a piecewise linear tension law has one w for each straight part, with the stiffness
/// of the part, bounded by its width. T_0, the tension at the start of a part, times its extension
/// is added to the objective. The sum over the parts replaces w / sqrt(EA/l_0).
///
/// The energy of an elastic support, 1/2 (r_b - r_0)' K (r_b - r_0), is added to the objective of
/// either form.
///
/// The optimum of both is the equilibrium, and the optimal value its energy V: there v = w'w, and
/// slack edges have w = 0. EquilibriumSolver finds the same faster. This solver shares no code with
/// it and needs no start, so it serves as a check.
namespace taut {

/// Form of the objective.
enum class ConeForm {
    quadratic,  ///< quadratic objective, one small cone an edge
    paper,      ///< linear objective, and one more cone that contains all of w
};

/// "quadratic", "paper".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string_view to_string(ConeForm form);

/// Settings of solve_cone_program().
struct ConeProgramSettings {
    ConeForm form = ConeForm::quadratic;  ///< of the energy
    int max_iterations = 100;             ///< of the interior-point method
};

/// How the conic solver ended.
enum class ConeStatus {
    solved,         ///< to the full tolerances
    almost_solved,  ///< to reduced ones
    infeasible,     ///< by rounding errors only: every net has an equilibrium
    iteration_limit,
    numerical_error,  ///< or no further progress
};

/// "solved", "almost solved", "infeasible", "iteration limit", "numerical error".
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT std::string_view to_string(ConeStatus status);

/// Result of the conic solver, in SI units.
struct ConeSolution {
    Points form;         ///< 3 x n, supports included [m]
    Points edge_forces;  ///< 3 x m, f of statics/duality.hpp, from the dual variables [N]
    ConeStatus status = ConeStatus::numerical_error;  ///< how the solver ended
    int iterations = 0;                               ///< of the interior-point method
    double primal_objective = 0.0;                    ///< [J]
    double dual_objective = 0.0;                      ///< [J]
    double primal_residual = 0.0;  ///< of the constraints, relative, as the solver reports it
    double dual_residual = 0.0;    ///< of the balance of forces, likewise

    /// Whether the form is an equilibrium, to the full or the reduced tolerances.
    [[nodiscard]] bool solved() const {
        return status == ConeStatus::solved || status == ConeStatus::almost_solved;
    }
};

/// Whether taut was built with the conic solver.
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT bool cone_solver_available();

/// Solves the cone program. Internally the unit of length is the mean unstressed length. The unit
/// of force is the mean tension at the net's nodes; if all edges are slack there, the mean load or
/// the mean axial stiffness. So nets of any size behave alike.
/// @param unstressed_lengths l_0 of all edges (m) [m]
/// @throws std::invalid_argument for a net with struts or runs that slide, wrong sizes, a length
///   that is not positive and finite, and if taut was built without the conic solver
[[nodiscard]] TAUT_ADJUSTMENT_EXPORT ConeSolution
solve_cone_program(const CableNet& net, const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                   ConeProgramSettings settings = {});

}  // namespace taut
