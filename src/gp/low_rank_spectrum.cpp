// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/low_rank_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gp/correlation_product.hpp"
#include "numerics/dense.hpp"
#include "numerics/memory_budget.hpp"
#include "numerics/random_numbers.hpp"
#include "numerics/small_dense.hpp"
#include "taut/gp/kernel.hpp"

namespace taut::gp {
namespace {

/// Rounding error of an eigenvalue of R, whose largest is at most n.
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
    const double cutoff = least_noise_ratio(Y.rows());
    // With S'Y = L L' it is B B', B = Y L'^-1, whose directions follow from those of B'B.
    const Eigen::MatrixXd B = Cholesky(std::move(core)).solve_transposed_right(std::move(Y));
    const SymmetricEigen eigen = symmetric_eigen(gram(B));
    const Eigen::Index kept = (eigen.values.array() > cutoff).count();
    const Eigen::VectorXd squares = eigen.values.tail(kept);
    // Directions of small eigenvalues lose digits to the largest. So all are made orthonormal anew,
    // the largest first, so that these stay as they are.
    const Eigen::VectorXd scales = squares.cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd Q =
        product(B, (eigen.vectors.rightCols(kept) * scales.asDiagonal()).rowwise().reverse());
    Q = Cholesky(gram(Q)).solve_transposed_right(std::move(Q));
    return {.inverse_length_scale = inverse_length_scale,
            .eigenvalues = squares.array() - rounding,
            .eigenvectors = Q.rowwise().reverse()};
}

/// The largest eigenvalue of what a spectrum leaves out of R, (left-out): the largest in a block
/// Krylov space, a bound from below, raised by a half. Three rounds amount to a Chebyshev
/// polynomial, which finds a single one even where hundreds are half as large.
double largest_left_out(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                        const KernelSpectrum& spectrum, const Progress& progress) {
    constexpr Eigen::Index vectors = 64;
    constexpr int rounds = 3;
    constexpr double safety = 1.5;
    const Eigen::MatrixXd& Q = spectrum.eigenvectors;
    const Eigen::Index n = Q.rows();
    RandomNumbers random(1, 0);
    Eigen::MatrixXd next = Eigen::MatrixXd::NullaryExpr(n, std::min(vectors, n / rounds),
                                                        [&] { return random.normal(); });
    Eigen::MatrixXd space(n, 0);
    Eigen::MatrixXd image(n, 0);
    for (int k = 0; k < rounds; ++k) {
        for (int twice = 0; twice < 2; ++twice) {  // once loses digits
            next -= product(space, transposed_product(space, next));
            next = orthonormal_basis(next);
        }
        const Eigen::Index width = space.cols() + next.cols();
        space.conservativeResize(Eigen::NoChange, width);
        space.rightCols(next.cols()) = next;
        next = correlation_product(inputs, spectrum.inverse_length_scale, next, progress) -
               product(Q, spectrum.eigenvalues.asDiagonal() * transposed_product(Q, next));
        image.conservativeResize(Eigen::NoChange, width);
        image.rightCols(next.cols()) = next;
    }
    const double largest = symmetric_eigen(transposed_product(space, image)).values.maxCoeff();
    return safety * std::max({largest, spectrum.tail_mean, rounding_of(Q.rows())});
}

}  // namespace

double least_noise_ratio(Eigen::Index n) {
    return 2.0 * rounding_of(n);
}

std::vector<Eigen::Index> spread_part(Eigen::Index n, Eigen::Index most) {
    std::vector<Eigen::Index> result(std::min(n, most));
    const Eigen::Index pieces = std::ssize(result);
    RandomNumbers random(1, 1);
    for (Eigen::Index k = 0; k < pieces; ++k) {
        const Eigen::Index first = k * n / pieces;
        const Eigen::Index length = (k + 1) * n / pieces - first;
        // A fixed stride could meet inputs that differ from those between.
        result[static_cast<size_t>(k)] =
            first + static_cast<Eigen::Index>(random.uniform() * static_cast<double>(length));
    }
    return result;
}

KernelSpectrum low_rank_spectrum(const Eigen::Ref<const Eigen::MatrixXd>& inputs,
                                 double inverse_length_scale, Eigen::Index rank,
                                 const Progress& progress) {
    const Eigen::Index n = inputs.cols();
    const double rounding = rounding_of(n);
    const std::vector<Eigen::Index> part = spread_part(n, rank);
    const MemoryCharge at_work = charge_numbers(4.0 * static_cast<double>(n * rank));
    // First S are columns of I: products with them are columns of R, and cost next to nothing.
    Eigen::MatrixXd columns =
        correlation(squared_distances(inputs, inputs(Eigen::all, part)), inverse_length_scale);
    for (size_t k = 0; k < part.size(); ++k) {
        columns(part[k], static_cast<Eigen::Index>(k)) += rounding;
    }
    Eigen::MatrixXd core = columns(part, Eigen::all);
    progress.throw_if_stopped();
    KernelSpectrum spectrum = nystroem(inverse_length_scale, std::move(columns), std::move(core));
    // Then the directions that these show: one round of subspace iteration.
    const Eigen::MatrixXd S = std::move(spectrum.eigenvectors);
    Eigen::MatrixXd Y =
        correlation_product(inputs, inverse_length_scale, S, progress) + rounding * S;
    core = transposed_product(S, Y);
    progress.throw_if_stopped();
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
