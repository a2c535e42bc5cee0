// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace taut::test {

/// df/dx of a function f that gives a vector (size n) of a vector x (size m): n x m, by central
/// differences of fourth order, (8 (f(x+h) - f(x-h)) - (f(x+2h) - f(x-2h))) / 12h.
template <typename Function>
Eigen::MatrixXd finite_differences(const Function& f, const Eigen::VectorXd& x, double step) {
    Eigen::MatrixXd derivative;
    Eigen::VectorXd shifted = x;
    const auto at = [&](Eigen::Index k, double shift) -> Eigen::VectorXd {
        shifted(k) = x(k) + shift;
        const Eigen::VectorXd value = f(shifted);
        shifted(k) = x(k);
        return value;
    };
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        const Eigen::VectorXd column =
            (8.0 * (at(k, step) - at(k, -step)) - (at(k, 2.0 * step) - at(k, -2.0 * step))) /
            (12.0 * step);
        derivative.conservativeResize(column.size(), x.size());
        derivative.col(k) = column;
    }
    return derivative;
}

}  // namespace taut::test
