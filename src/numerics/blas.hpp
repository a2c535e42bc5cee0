// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// The routines of BLAS and LAPACK that taut calls, by the names that every implementation has:
/// matrices by columns, 32 bit indices. Fortran compilers append the length of each text argument.
/// A library that ignores these lengths is not disturbed by them.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
void dgemm_(const char* transpose_a, const char* transpose_b, const int* m, const int* n,
            const int* k, const double* alpha, const double* a, const int* lda, const double* b,
            const int* ldb, const double* beta, double* c, const int* ldc, std::size_t,
            std::size_t);
void dgemv_(const char* transpose, const int* m, const int* n, const double* alpha, const double* a,
            const int* lda, const double* x, const int* incx, const double* beta, double* y,
            const int* incy, std::size_t);
void dtrmm_(const char* side, const char* triangle, const char* transpose, const char* diagonal,
            const int* m, const int* n, const double* alpha, const double* a, const int* lda,
            double* b, const int* ldb, std::size_t, std::size_t, std::size_t, std::size_t);
void dtrsm_(const char* side, const char* triangle, const char* transpose, const char* diagonal,
            const int* m, const int* n, const double* alpha, const double* a, const int* lda,
            double* b, const int* ldb, std::size_t, std::size_t, std::size_t, std::size_t);
void dpotrf_(const char* triangle, const int* n, double* a, const int* lda, int* info, std::size_t);
void dpotrs_(const char* triangle, const int* n, const int* columns, const double* a,
             const int* lda, double* b, const int* ldb, int* info, std::size_t);
void dpotri_(const char* triangle, const int* n, double* a, const int* lda, int* info, std::size_t);
void dsyevd_(const char* job, const char* triangle, const int* n, double* a, const int* lda,
             double* values, double* work, const int* work_size, int* integer_work,
             const int* integer_work_size, int* info, std::size_t, std::size_t);
}
// NOLINTEND(readability-identifier-naming)
