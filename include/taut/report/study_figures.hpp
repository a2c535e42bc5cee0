// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "taut/study/study.hpp"

namespace taut {

/// What the paper plots in its section 5, each as an SVG file (name, content) on white:
///   net_view.svg, net_plan.svg        the net in parallel projection and in plan [m]
///   length_deviations.svg             true, identified and error of the length deviation over the
///                                     interior edges, first validation sample [mm]
///   length_errors.svg                 all errors e_i(k) over the interior edges, their mean and
///                                     mean +- std [mm]
///   form_error_nominal.svg,           |r - r'| over the net in plan, first validation sample,
///   form_error_identified.svg         each with its own colour scale [mm]
/// Of large nets only some edges and nodes are drawn, evenly spread.
/// @param study as run_study() returns it
[[nodiscard]] std::vector<std::pair<std::string, std::string>> study_figures_svg(
    const Study& study);

}  // namespace taut
