// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/misfit_hint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "survey/match_by_place.hpp"
#include "survey/mean_edge_length.hpp"

namespace taut {
namespace {

bool fit_with_axes_exchanged(const CableNet& net, std::vector<SurveyPoint> points) {
    constexpr double most = 0.95;
    for (SurveyPoint& point : points) {
        std::swap(point.position.x(), point.position.y());
    }
    const std::vector<PlaceMatch> matches = match_by_place(net, points, [](int) { return false; });
    const auto matched =
        std::ranges::count_if(matches, [](const PlaceMatch& match) { return !match.unmatched; });
    return !points.empty() &&
           static_cast<double>(matched) >= most * static_cast<double>(points.size());
}

/// Lines of two points that are near their nodes as they stand, and in another unit.
std::string mixed_units(const CableNet& net, const std::vector<SurveyPoint>& points) {
    constexpr double foot = 0.3048;
    constexpr std::array<double, 7> units{1.0,        1e-3,        1e3,       foot,
                                          1.0 / foot, 1e-3 / foot, 1e3 * foot};
    std::map<std::string, int> node_of;
    for (int node = 0; node < net.node_count(); ++node) {
        node_of.emplace(net.node_id(node), node);
    }
    const double reach = 0.5 * mean_edge_length(net);
    int as_they_stand = 0;
    int in_another = 0;
    for (const SurveyPoint& point : points) {
        const auto found = node_of.find(point.id);
        if (found == node_of.end()) {
            return "";
        }
        const Eigen::Vector3d node = net.nodes().col(found->second);
        const auto* const unit = std::ranges::find_if(
            units, [&](double factor) { return (factor * point.position - node).norm() < reach; });
        if (unit == units.end()) {
            return "";
        }
        int& line = *unit == 1.0 ? as_they_stand : in_another;
        line = line == 0 ? point.line : line;
    }
    return as_they_stand == 0 || in_another == 0
               ? ""
               : fmt::format("; lines {} and {} fit it in two units: expected one for all",
                             std::min(as_they_stand, in_another),
                             std::max(as_they_stand, in_another));
}

}  // namespace

std::string misfit_hint(const CableNet& net, const std::vector<SurveyPoint>& points) {
    if (fit_with_axes_exchanged(net, points)) {
        return "; with x and y exchanged its points are on the net's nodes (--columns tells the "
               "columns of a table)";
    }
    return mixed_units(net, points);
}

}  // namespace taut
