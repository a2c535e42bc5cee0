// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>

#include "numerics/blas.hpp"

// By the names that every implementation has: matrices by columns, 32 bit indices. Fortran
// compilers append the length of each text argument. A library that ignores these lengths is not
// disturbed by them. NOLINTBEGIN(readability-identifier-naming)
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

namespace taut {
namespace {

int size_of(Eigen::Index index) {
    return static_cast<int>(index);
}

/// Of an empty matrix, too, it must be 1.
template <class Matrix>
int stride_of(const Matrix& matrix) {
    return std::max(1, size_of(matrix.outerStride()));
}

/// B = L^-1 B or B L^-T.
void divide(const char* side, const char* transpose, const ConstMatrixPart& L, MatrixPart& B) {
    const int rows = size_of(B.rows());
    const int columns = size_of(B.cols());
    const int stride_of_L = stride_of(L);
    const int stride = stride_of(B);
    const double one = 1.0;
    dtrsm_(side, "L", transpose, "N", &rows, &columns, &one, L.data(), &stride_of_L, B.data(),
           &stride, 1, 1, 1, 1);
}

}  // namespace

void multiply(double alpha, const ConstMatrixPart& A, Op op_A, const ConstMatrixPart& B, Op op_B,
              double beta, MatrixPart C) {
    const auto transpose_A = static_cast<char>(op_A);
    const auto transpose_B = static_cast<char>(op_B);
    const int rows = size_of(C.rows());
    const int columns = size_of(C.cols());
    const int inner = size_of(op_A == Op::as_it_is ? A.cols() : A.rows());
    const int stride_of_A = stride_of(A);
    const int stride_of_B = stride_of(B);
    const int stride_of_C = stride_of(C);
    dgemm_(&transpose_A, &transpose_B, &rows, &columns, &inner, &alpha, A.data(), &stride_of_A,
           B.data(), &stride_of_B, &beta, C.data(), &stride_of_C, 1, 1);
}

void add_product(double alpha, const ConstMatrixPart& A, Op op,
                 const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> y) {
    if (A.size() == 0) {
        return;
    }
    const auto transpose = static_cast<char>(op);
    const int rows = size_of(A.rows());
    const int columns = size_of(A.cols());
    const int stride = stride_of(A);
    const int one = 1;
    const double beta = 1.0;
    dgemv_(&transpose, &rows, &columns, &alpha, A.data(), &stride, x.data(), &one, &beta, y.data(),
           &one, 1);
}

void multiply_by_lower(double alpha, const ConstMatrixPart& L, MatrixPart B) {
    const int rows = size_of(B.rows());
    const int columns = size_of(B.cols());
    const int stride_of_L = stride_of(L);
    const int stride = stride_of(B);
    dtrmm_("L", "L", "N", "N", &rows, &columns, &alpha, L.data(), &stride_of_L, B.data(), &stride,
           1, 1, 1, 1);
}

void divide_by_lower(const ConstMatrixPart& L, MatrixPart B) {
    divide("L", "N", L, B);
}

void divide_by_transposed(const ConstMatrixPart& L, MatrixPart A) {
    divide("R", "T", L, A);
}

bool take_root(MatrixPart A) {
    const int n = size_of(A.rows());
    const int stride = stride_of(A);
    int info = 0;
    dpotrf_("L", &n, A.data(), &stride, &info, 1);
    return info == 0;
}

void divide_by_square(const ConstMatrixPart& L, MatrixPart B) {
    const int rows = size_of(B.rows());
    const int columns = size_of(B.cols());
    const int stride_of_L = stride_of(L);
    const int stride = stride_of(B);
    int info = 0;
    dpotrs_("L", &rows, &columns, L.data(), &stride_of_L, B.data(), &stride, &info, 1);
}

void invert_square(MatrixPart L) {
    const int n = size_of(L.rows());
    const int stride = stride_of(L);
    int info = 0;
    dpotri_("L", &n, L.data(), &stride, &info, 1);
}

bool diagonalise(Eigen::MatrixXd& matrix, Eigen::VectorXd& values) {
    const int n = size_of(matrix.rows());
    const int stride = stride_of(matrix);
    values.resize(n);
    int info = 0;
    double work_size = 0.0;
    int integer_work_size = 0;
    constexpr int ask = -1;
    dsyevd_("V", "L", &n, matrix.data(), &stride, values.data(), &work_size, &ask,
            &integer_work_size, &ask, &info, 1, 1);
    // Some versions return a size that was rounded on its way through a double.
    const int size = size_of(static_cast<Eigen::Index>(work_size) + 1);
    Eigen::VectorXd work(size);
    Eigen::VectorXi integer_work(std::max(1, integer_work_size));
    const int integer_size = size_of(integer_work.size());
    dsyevd_("V", "L", &n, matrix.data(), &stride, values.data(), work.data(), &size,
            integer_work.data(), &integer_size, &info, 1, 1);
    return info == 0;
}

}  // namespace taut
