// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/axes.hpp"
#include "report/projection.hpp"

namespace taut::report {

// Attributes that tell the page's script which edge or node stands where in a drawing, so that it
// can name what is pointed at and mark what is selected. A scale is "low high from to" (Scale).

/// Interior edges i = 1, 2, ... along x: data-chart="edges" data-x="..." data-y="...".
[[nodiscard]] std::string edge_chart(const Axes& axes);

/// Nodes in plan: data-chart="nodes" data-right="x" data-up="y" data-x="..." data-y="...".
[[nodiscard]] std::string node_chart(const Axes& axes, const Plan& plan);

}  // namespace taut::report
