// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/low_rank_spectrum.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gp/correlation_product.hpp"
#include "numerics/dense.hpp"
#include "numerics/random_numbers.hpp"
#include "taut/gp/kernel.hpp"

namespace taut::gp {
namespace {

/// What an eigenvalue of R, whose largest is at most n, is rounded by.
double rounding_of(Eigen::Index n) {
    const auto size = static_cast<double>(n);
    return std::sqrt(size) * size * std::numeric_limits<double>::epsilon();
}

/// Y (S'Y)^-1 Y' = Q diag(d) Q' of Y = R S, (nystroem). R is shifted by its rounding, so that S'Y
/// has a factor (J. Tropp et al., Fixed-rank approximation of a positive-semidefinite matrix from
/// streaming data, 2017, algorithm 3); the eigenvalues are shifted back, and those that do not
/// exceed it are left out.
/// @param Y (R + rounding I) S (n x r)
/// @param core S'Y, of which the lower triangle is read
KernelSpectrum nystroem(double inverse_length_scale, Eigen::MatrixXd Y, Eigen::MatrixXd core) {
    const double rounding = rounding_of(Y.rows());
    // With S'Y = L L' it is B B', B = Y L'^-1, whose directions follow from those of B'B.
    const Eigen::MatrixXd B = Cholesky(std::move(core)).solve_transposed_right(std::move(Y));
    const SymmetricEigen eigen = symmetric_eigen(gram(B));
    const Eigen::Index kept = (eigen.values.array() > 2.0 * rounding).count();
    const Eigen::VectorXd squares = eigen.values.tail(kept);
    // Directions of small eigenvalues lose the digits of the largest: all are made orthonormal
    // anew, the largest first, so that it is these that stay.
    const Eigen::VectorXd scales = squares.cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd Q =
        product(B, (eigen.vectors.rightCols(kept) * scales.asDiagonal()).rowwise().reverse());
    Q = Cholesky(gram(Q)).solve_transposed_right(std::move(Q));
    return {.inverse_length_scale = inverse_length_scale,
            .eigenvalues = squares.array() - rounding,
            .eigenvectors = Q.rowwise().reverse()};
}

/// The largest eigenvalue of what a spectrum leaves out of R, (left-out): block power iteration,
/// from below, then raised by a half. Where the largest stand alone three rounds find them to a few
/// per cent; where many are alike, as they mostly are, any vector shows them.
double largest_left_out(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                        const KernelSpectrum& spectrum, const Progress& progress) {
    constexpr Eigen::Index vectors = 8;
    constexpr int rounds = 3;
    constexpr double safety = 1.5;
    const Eigen::MatrixXd& Q = spectrum.eigenvectors;
    RandomNumbers random(1, 0);
    Eigen::MatrixXd V = Eigen::MatrixXd::NullaryExpr(Q.rows(), std::min(vectors, Q.rows()),
                                                     [&] { return random.normal(); });
    double largest = 0.0;
    for (int k = 0; k < rounds; ++k) {
        V = Eigen::HouseholderQR<Eigen::MatrixXd>(V).householderQ() *
            Eigen::MatrixXd::Identity(V.rows(), V.cols());
        Eigen::MatrixXd next =
            correlation_product(inputs, spectrum.inverse_length_scale, V, progress);
        next -= product(Q, spectrum.eigenvalues.asDiagonal() * transposed_product(Q, V));
        largest = symmetric_eigen(transposed_product(V, next)).values.maxCoeff();
        V = std::move(next);
    }
    return safety * std::max({largest, spectrum.tail_mean, rounding_of(Q.rows())});
}

}  // namespace

std::vector<Eigen::Index> evenly_spread(Eigen::Index n, Eigen::Index most) {
    std::vector<Eigen::Index> result(std::min(n, most));
    for (size_t k = 0; k < result.size(); ++k) {
        result[k] = static_cast<Eigen::Index>(k) * n / std::ssize(result);
    }
    return result;
}

KernelSpectrum low_rank_spectrum(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                 double inverse_length_scale, Eigen::Index rank,
                                 const Progress& progress) {
    const Eigen::Index n = inputs.cols();
    const double rounding = rounding_of(n);
    const std::vector<Eigen::Index> part = evenly_spread(n, rank);
    // First S are columns of I: products with them are columns of R, and cost next to nothing.
    Eigen::MatrixXd columns =
        correlation(squared_distances(inputs, inputs(Eigen::all, part)), inverse_length_scale);
    for (size_t k = 0; k < part.size(); ++k) {
        columns(part[k], static_cast<Eigen::Index>(k)) += rounding;
    }
    Eigen::MatrixXd core = columns(part, Eigen::all);
    KernelSpectrum spectrum = nystroem(inverse_length_scale, std::move(columns), std::move(core));
    // Then the directions that these show: one round of subspace iteration.
    const Eigen::MatrixXd S = std::move(spectrum.eigenvectors);
    Eigen::MatrixXd Y =
        correlation_product(inputs, inverse_length_scale, S, progress) + rounding * S;
    core = transposed_product(S, Y);
    spectrum = nystroem(inverse_length_scale, std::move(Y), std::move(core));
    if (!spectrum.is_whole()) {
        const auto left_out = static_cast<double>(n - spectrum.eigenvalues.size());
        // The trace of R is n.
        spectrum.tail_mean =
            std::max(0.0, static_cast<double>(n) - spectrum.eigenvalues.sum()) / left_out;
        spectrum.tail_largest = largest_left_out(inputs, spectrum, progress);
    }
    return spectrum;
}

}  // namespace taut::gp
