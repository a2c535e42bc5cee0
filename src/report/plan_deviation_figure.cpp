// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "report/figures.hpp"
#include "report/net_drawing.hpp"
#include "report/node_map.hpp"
#include "report/number_text.hpp"

namespace taut::report {
namespace {

/// How far nodes are from the target before and after, of each of some nodes [m].
struct Deviations {
    std::vector<int> nodes;
    Eigen::VectorXd built;
    Eigen::VectorXd planned;

    [[nodiscard]] double largest() const {
        return nodes.empty() ? 0.0 : std::max(built.maxCoeff(), planned.maxCoeff());
    }
};

Deviations in_all_directions(const PlanResult& plan) {
    const std::vector<int>& nodes = plan.net.free_nodes();
    const auto distances = [&](const Points& form) -> Eigen::VectorXd {
        return (form - plan.target_form)(Eigen::all, nodes).colwise().norm().transpose();
    };
    return {.nodes = nodes,
            .built = distances(plan.built_form),
            .planned = distances(plan.planned_form)};
}

/// Of the nodes at which the target has a normal.
Deviations along_normal(const PlanResult& plan) {
    std::vector<int> nodes = plan.net.free_nodes();
    std::erase_if(nodes, [&](int node) { return plan.target_normals.col(node).isZero(0.0); });
    const auto distances = [&](const Points& form) -> Eigen::VectorXd {
        return (form - plan.target_form)
            .cwiseProduct(plan.target_normals)(Eigen::all, nodes)
            .colwise()
            .sum()
            .cwiseAbs()
            .transpose();
    };
    return {.nodes = nodes,
            .built = distances(plan.built_form),
            .planned = distances(plan.planned_form)};
}

double rms(const Eigen::VectorXd& values) {
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

std::string before_and_after(const Deviations& of, const std::string& direction) {
    return fmt::format("{} {} mm RMS as built and {} mm as planned (at most {} and {} mm)",
                       direction, millimetres(rms(of.built)), millimetres(rms(of.planned)),
                       millimetres(of.built.maxCoeff()), millimetres(of.planned.maxCoeff()));
}

}  // namespace

Figure plan_deviation_figure(const PlanResult& plan) {
    const Deviations normal = along_normal(plan);
    const Deviations all = in_all_directions(plan);
    const double largest = 1e3 * std::max(normal.largest(), all.largest());
    Figure figure{.heading = "Distance from the target, before and after turning"};
    const auto draw = [&](const Deviations& of, const std::string& name, const std::string& words) {
        for (const bool is_planned : {false, true}) {
            const std::string which = is_planned ? "as planned" : "as built";
            figure.drawings.push_back(node_map_drawing(
                plan.net, plan.planned_form,
                {.name = fmt::format("plan_{}_{}", name, is_planned ? "planned" : "built"),
                 .title = fmt::format("Distance from the target {}, {}, in plan", words, which),
                 .heading = fmt::format("{}, {} [mm]", which, words),
                 .nodes = of.nodes,
                 .values = 1e3 * (is_planned ? of.planned : of.built),
                 .largest = largest}));
        }
    };
    if (!normal.nodes.empty()) {
        draw(normal, "normal", "along the normal");
    }
    if (!all.nodes.empty()) {
        draw(all, "distance", "in all directions");
    }
    if (figure.drawings.empty()) {
        return figure;
    }
    figure.caption = fmt::format(
        "Distance of the free nodes from the target: {}{}. All have the same view and the same "
        "colour scale.{}",
        normal.nodes.empty() ? "" : before_and_after(normal, "along its normal") + "; ",
        before_and_after(all, "in all directions"), thinning_note(plan.net));
    return figure;
}

}  // namespace taut::report
