// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/identifiability.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>
#include <utility>

#include "statics/self_stress.hpp"
#include "taut/statics/equilibrium_matrix.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// An edge's part in a free self-stress that counts as none.
constexpr double negligible_freedom = 1e-6;

/// The largest eigenvalue of a symmetric positive semidefinite matrix, by Lanczos' method without
/// reorthogonalisation: that repeats eigenvalues, but does not spoil them.
/// @param apply the matrix, times a vector of this size
double largest_eigenvalue(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                          Eigen::Index size) {
    constexpr int most_steps = 100;
    constexpr double tolerance = 1e-8;
    // Numbers without a pattern that a net could share.
    Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(
        size, [](Eigen::Index i) { return std::sin(12.9898 * static_cast<double>(i + 1)); });
    q.normalize();
    Eigen::VectorXd previous = Eigen::VectorXd::Zero(size);
    Eigen::VectorXd diagonal(most_steps);
    Eigen::VectorXd beside(most_steps);
    double value = 0.0;
    for (int k = 0; k < most_steps; ++k) {
        Eigen::VectorXd next = apply(q);
        diagonal(k) = q.dot(next);
        next -= diagonal(k) * q + (k > 0 ? beside(k - 1) : 0.0) * previous;
        beside(k) = next.norm();
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
        solver.computeFromTridiagonal(diagonal.head(k + 1), beside.head(k), Eigen::EigenvaluesOnly);
        const double before = value;
        value = solver.eigenvalues()(k);
        if (value - before <= tolerance * value || beside(k) <= tolerance * value) {
            break;
        }
        previous = std::exchange(q, next / beside(k));
    }
    return value;
}

}  // namespace

Identifiability identifiability(const CableNet& net,
                                const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                const Eigen::Ref<const Points>& form) {
    const Eigen::VectorXd tension = tensions_of(net, unstressed_lengths, form);
    const Eigen::VectorXd length = edge_lengths(net, form);
    Identifiability result;
    std::vector<int> taut_edges;
    for (const int e : net.interior_edges()) {
        (tension(e) > 0.0 || net.is_strut(e) ? taut_edges : result.slack).push_back(e);
    }
    const Eigen::SparseMatrix<double> A = equilibrium_matrix(net, form, taut_edges);
    const SelfStress self_stress(A);
    result.free_self_stress = self_stress.count();

    const Eigen::VectorXd freedom = self_stress.basis().rowwise().norm();
    Eigen::VectorXd kept(A.cols());  // K: EA l of a determined edge, else 0
    for (size_t i = 0; i < taut_edges.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const bool is_determined = freedom(k) <= negligible_freedom;
        kept(k) =
            is_determined ? net.axial_stiffness()(taut_edges[i]) * length(taut_edges[i]) : 0.0;
        (is_determined ? result.determined : result.undetermined).push_back(taut_edges[i]);
    }
    if (result.determined.empty()) {
        return result;
    }
    // Both as square roots of eigenvalues, of K A'A K and of K^+ (A'A)^+ K^+: the determined part
    // of any solution of A K x = h is K^+ A^+ h, since no self-stress has a part in it.
    const Eigen::VectorXd inverse =
        kept.unaryExpr([](double k) { return k > 0.0 ? 1.0 / k : 0.0; });
    result.largest_singular_value = std::sqrt(largest_eigenvalue(
        [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return kept.cwiseProduct(A.transpose() * (A * kept.cwiseProduct(x)));
        },
        A.cols()));
    result.smallest_singular_value =
        1.0 / std::sqrt(largest_eigenvalue(
                  [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
                      return inverse.cwiseProduct(self_stress.solve(inverse.cwiseProduct(x)));
                  },
                  A.cols()));
    return result;
}

}  // namespace taut
