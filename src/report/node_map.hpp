// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/svg.hpp"
#include "taut/results/result_file.hpp"

namespace taut::report {

/// What a map of a net in plan shows: a colour for each of some nodes.
struct NodeMap {
    std::string name;         ///< of the drawing
    std::string title;        ///< for those who cannot see it
    std::string heading;      ///< above the map, with its unit
    std::vector<int> nodes;   ///< at least one
    Eigen::VectorXd values;   ///< one a node, not negative
    double largest = 0.0;     ///< of the colour scale, which begins at zero
    std::vector<int> marked;  ///< nodes that have no value here, and stand out
};

[[nodiscard]] Drawing node_map_drawing(const CableNet& net, const Points& form, const NodeMap& map);

}  // namespace taut::report
