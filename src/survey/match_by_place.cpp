// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/match_by_place.hpp"

// A header of Boost includes one that is deprecated, and says so at each build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <limits>
#include <map>

#include "survey/mean_edge_length.hpp"

namespace taut {
namespace {

namespace bg = boost::geometry;
using Place = bg::model::point<double, 3, bg::cs::cartesian>;
using NodePlace = std::pair<Place, int>;

Place place(const Eigen::Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}

/// The nearest node alone, other targets not asked.
PlaceMatch nearest(const bg::index::rtree<NodePlace, bg::index::quadratic<16>>& nodes,
                   const Eigen::Vector3d& position, double reach) {
    constexpr unsigned two = 2;
    std::vector<NodePlace> found;
    nodes.query(bg::index::nearest(place(position), two), std::back_inserter(found));
    double distances[two] = {std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::infinity()};
    PlaceMatch match;
    for (const auto& [node_place, node] : found) {
        const double distance = bg::distance(node_place, place(position));
        if (distance < distances[0]) {
            distances[1] = distances[0];
            distances[0] = distance;
            match.node = node;
        } else {
            distances[1] = distance;
        }
    }
    match.distance = distances[0];
    if (match.distance > reach) {
        match.unmatched = UnmatchedReason::far_from_every_node;
    } else if (distances[1] < 2.0 * distances[0]) {
        match.unmatched = UnmatchedReason::between_nodes;
    }
    return match;
}

}  // namespace

std::vector<PlaceMatch> match_by_place(const CableNet& net, const std::vector<SurveyPoint>& targets,
                                       const std::function<bool(int)>& taken) {
    std::vector<PlaceMatch> matches;
    if (targets.empty()) {
        return matches;
    }
    std::vector<NodePlace> places;
    places.reserve(net.node_count());
    for (int node = 0; node < net.node_count(); ++node) {
        places.emplace_back(place(net.nodes().col(node)), node);
    }
    const bg::index::rtree<NodePlace, bg::index::quadratic<16>> nodes(places);
    const double reach = 0.5 * mean_edge_length(net);
    std::map<int, int> claims;
    matches.reserve(targets.size());
    for (const SurveyPoint& target : targets) {
        matches.push_back(nearest(nodes, target.position, reach));
        // A target between two nodes may be of either: it claims none, but the other may be right.
        claims[matches.back().node] += matches.back().unmatched ? 0 : 1;
    }
    for (PlaceMatch& match : matches) {
        if (!match.unmatched && (claims[match.node] > 1 || taken(match.node))) {
            match.unmatched = UnmatchedReason::node_taken;
        }
    }
    return matches;
}

}  // namespace taut
