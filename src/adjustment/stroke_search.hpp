// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adjustment/stroke_response.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/adjustment/tension_target.hpp"
#include "taut/progress.hpp"

namespace taut {

/// Shorter strokes count as none [m].
inline constexpr double negligible_stroke = 1e-6;

/// One set of loads of a plan: the net under them, and its limits.
struct LimitedResponse {
    StrokeResponse response;
    ForceRange range;
    Points start;  ///< form at which its solver starts (3 x n) [m]
};

/// Strokes with the equilibria that follow, one per set of loads.
struct StrokedState {
    Eigen::VectorXd strokes;  ///< k [m]
    std::vector<StrokedNet> nets;
    double cost = 0.0;       ///< cost_of() its deviations from the targets [m2]
    double violation = 0.0;  ///< sum of the excesses of forces over their limits [N]
    [[nodiscard]] bool balanced() const;
};

struct StrokeSearch {
    StrokedState found;
    int iterations = 0;
    bool has_converged = false;
};

/// The targets, and the limits of the strokes.
struct StrokeTask {
    const FormTarget* target = nullptr;
    Eigen::VectorXd shortest;  ///< k [m]
    Eigen::VectorXd longest;
    /// Cost of a newton over a limit [m2/N]; where it is large, the search lowers the violation
    /// first.
    double violation_weight = 0.0;
    std::vector<TensionTarget> tensions = {};  ///< of the first net
    double form_tolerance = 0.0;  ///< form deviation that counts as one tolerance of a tension [m]
    Progress progress = {};       ///< asked at each state whether to stop
};

/// What the search minimises: cost, turning and violation together [m2].
[[nodiscard]] double merit_of(const StrokeTask& task, double cost, const Eigen::VectorXd& strokes,
                              double violation);
[[nodiscard]] double merit_of(const StrokeTask& task, const StrokedState& state);

/// The state that strokes lead to.
/// @throws Interrupted if StrokeTask::progress requests a stop
/// @param near where the solvers start; null: at the starts of the responses
[[nodiscard]] StrokedState state_at(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                                    const Eigen::VectorXd& strokes, const StrokedState* near);

/// Sequential convex programming with an exact penalty and a trust region (R. Fletcher, Practical
/// Methods of Optimization, Wiley 1987, section 12.4): docs/theory.md (stroke-program).
/// @param responses one per set of loads; the form of the first comes near the target
/// @param start if it is not balanced, it is returned as not converged
[[nodiscard]] StrokeSearch search_strokes(std::vector<LimitedResponse>& responses,
                                          const StrokeTask& task, const StrokedState& start);

}  // namespace taut
