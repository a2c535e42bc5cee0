// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "adjustment/stroke_response.hpp"
#include "taut/adjustment/form_target.hpp"
#include "taut/adjustment/limits.hpp"

namespace taut {

/// Strokes below this are none [m].
inline constexpr double negligible_stroke = 1e-6;

/// One set of loads of a plan: the net under them, and its limits.
struct LimitedResponse {
    StrokeResponse response;
    ForceRange range;
    Points start;  ///< where the search for its equilibrium begins (3 x n) [m]
};

/// Strokes with the equilibria that follow, one a set of loads.
struct StrokedState {
    Eigen::VectorXd strokes;  ///< k [m]
    std::vector<StrokedNet> nets;
    double cost = 0.0;       ///< mean square, or largest square, of the weighted deviations [m2]
    double violation = 0.0;  ///< sum of what forces are beyond their limits [N]
    [[nodiscard]] bool balanced() const;
};

struct StrokeSearch {
    StrokedState found;
    int iterations = 0;
    bool has_converged = false;
};

/// What the strokes are to do.
struct StrokeTask {
    const FormTarget* target = nullptr;
    Eigen::VectorXd shortest;  ///< k [m]
    Eigen::VectorXd longest;
    /// Cost of a newton beyond a limit [m2/N]; the search goes for the least violation first where
    /// it is large.
    double violation_weight = 0.0;
};

/// What the search lowers: cost, turning and violation together [m2].
[[nodiscard]] double merit_of(const StrokeTask& task, double cost, const Eigen::VectorXd& strokes,
                              double violation);
[[nodiscard]] double merit_of(const StrokeTask& task, const StrokedState& state);

/// The state that strokes lead to.
[[nodiscard]] StrokedState state_at(std::vector<LimitedResponse>& responses, const StrokeTask& task,
                                    const Eigen::VectorXd& strokes, const StrokedState* near);

/// Sequential convex programming with an exact penalty and a trust region (R. Fletcher, Practical
/// Methods of Optimization, Wiley 1987, section 12.4): docs/theory.md (stroke-program).
/// @param responses one a set of loads; the form of the first is to come near the target
/// @param start where it is not balanced, it is given back as not converged
[[nodiscard]] StrokeSearch search_strokes(std::vector<LimitedResponse>& responses,
                                          const StrokeTask& task, const StrokedState& start);

}  // namespace taut
