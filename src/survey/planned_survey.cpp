// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/survey/planned_survey.hpp"

#include <map>

namespace taut {

Survey planned_survey(const CableNet& net, const std::vector<PlannedTarget>& targets,
                      double noise_std) {
    std::map<std::string, int> node_of;
    for (int node = 0; node < net.node_count(); ++node) {
        node_of.emplace(net.node_id(node), node);
    }
    std::vector<SurveyPoint> points;
    for (const PlannedTarget& target : targets) {
        if (target.id.empty()) {
            throw SurveyError(target.line, "names no node, expected one");
        }
        // A name that is no node's goes on without a place, to be refused as in any survey.
        const auto found = node_of.find(target.id);
        points.push_back({.id = target.id,
                          .position = found == node_of.end() ? Eigen::Vector3d::Zero().eval()
                                                             : net.nodes().col(found->second),
                          .line = target.line});
    }
    return match_to_nodes(net, points, noise_std);
}

}  // namespace taut
