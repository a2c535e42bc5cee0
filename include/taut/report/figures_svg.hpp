// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "taut/export/report.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

/// The figures of a result, each as an SVG file (name, content) on white. Of a study, all that the
/// paper plots in its section 5:
///
///     net_view.svg, net_plan.svg        the net in parallel projection and in plan [m]
///     length_deviations.svg             true, identified and error of the length deviation over
///                                       the interior edges, first validation sample [mm]
///     length_errors.svg                 errors e_i(k) over the interior edges, their mean and mean
///                                       +- std [mm]
///     form_error_nominal.svg,           |r - r'| over the net in plan, first validation sample, on
///     form_error_identified.svg         one colour scale [mm]
///
/// Of an identification the net and
///
///     length_intervals.svg              length deviations with 95 % intervals [mm]
///     residual_map.svg                  |surveyed - predicted| over the net in plan [mm]
///     residual_histogram.svg            standardised residuals, where the result has them
///
/// Of a comparison
///
///     error_over_noise.svg,             root of the mean squared error of each method, and the
///     error_over_training.svg           best possible [mm]
///
/// Of a plan
///
///     plan_normal_built.svg,            distance from the target along its normal, and in all
///     plan_normal_planned.svg,          directions, over the net in plan, on one colour scale [mm]
///     plan_distance_built.svg,
///     plan_distance_planned.svg
///     plan_tensions.svg                 tensions with their intervals and limits [kN]
///
/// Of simulated jobs, over the rounds and by what was planned on
///
///     control_form.svg                  distance from the target along its normal [mm]
///     control_limits.svg                share of jobs with a broken limit [%]
///     control_strokes.svg               strokes turned [mm]
///
/// Of large nets only some edges and nodes are drawn, evenly spread.
[[nodiscard]] TAUT_REPORT_EXPORT std::vector<std::pair<std::string, std::string>> figures_svg(
    const ResultFile& result);

}  // namespace taut
