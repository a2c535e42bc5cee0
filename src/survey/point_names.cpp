// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/point_names.hpp"

#include <map>
#include <utility>

#include "survey/match_by_place.hpp"
#include "survey/node_names.hpp"

namespace taut {

bool names_contradict_places(const CableNet& net, const std::vector<SurveyPoint>& points,
                             double matched_part) {
    constexpr double least_alike = 0.5;
    const std::map<std::string, int> node_of = nodes_by_name(net);
    const std::vector<PlaceMatch> matches = match_by_place(net, points, [](int) { return false; });
    double matched = 0.0;
    double named = 0.0;
    double alike = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
        if (matches[i].unmatched) {
            continue;
        }
        matched += 1.0;
        if (const auto found = node_of.find(points[i].id); found != node_of.end()) {
            named += 1.0;
            alike += found->second == matches[i].node ? 1.0 : 0.0;
        }
    }
    return named > 0.0 && matched >= matched_part * static_cast<double>(points.size()) &&
           alike < least_alike * named;
}

int make_names_labels(const CableNet& net, std::vector<SurveyPoint>& points, bool all) {
    const std::map<std::string, int> nodes = nodes_by_name(net);
    int count = 0;
    for (SurveyPoint& point : points) {
        if (!point.id.empty() && (all || !nodes.contains(point.id))) {
            point.label = std::exchange(point.id, "");
            ++count;
        }
    }
    return count;
}

}  // namespace taut
