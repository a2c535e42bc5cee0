// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/unit_guess.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <map>

#include "survey/median.hpp"
#include "survey/node_names.hpp"

namespace taut {
namespace {

/// Of at least one place, a column each.
double extent_of(const Eigen::Matrix3Xd& places) {
    Eigen::Vector3d middle;
    for (int k = 0; k < 3; ++k) {
        middle(k) = median_of(places.row(k));
    }
    return median_of((places.colwise() - middle).colwise().norm());
}

/// Extents of points and of the nodes that they are of.
std::pair<double, double> extents_of(const CableNet& net, const std::vector<SurveyPoint>& points) {
    const std::map<std::string, int> node_of = nodes_by_name(net);
    std::vector<int> nodes;
    std::vector<Eigen::Index> named;
    for (size_t i = 0; i < points.size(); ++i) {
        if (const auto found = node_of.find(points[i].id); found != node_of.end()) {
            nodes.push_back(found->second);
            named.push_back(static_cast<Eigen::Index>(i));
        }
    }
    Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(points.size()));
    for (size_t i = 0; i < points.size(); ++i) {
        places.col(static_cast<Eigen::Index>(i)) = points[i].position;
    }
    constexpr size_t enough = 3;
    if (named.size() >= enough && 2 * named.size() >= points.size()) {
        return {extent_of(places(Eigen::all, named)), extent_of(net.nodes()(Eigen::all, nodes))};
    }
    return {points.empty() ? 0.0 : extent_of(places), extent_of(net.nodes())};
}

}  // namespace

std::optional<UnitGuess> guess_unit(const CableNet& net, const std::vector<SurveyPoint>& points) {
    // Half way, in logarithms, between the two nearest units, m and ft: sqrt(1 / 0.3048).
    constexpr double farthest = 1.8;
    constexpr std::array<std::pair<const char*, double>, 3> units{
        {{"m", 1.0}, {"mm", 1e-3}, {"ft", 0.3048}}};
    const auto [of_points, of_nodes] = extents_of(net, points);
    for (const auto& [name, length] : units) {
        const double ratio = length * of_points / of_nodes;
        if (ratio < farthest && ratio > 1.0 / farthest) {
            return UnitGuess{
                .name = name, .length = length, .points = of_points, .nodes = of_nodes};
        }
    }
    return std::nullopt;
}

std::string extents_text(const CableNet& net, const std::vector<SurveyPoint>& points) {
    const auto [of_points, of_nodes] = extents_of(net, points);
    return fmt::format(
        "the median distance from their middle is {:.4g}, that of the net's nodes {:.4g} m",
        of_points, of_nodes);
}

}  // namespace taut
