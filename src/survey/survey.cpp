// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/survey.hpp"

#include <fmt/core.h>

#include <map>

namespace taut {
namespace {

double mean_edge_length(const CableNet& net) {
    double sum = 0.0;
    for (const auto& [s, t] : net.edges()) {
        sum += (net.nodes().col(s) - net.nodes().col(t)).norm();
    }
    return sum / net.edge_count();
}

}  // namespace

Survey match_by_name(const CableNet& net, const std::vector<SurveyPoint>& points) {
    std::map<std::string, int> node_of;
    for (int node = 0; node < net.node_count(); ++node) {
        node_of.emplace(net.node_id(node), node);
    }
    const double mean_length = mean_edge_length(net);
    Survey survey;
    survey.form = net.nodes();
    std::vector<bool> seen(static_cast<size_t>(net.node_count()), false);
    for (const SurveyPoint& point : points) {
        const auto found = node_of.find(point.id);
        if (found == node_of.end()) {
            throw SurveyError(point.line,
                              fmt::format("'{}' is no node of the net '{}'", point.id, net.name()));
        }
        const int node = found->second;
        if (seen[static_cast<size_t>(node)]) {
            throw SurveyError(point.line, fmt::format("surveys node '{}' a second time", point.id));
        }
        seen[static_cast<size_t>(node)] = true;
        if (!point.position.allFinite()) {
            throw SurveyError(
                point.line, fmt::format("node '{}' has a coordinate that is not finite", point.id));
        }
        const bool is_support = net.free_index(node) < 0;
        const double distance = (point.position - net.nodes().col(node)).norm();
        const double limit = is_support ? 0.1 * mean_length : mean_length;
        if (distance > limit) {
            throw SurveyError(
                point.line,
                fmt::format(
                    "{} '{}' lies {:.4g} m from its nominal place, expected at most {:.4g} m: "
                    "is the survey of this net, in its frame and in metres?",
                    is_support ? "support" : "node", point.id, distance, limit));
        }
        if (!is_support) {
            survey.form.col(node) = point.position;
        }
    }
    for (const int node : net.free_nodes()) {
        (seen[static_cast<size_t>(node)] ? survey.surveyed : survey.missing).push_back(node);
    }
    return survey;
}

}  // namespace taut
