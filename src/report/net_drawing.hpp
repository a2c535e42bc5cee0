// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "report/axes.hpp"
#include "report/projection.hpp"

namespace taut::report {

/// Places of a net's nodes in a drawing, one column a node.
using Places = Eigen::Matrix2Xd;

/// Axes in metres that show a plan at one scale in both directions, as large as a width and a
/// height allow, the margins for labels included.
/// @param top_left of the room that they may take
/// @param size of that room; the axes may leave some of it, on the right and below
[[nodiscard]] Axes plan_axes(const Plan& plan, const Points& form, const Eigen::Vector2d& top_left,
                             const Eigen::Vector2d& size);

/// Where the nodes stand within such axes.
[[nodiscard]] Places places_in(const Axes& axes, const Plan& plan, const Points& form);

/// Edges as one path. Of many, some.
[[nodiscard]] PathData edges_path(const CableNet& net, const std::vector<int>& edges,
                                  const Places& places);

/// Nodes as dots. Of many, some.
[[nodiscard]] PathData dots_path(const std::vector<int>& nodes, const Places& places);

/// Nodes as squares. Of many, some.
[[nodiscard]] PathData squares_path(const std::vector<int>& nodes, const Places& places,
                                    double width);

/// More edges or nodes of a kind than this are thinned out.
inline constexpr int most_drawn = 10000;

/// A sentence for the caption, which starts with a blank, where a net is thinned out; else nothing.
[[nodiscard]] std::string thinning_note(const CableNet& net);

}  // namespace taut::report
