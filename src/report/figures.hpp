// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/svg.hpp"
#include "taut/study/study.hpp"

namespace taut::report {

/// Drawings that stand side by side, where there is room, above one caption.
struct Figure {
    std::vector<Drawing> drawings;
    std::string heading;
    std::string caption;  ///< plain text, not escaped yet
};

/// The net in parallel projection and in plan (the paper's figure 3D).
[[nodiscard]] Figure net_figure(const Study& study);

/// True, identified and error over the interior edges for the first validation sample (figure
/// errorplot_q1).
[[nodiscard]] Figure length_deviation_figure(const Study& study);

/// All errors e_i(k) with mean and standard deviation over the interior edges (figure boxplot).
[[nodiscard]] Figure length_error_figure(const Study& study);

/// Nominal and identified form error of the first validation sample over the net in plan (figure
/// deviations).
[[nodiscard]] Figure form_error_figure(const Study& study);

/// All of these, in this order.
[[nodiscard]] std::vector<Figure> study_figures(const Study& study);

/// Width of a drawing that takes the whole page, and of one that shares it with another.
inline constexpr double full_width = 960.0;
inline constexpr double half_width = 480.0;

}  // namespace taut::report
