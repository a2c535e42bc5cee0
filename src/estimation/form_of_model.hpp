// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>

#include "estimation/statics_model.hpp"

namespace taut {

/// Newton's method on the form of a model, and solutions with its stiffness H.
class FormOfModel {
public:
    explicit FormOfModel(const StaticsModel& model)
        : m_model(model), m_numbers(model.numbering()) {}

    /// Moves the free nodes into balance; false where that does not succeed.
    /// @param tolerance of places [m]
    [[nodiscard]] bool converge(Iterate& iterate, double tolerance);
    /// H^-1 of the free nodes' part, 0 at supports (3 x n), with the stiffness of the last step.
    [[nodiscard]] Points solve(const Points& right) const;

private:
    [[nodiscard]] bool factorize(const Iterate& iterate);

    const StaticsModel& m_model;
    const StaticsNumbering& m_numbers;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
        m_factor;
    bool m_is_analysed = false;
};

}  // namespace taut
