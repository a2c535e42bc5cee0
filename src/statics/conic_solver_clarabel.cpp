// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <clarabel_c.h>

#include <stdexcept>

#include "statics/conic_solver.hpp"

namespace taut {
namespace {

/// Tight enough for forms accurate to a micrometre, and still attainable in double precision: the
/// solver's residuals stop falling slightly below 1e-9. The program's numbers are of order one.
constexpr double gap_tolerance = 1e-11;
constexpr double feasibility_tolerance = 1e-9;
constexpr double reduced_gap_tolerance = 1e-7;
constexpr double reduced_feasibility_tolerance = 1e-7;

clarabel_c_matrix view(const Eigen::SparseMatrix<double>& matrix) {
    return {.rows = static_cast<int32_t>(matrix.rows()),
            .columns = static_cast<int32_t>(matrix.cols()),
            .column_starts = matrix.outerIndexPtr(),
            .row_indices = matrix.innerIndexPtr(),
            .values = matrix.valuePtr()};
}

ConeStatus status_of(int code) {
    switch (code) {
        case CLARABEL_C_SOLVED:
            return ConeStatus::solved;
        case CLARABEL_C_ALMOST_SOLVED:
            return ConeStatus::almost_solved;
        case CLARABEL_C_INFEASIBLE:
            return ConeStatus::infeasible;
        case CLARABEL_C_ITERATION_LIMIT:
            return ConeStatus::iteration_limit;
        default:
            return ConeStatus::numerical_error;
    }
}

}  // namespace

bool cone_solver_available() {
    return true;
}

ConicSolution solve_conic(const ConicProgram& program, int max_iterations) {
    std::vector<clarabel_c_cone> cones;
    cones.reserve(program.cones.size());
    for (const Cone& cone : program.cones) {
        const bool nonnegative = cone.kind == Cone::Kind::nonnegative;
        cones.push_back({.kind = nonnegative ? CLARABEL_C_NONNEGATIVE : CLARABEL_C_SECOND_ORDER,
                         .dimension = cone.dimension});
    }
    const clarabel_c_program view_of_program{.p = view(program.P),
                                             .q = program.q.data(),
                                             .a = view(program.A),
                                             .b = program.b.data(),
                                             .cones = cones.data(),
                                             .cone_count = static_cast<int32_t>(cones.size())};
    const clarabel_c_settings settings{
        .max_iterations = max_iterations,
        .gap_tolerance = gap_tolerance,
        .feasibility_tolerance = feasibility_tolerance,
        .reduced_gap_tolerance = reduced_gap_tolerance,
        .reduced_feasibility_tolerance = reduced_feasibility_tolerance};
    ConicSolution solution{.x = Eigen::VectorXd(program.q.size()),
                           .z = Eigen::VectorXd(program.b.size())};
    const clarabel_c_outcome outcome =
        clarabel_c_solve(&view_of_program, &settings, solution.x.data(), solution.z.data());
    if (outcome.status == CLARABEL_C_REFUSED) {
        throw std::logic_error("the conic solver refused the program");
    }
    solution.status = status_of(outcome.status);
    solution.iterations = outcome.iterations;
    solution.primal_objective = outcome.primal_objective;
    solution.dual_objective = outcome.dual_objective;
    solution.primal_residual = outcome.primal_residual;
    solution.dual_residual = outcome.dual_residual;
    return solution;
}

}  // namespace taut
