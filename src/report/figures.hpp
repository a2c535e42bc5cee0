// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/svg.hpp"
#include "taut/results/result_file.hpp"

namespace taut::report {

/// Drawings that stand side by side, where there is room, above one caption.
struct Figure {
    std::vector<Drawing> drawings;
    std::string heading;
    std::string caption;  ///< plain text, not escaped yet
};

/// A net in parallel projection and in plan (the paper's figure 3D).
/// @param which form it is: "nominal"
[[nodiscard]] Figure net_figure(const CableNet& net, const Points& form, const std::string& which);

/// True, identified and error over the interior edges for the first validation sample (figure
/// errorplot_q1).
[[nodiscard]] Figure length_deviation_figure(const StudyResult& study);

/// All errors e_i(k) with mean and standard deviation over the interior edges (figure boxplot).
[[nodiscard]] Figure length_error_figure(const StudyResult& study);

/// Nominal and identified form error of the first validation sample over the net in plan, on one
/// scale (figure deviations).
[[nodiscard]] Figure form_error_figure(const StudyResult& study);

/// Length deviations with their 95 % intervals over the edges.
[[nodiscard]] Figure length_interval_figure(const IdentificationResult& result);

/// Distance between surveyed and predicted nodes in plan; without a drawing where none was saved.
[[nodiscard]] Figure residual_map_figure(const IdentificationResult& result);

/// Histogram of the standardised residuals with the normal law beside it; without a drawing where
/// none was saved.
[[nodiscard]] Figure residual_histogram_figure(const IdentificationResult& result);

/// Mean squared error of each method over the noise of the survey and over the number of training
/// samples, with the best possible as a line.
[[nodiscard]] Figure comparison_figure(const ComparisonResult& comparison);

/// Distance from the target before and after turning, along its normal and in all directions, over
/// the net in plan, on one scale.
[[nodiscard]] Figure plan_deviation_figure(const PlanResult& plan);

/// Tensions as built and as planned, with their intervals and limits, over all edges.
[[nodiscard]] Figure plan_tension_figure(const PlanResult& plan);

/// Distance from the target along its normal over the rounds of simulated jobs, with its spread
/// over the trials.
[[nodiscard]] Figure control_form_figure(const ControlResult& control);

/// Share of jobs in which a limit is broken, and the strokes turned, over the rounds.
[[nodiscard]] Figure control_work_figure(const ControlResult& control);

/// All that a result has, in this order.
[[nodiscard]] std::vector<Figure> result_figures(const ResultFile& result);

/// Width of a drawing that takes the whole page, of one that shares it with another, and height of
/// a plan at most.
inline constexpr double full_width = 960.0;
inline constexpr double half_width = 480.0;
inline constexpr double most_height = 460.0;

}  // namespace taut::report
