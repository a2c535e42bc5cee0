// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/work_stages.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "net/check_index.hpp"

namespace taut {

void check_stages(const CableNet& net, const std::vector<WorkStage>& stages) {
    std::vector<double> done(static_cast<size_t>(net.edge_count()), 0.0);
    for (const WorkStage& stage : stages) {
        if (!(stage.part > 0.0 && stage.part <= 1.0)) {
            throw std::invalid_argument(
                fmt::format("the stage '{}' does {:g} of the strokes, expected above 0, at most 1",
                            stage.name, stage.part));
        }
        for (const int edge : stage.edges) {
            check_index("edge", edge, net.edge_count());
            double& before = done[static_cast<size_t>(edge)];
            if (stage.part <= before) {
                throw std::invalid_argument(fmt::format(
                    "the stage '{}' does {:g} of the strokes, but a stage before has done {:g} of "
                    "that of edge '{}'",
                    stage.name, stage.part, before, net.edge_id(edge)));
            }
            before = stage.part;
        }
    }
}

std::vector<Pass> passes_of(const Plan& plan, const std::vector<WorkStage>& stages,
                            int passes_of_stage, double turn_step) {
    std::vector<Pass> result;
    const auto count = std::ssize(plan.strokes);
    Eigen::VectorXd done = Eigen::VectorXd::Zero(count);
    const auto in_whole_steps = [turn_step](double stroke) {
        return turn_step == 0.0 ? stroke : turn_step * std::round(stroke / turn_step);
    };
    const auto add_stage = [&](const Eigen::VectorXd& end, int stage) {
        for (int pass = 1; pass < passes_of_stage; ++pass) {
            const Eigen::VectorXd strokes = done + (end - done) * pass / passes_of_stage;
            result.push_back({.strokes = strokes.unaryExpr(in_whole_steps), .stage = stage});
        }
        result.push_back({.strokes = end, .stage = stage});
        done = end;
    };
    for (size_t k = 0; k < stages.size(); ++k) {
        Eigen::VectorXd end = done;
        for (Eigen::Index j = 0; j < count; ++j) {
            const PlannedStroke& stroke = plan.strokes[static_cast<size_t>(j)];
            if (std::ranges::find(stages[k].edges, stroke.edge) != stages[k].edges.end()) {
                end(j) = stages[k].part == 1.0 ? stroke.stroke
                                               : in_whole_steps(stages[k].part * stroke.stroke);
            }
        }
        add_stage(end, static_cast<int>(k));
    }
    Eigen::VectorXd all(count);
    for (Eigen::Index j = 0; j < count; ++j) {
        all(j) = plan.strokes[static_cast<size_t>(j)].stroke;
    }
    if (stages.empty() || all != done) {
        add_stage(all, static_cast<int>(stages.size()));
    }
    return result;
}

}  // namespace taut
