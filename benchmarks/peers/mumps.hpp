// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <utility>
#include <vector>

/// MUMPS (P. R. Amestoy, I. S. Duff, J.-Y. L'Excellent & J. Koster, A fully asynchronous
/// multifrontal solver using distributed dynamic scheduling, SIAM J. Matrix Anal. Appl. 23 (2001)
/// 15-41), its sequential form, for symmetric matrices that may be indefinite.
class Mumps {
public:
    /// Orders and analyses the pattern. Reads the lower triangle.
    explicit Mumps(const Eigen::SparseMatrix<double>& lower);
    ~Mumps();
    Mumps(const Mumps&) = delete;
    Mumps& operator=(const Mumps&) = delete;

    void factorize();
    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b);

    /// Entries of the inverse (P. R. Amestoy, I. S. Duff, J.-Y. L'Excellent, Y. Robert, F.-H. Rouet
    /// & B. Ucar, On computing inverse entries of a sparse matrix in an out-of-core environment,
    /// SIAM J. Sci. Comput. 34 (2012) A1975-A1999).
    /// @param rows of the wanted entries of each column, ascending
    /// @return entries, column by column
    [[nodiscard]] std::vector<double> inverse_entries(const std::vector<std::vector<int>>& rows);

private:
    struct Instance;
    void call(int job);
    std::unique_ptr<Instance> m_instance;
};
