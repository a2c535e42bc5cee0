// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "adjustment/stroke_search.hpp"

namespace taut {

/// How far a net is from the targets of a task: the weighted deviations of the free nodes
/// (weighted-deviation), three rows each, then those of the target tensions (tension-targets), one
/// row each. With them the mean square over the nodes is the cost.
struct TargetDeviations {
    Eigen::VectorXd values;  ///< 3 n_I + targets [m]
    Eigen::MatrixXd rates;   ///< by the strokes, as many rows [m/m]
};

/// @param rates of the net; empty: those of the deviations are not computed
[[nodiscard]] TargetDeviations deviations_from_targets(const StrokeTask& task, const CableNet& net,
                                                       const StrokedNet& stroked,
                                                       const StrokeRates& rates = {});

/// Cost of deviations: their sum of squares over the number of nodes, or the largest square of a
/// node or tension [m2].
[[nodiscard]] double cost_of(const StrokeTask& task,
                             const Eigen::Ref<const Eigen::VectorXd>& values);

/// Cost of a state that is in equilibrium [m2].
[[nodiscard]] double cost_of(const StrokeTask& task, const CableNet& net,
                             const StrokedNet& stroked);

/// Whether the form is within StrokeTask::form_tolerance and the tensions within their tolerances,
/// each in the root of their mean square, or the largest of them.
[[nodiscard]] bool is_within_tolerances(const StrokeTask& task, const CableNet& net,
                                        const StrokedNet& stroked);

/// The target with weights whose median is 1, of those above 0, so that one node of a large weight
/// does not make turning cheap: beside the deviations stands what turning costs.
/// @throws std::invalid_argument where all weights are 0 and there are no target tensions
[[nodiscard]] FormTarget with_median_weight_one(FormTarget target, const CableNet& net,
                                                bool has_target_tensions);

}  // namespace taut
