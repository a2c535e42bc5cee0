// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

//! The Rust side of `include/clarabel_c.h`, which says what everything means.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus,
    SupportedConeT,
};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::slice::{from_raw_parts, from_raw_parts_mut};

#[repr(C)]
pub struct Matrix {
    rows: i32,
    columns: i32,
    column_starts: *const i32,
    row_indices: *const i32,
    values: *const f64,
}

#[repr(C)]
pub struct Cone {
    kind: i32,
    dimension: i32,
}

#[repr(C)]
pub struct Program {
    p: Matrix,
    q: *const f64,
    a: Matrix,
    b: *const f64,
    cones: *const Cone,
    cone_count: i32,
}

#[repr(C)]
pub struct Settings {
    max_iterations: i32,
    gap_tolerance: f64,
    feasibility_tolerance: f64,
    reduced_gap_tolerance: f64,
    reduced_feasibility_tolerance: f64,
}

#[repr(C)]
pub struct Outcome {
    status: i32,
    iterations: i32,
    primal_objective: f64,
    dual_objective: f64,
    primal_residual: f64,
    dual_residual: f64,
}

const SOLVED: i32 = 0;
const ALMOST_SOLVED: i32 = 1;
const INFEASIBLE: i32 = 2;
const ITERATION_LIMIT: i32 = 3;
const NUMERICAL_ERROR: i32 = 4;
const REFUSED: i32 = 5;

fn status_code(status: SolverStatus) -> i32 {
    use SolverStatus::*;
    match status {
        Solved => SOLVED,
        AlmostSolved => ALMOST_SOLVED,
        PrimalInfeasible | DualInfeasible | AlmostPrimalInfeasible | AlmostDualInfeasible => {
            INFEASIBLE
        }
        MaxIterations | MaxTime => ITERATION_LIMIT,
        _ => NUMERICAL_ERROR,
    }
}

/// A null pointer is an empty array: C and C++ may hand over either.
unsafe fn slice<'a, T>(data: *const T, length: i32) -> &'a [T] {
    if length <= 0 {
        &[]
    } else {
        from_raw_parts(data, length as usize)
    }
}

fn indices(values: &[i32]) -> Vec<usize> {
    values.iter().map(|&value| value as usize).collect()
}

unsafe fn matrix(m: &Matrix) -> CscMatrix<f64> {
    let starts = slice(m.column_starts, m.columns + 1);
    let count = starts.last().copied().unwrap_or(0);
    CscMatrix::new(
        m.rows as usize,
        m.columns as usize,
        indices(starts),
        indices(slice(m.row_indices, count)),
        slice(m.values, count).to_vec(),
    )
}

fn cone(cone: &Cone) -> Option<SupportedConeT<f64>> {
    let dimension = usize::try_from(cone.dimension).ok()?;
    match cone.kind {
        0 => Some(NonnegativeConeT(dimension)),
        1 => Some(SecondOrderConeT(dimension)),
        _ => None,
    }
}

/// None where the program is none: a cone of an unknown kind, sizes that do not match.
unsafe fn solve(
    program: &Program,
    settings: &Settings,
    x: *mut f64,
    z: *mut f64,
) -> Option<Outcome> {
    let settings = DefaultSettings {
        max_iter: settings.max_iterations.max(0) as u32,
        verbose: false,
        max_threads: 1,
        tol_gap_abs: settings.gap_tolerance,
        tol_gap_rel: settings.gap_tolerance,
        tol_feas: settings.feasibility_tolerance,
        reduced_tol_gap_abs: settings.reduced_gap_tolerance,
        reduced_tol_gap_rel: settings.reduced_gap_tolerance,
        reduced_tol_feas: settings.reduced_feasibility_tolerance,
        // Constraints are never dropped: the caller knows z by their order.
        presolve_enable: false,
        ..DefaultSettings::default()
    };
    let cones: Option<Vec<_>> = slice(program.cones, program.cone_count).iter().map(cone).collect();
    let mut solver = DefaultSolver::new(
        &matrix(&program.p),
        slice(program.q, program.p.columns),
        &matrix(&program.a),
        slice(program.b, program.a.rows),
        &cones?,
        settings,
    )
    .ok()?;
    solver.solve();

    let solution = &solver.solution;
    from_raw_parts_mut(x, solution.x.len()).copy_from_slice(&solution.x);
    from_raw_parts_mut(z, solution.z.len()).copy_from_slice(&solution.z);
    Some(Outcome {
        status: status_code(solution.status),
        iterations: solution.iterations as i32,
        primal_objective: solution.obj_val,
        dual_objective: solution.obj_val_dual,
        primal_residual: solution.r_prim,
        dual_residual: solution.r_dual,
    })
}

/// # Safety
/// Pointers and sizes are as `clarabel_c.h` says; `x` and `z` have room for all variables.
#[no_mangle]
pub unsafe extern "C" fn clarabel_c_solve(
    program: *const Program,
    settings: *const Settings,
    x: *mut f64,
    z: *mut f64,
) -> Outcome {
    // No panic may cross into C.
    let attempt = catch_unwind(AssertUnwindSafe(|| solve(&*program, &*settings, x, z)));
    attempt.ok().flatten().unwrap_or(Outcome {
        status: REFUSED,
        iterations: 0,
        primal_objective: f64::NAN,
        dual_objective: f64::NAN,
        primal_residual: f64::NAN,
        dual_residual: f64::NAN,
    })
}
