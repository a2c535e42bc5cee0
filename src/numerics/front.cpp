// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/front.hpp"

#include <Eigen/LU>

#include "numerics/blas.hpp"

namespace taut {
namespace {

/// C = beta C - A B', the lower triangle; blocks on the diagonal are computed whole, since larger
/// products are faster.
void subtract_from_triangle(const ConstMatrixPart& A, const ConstMatrixPart& B, double beta,
                            MatrixPart C) {
    constexpr Eigen::Index smallest = 32;
    const Eigen::Index n = C.cols();
    if (n <= smallest) {
        multiply(-1.0, A, Op::as_it_is, B, Op::transposed, beta, C);
        return;
    }
    const Eigen::Index half = n / 2;
    const Eigen::Index rest = n - half;
    subtract_from_triangle(A.topRows(half), B.topRows(half), beta, C.topLeftCorner(half, half));
    multiply(-1.0, A.bottomRows(rest), Op::as_it_is, B.topRows(half), Op::transposed, beta,
             C.bottomLeftCorner(rest, half));
    subtract_from_triangle(A.bottomRows(rest), B.bottomRows(rest), beta,
                           C.bottomRightCorner(rest, rest));
}

/// The same of a matrix with further rows below its triangle.
void subtract_from_columns(const ConstMatrixPart& A, const ConstMatrixPart& B, double beta,
                           MatrixPart C) {
    const Eigen::Index n = C.cols();
    subtract_from_triangle(A.topRows(n), B, beta, C.topRows(n));
    if (C.rows() > n) {
        multiply(-1.0, A.bottomRows(A.rows() - n), Op::as_it_is, B, Op::transposed, beta,
                 C.bottomRows(C.rows() - n));
    }
}

/// The inverse of a symmetric matrix in place of its lower triangle: both triangles.
bool invert(MatrixPart A) {
    const Eigen::MatrixXd whole = A.selfadjointView<Eigen::Lower>();
    A = whole.partialPivLu().inverse();
    return A.allFinite();
}

}  // namespace

bool eliminate_pivots(Definiteness definiteness, const std::vector<int>& panels,
                      FrontMatrix& pivots, FrontMatrix& update, double* scratch, Parts parts) {
    const bool is_definite = definiteness == Definiteness::positive_definite;
    const Eigen::Index size = pivots.rows();
    const Eigen::Index p = pivots.cols();
    FrontMatrix& L = pivots;
    FrontMatrix F(is_definite ? pivots.data() : scratch, size, p);  // L D
    for (size_t k = 0; k + 1 < panels.size(); ++k) {
        const Eigen::Index begin = panels[k];
        const Eigen::Index end = panels[k + 1];
        const Eigen::Index width = end - begin;
        const auto pivot = L.block(begin, begin, width, width);
        if (!(is_definite ? take_root(pivot) : invert(pivot))) {
            return false;
        }
        by_parts(parts, end, size, [&](Eigen::Index from, Eigen::Index rows) {
            const auto below = L.block(from, begin, rows, width);
            if (is_definite) {
                divide_by_transposed(pivot, below);
            } else {
                F.block(from, begin, rows, width) = below;
                multiply(1.0, F.block(from, begin, rows, width), Op::as_it_is, pivot, Op::as_it_is,
                         0.0, below);
            }
        });
        // Update the remaining panels now; the rows below follow once all panels are eliminated.
        by_parts(parts, end, p, [&](Eigen::Index from, Eigen::Index columns) {
            subtract_from_columns(L.block(from, begin, size - from, width),
                                  F.block(from, begin, columns, width), 1.0,
                                  L.block(from, from, size - from, columns));
        });
    }
    by_parts(parts, p, size, [&](Eigen::Index from, Eigen::Index columns) {
        subtract_from_columns(L.bottomRows(size - from), F.block(from, 0, columns, p), 0.0,
                              update.block(from - p, from - p, size - from, columns));
    });
    return true;
}

}  // namespace taut
