// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCore>
#include <optional>
#include <vector>

#include "identification/planned_fit.hpp"

namespace taut {

/// Rows of numbers, columns of the unknowns z of Linearisation::joint_covariance().
using Rates = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Of all edges' tensions, slack ones 0 (m rows) [N].
[[nodiscard]] Rates tension_rates(const StaticsModel& model, const Iterate& iterate);

/// What a second survey sees while a load hangs on the net: y = rates z + e.
struct LoadResponse {
    Eigen::MatrixXd rates;  ///< three rows a target
    Eigen::MatrixXd noise;  ///< covariance of e: of the survey, of what stiffnesses of single
                            ///< edges change besides their lengths, and of another day's
                            ///< temperature [m2]
};

/// Of a vertical load, downwards, with the targets of a survey. With the out-of-balance forces h,
/// H_1 = dh/dr under the load, and T_1 its tensions,
///
///     dr_1 = dr + H_1^-1 (dh/dz - dh_1/dz) dz,
///
/// since both forms are in equilibrium under the same other loads. docs/theory.md, (load-response).
/// @param load [N]
/// @return nothing where no equilibrium was found under the load, a cable goes slack, or carries
///   more than its breaking load or, where that is not known, twice the highest designed tension
[[nodiscard]] std::optional<LoadResponse> response_to_load(const PlannedFit& planned, int node,
                                                           double load, const Survey& survey);

/// At most eight free nodes, ascending: from the one that gives way most under a vertical load to
/// the one that gives way least, at equal steps of their order.
[[nodiscard]] std::vector<int> nodes_to_load(const PlannedFit& planned);

}  // namespace taut
