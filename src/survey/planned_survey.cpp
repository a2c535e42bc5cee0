// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/planned_survey.hpp"

#include <map>

#include "survey/node_names.hpp"

namespace taut {

Survey planned_survey(const CableNet& net, const std::vector<PlannedTarget>& targets,
                      double noise_std) {
    const std::map<std::string, int> node_of = nodes_by_name(net);
    std::vector<SurveyPoint> points;
    for (const PlannedTarget& target : targets) {
        if (target.id.empty()) {
            throw SurveyError(target.line, "names no node, expected one");
        }
        // A name that is no node's gets no place: match_to_nodes() refuses it as in any survey.
        const auto found = node_of.find(target.id);
        points.push_back({.id = target.id,
                          .position = found == node_of.end() ? Eigen::Vector3d::Zero().eval()
                                                             : net.nodes().col(found->second),
                          .line = target.line});
    }
    return match_to_nodes(net, points, noise_std);
}

}  // namespace taut
