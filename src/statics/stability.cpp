// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/stability.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "taut/statics/energy.hpp"

namespace taut {

double smallest_stiffness(const CableNet& net,
                          const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                          const Eigen::Ref<const Points>& form) {
    constexpr double accuracy = 1e-3;
    constexpr double negligible = 1e-12;
    const Eigen::SparseMatrix<double> matrix = tangent_stiffness(net, unstressed_lengths, form);
    const Eigen::VectorXd diagonal = matrix.diagonal();
    double largest = 0.0;
    for (Eigen::Index k = 0; k < matrix.outerSize(); ++k) {
        largest = std::max(largest, matrix.col(k).cwiseAbs().sum());
    }
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor;
    factor.analyzePattern(matrix);
    const auto exceeds = [&](double bound) {
        factor.setShift(-bound);
        factor.factorize(matrix);
        return factor.info() == Eigen::Success && (factor.vectorD().array() > 0.0).all();
    };
    // The size is found on a scale of logarithms.
    const double sign = exceeds(0.0) ? 1.0 : -1.0;
    double small = negligible * largest;
    if (sign > 0.0 ? !exceeds(small) : exceeds(-small)) {
        return 0.0;
    }
    double large = sign > 0.0 ? diagonal.minCoeff() : largest;
    while (large > (1.0 + accuracy) * small) {
        const double middle = std::sqrt(small * large);
        (exceeds(sign * middle) == (sign > 0.0) ? small : large) = middle;
    }
    return sign * std::sqrt(small * large);
}

}  // namespace taut
