/* SPDX-FileCopyrightText: 2026 The taut authors
 * SPDX-License-Identifier: MIT
 *
 * A small C interface to Clarabel, an interior point solver for conic programs with a quadratic
 * objective:
 *
 *   minimise  x'Px/2 + q'x   subject to  Ax + s = b,  s in K,
 *
 * where K is a product of nonnegative orthants and second-order cones { (t, u) : |u| <= t }. Its dual:
 *
 *   maximise  -x'Px/2 - b'z  subject to  Px + q + A'z = 0,  z in K.
 */
#ifndef CLARABEL_C_H
#define CLARABEL_C_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Compressed columns; row indices ascend within a column. */
typedef struct {
    int32_t rows;
    int32_t columns;
    const int32_t* column_starts; /* columns + 1 */
    const int32_t* row_indices;   /* column_starts[columns] */
    const double* values;         /* likewise */
} clarabel_c_matrix;

enum { CLARABEL_C_NONNEGATIVE = 0, CLARABEL_C_SECOND_ORDER = 1 };

typedef struct {
    int32_t kind;
    int32_t dimension;
} clarabel_c_cone;

typedef struct {
    clarabel_c_matrix p; /* upper triangle */
    const double* q;     /* p.columns */
    clarabel_c_matrix a;
    const double* b; /* a.rows */
    const clarabel_c_cone* cones;
    int32_t cone_count;
} clarabel_c_program;

typedef struct {
    int32_t max_iterations;
    double gap_tolerance;         /* absolute and relative */
    double feasibility_tolerance; /* relative to the size of the data */
    double reduced_gap_tolerance; /* of CLARABEL_C_ALMOST_SOLVED */
    double reduced_feasibility_tolerance;
} clarabel_c_settings;

enum {
    CLARABEL_C_SOLVED = 0,
    CLARABEL_C_ALMOST_SOLVED = 1, /* to the reduced tolerances */
    CLARABEL_C_INFEASIBLE = 2,    /* primal or dual */
    CLARABEL_C_ITERATION_LIMIT = 3,
    CLARABEL_C_NUMERICAL_ERROR = 4, /* or no more progress */
    CLARABEL_C_REFUSED = 5          /* sizes or values that make no program: nothing was written */
};

typedef struct {
    int32_t status;
    int32_t iterations;
    double primal_objective;
    double dual_objective;
    double primal_residual; /* relative */
    double dual_residual;
} clarabel_c_outcome;

/* Solves the program. Writes the primal variables x (p.columns) and the dual ones z (a.rows). */
clarabel_c_outcome clarabel_c_solve(const clarabel_c_program* program,
                                    const clarabel_c_settings* settings, double* x, double* z);

#ifdef __cplusplus
}
#endif

#endif
