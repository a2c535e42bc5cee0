// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "adjustment/tension_targets.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "taut/adjustment/request_error.hpp"

namespace taut {
namespace {

constexpr const char* of_targets = "target_tension";

/// Targets of the same rank: of all edges, of groups, or of single edges.
int rank_of(const GivenTension& given) {
    return given.edge ? 2 : given.group ? 1 : 0;
}

TensionTarget target_of_edge(const GivenTension& given, int edge) {
    return {.edge = edge,
            .tension = given.tension,
            .tolerance = given.tolerance.value * (given.tolerance.is_part ? given.tension : 1.0)};
}

}  // namespace

std::string_view to_string(TensionObstacle obstacle) {
    switch (obstacle) {
        case TensionObstacle::limits:
            return "limits";
        case TensionObstacle::form:
            return "form";
        case TensionObstacle::turnbuckles:
            return "turnbuckles";
        case TensionObstacle::none:
            break;
    }
    return "none";
}

double ReachedTension::deviation() const {
    return (mean.value_or(planned) - target) / tolerance;
}

const std::vector<int>& edges_of_group(const CableNet& net, const std::string& group,
                                       const char* of_field) {
    const auto found = net.data().groups.find(group);
    if (found == net.data().groups.end()) {
        throw RequestError(of_field,
                           fmt::format("names the group '{}', which the net does not have", group));
    }
    return found->second;
}

std::vector<TensionTarget> tension_targets_of(const CableNet& net,
                                              std::span<const GivenTension> given) {
    std::vector<int> all;  // cables
    for (int edge = 0; edge < net.edge_count(); ++edge) {
        if (!net.is_strut(edge)) {
            all.push_back(edge);
        }
    }
    std::map<int, std::pair<int, TensionTarget>> by_edge;  // with its rank
    for (const GivenTension& one : given) {
        const int rank = rank_of(one);
        for (const int edge : one.edge    ? std::vector<int>{*one.edge}
                              : one.group ? edges_of_group(net, *one.group, of_targets)
                                          : all) {
            if (edge < 0 || edge >= net.edge_count()) {
                throw RequestError(of_targets, fmt::format("names edge {}, expected 0 to {}", edge,
                                                           net.edge_count() - 1));
            }
            const TensionTarget target = target_of_edge(one, edge);
            const auto [found, is_new] = by_edge.try_emplace(edge, rank, target);
            auto& [rank_before, before] = found->second;
            if (!is_new && rank_before == rank &&
                (before.tension != target.tension || before.tolerance != target.tolerance)) {
                throw RequestError(
                    of_targets,
                    fmt::format("of edge '{}' is given twice: {:g} +- {:g} N and {:g} +- "
                                "{:g} N",
                                net.edge_id(edge), before.tension, before.tolerance, target.tension,
                                target.tolerance));
            }
            if (rank >= rank_before) {
                found->second = {rank, target};
            }
        }
    }
    std::vector<TensionTarget> targets;
    targets.reserve(by_edge.size());
    for (const auto& [edge, ranked] : by_edge) {
        targets.push_back(ranked.second);
    }
    return targets;
}

void check_tension_targets(const CableNet& net, std::span<const TensionTarget> targets,
                           const TensionLimits& limits) {
    constexpr double largest = 1e12;  // no cable bears it, and its square is a number
    constexpr double finest = 1e-6;   // of the tension: equilibria are hardly more exact
    int last = -1;
    for (const TensionTarget& target : targets) {
        const int edge = target.edge;
        if (edge <= last || edge >= net.edge_count()) {
            throw RequestError(of_targets,
                               fmt::format("names edge {}, expected each of the {} edges at most "
                                           "once, in ascending order",
                                           edge, net.edge_count()));
        }
        last = edge;
        const std::string id = net.edge_id(edge);
        if (net.is_strut(edge)) {
            throw RequestError(of_targets,
                               fmt::format("is of edge '{}', a strut, expected a cable", id));
        }
        if (!(target.tension > 0.0 && target.tension < largest)) {
            throw RequestError(of_targets,
                               fmt::format("of edge '{}' is {:g} N, expected more than 0: "
                                           "no edge may go slack",
                                           id, target.tension));
        }
        if (!(target.tolerance >= finest * target.tension && target.tolerance < largest)) {
            throw RequestError(of_targets,
                               fmt::format("of edge '{}' has the tolerance {:g} N, expected at "
                                           "least a millionth of it",
                                           id, target.tolerance));
        }
        if (target.tension < limits.lower(edge) || target.tension > limits.upper(edge)) {
            throw RequestError(of_targets,
                               fmt::format("of edge '{}' is {:g} N, but its tension is "
                                           "limited to {:g} N..{}",
                                           id, target.tension, limits.lower(edge),
                                           std::isinf(limits.upper(edge))
                                               ? ""
                                               : fmt::format("{:g} N", limits.upper(edge))));
        }
    }
}

std::optional<double> tension_rmse(std::span<const TensionTarget> targets,
                                   const Eigen::VectorXd& forces) {
    if (targets.empty()) {
        return std::nullopt;
    }
    double sum = 0.0;
    for (const TensionTarget& target : targets) {
        const double tension = std::max(0.0, forces(target.edge));
        sum += std::pow((tension - target.tension) / target.tolerance, 2);
    }
    return std::sqrt(sum / static_cast<double>(targets.size()));
}

std::vector<ReachedTension> reached_tensions(std::span<const TensionTarget> targets,
                                             const TensionStates& states) {
    std::vector<ReachedTension> result;
    for (const TensionTarget& target : targets) {
        const auto tension_in = [&](const StrokedState* state) {
            return std::max(0.0, state->nets.front().forces(target.edge));
        };
        ReachedTension reached{.edge = target.edge,
                               .target = target.tension,
                               .tolerance = target.tolerance,
                               .as_built = tension_in(states.as_built),
                               .planned = tension_in(states.planned),
                               .unconstrained = tension_in(states.unconstrained),
                               .of_any_form = tension_in(states.of_any_form)};
        const auto is_within = [&](double tension) {
            return std::abs(tension - target.tension) <= target.tolerance;
        };
        double bias = 0.0;  // of the samples' mean from the estimate
        if (states.draws != nullptr) {
            const Eigen::ArrayXd drawn =
                states.draws->forces.front().row(target.edge).transpose().cwiseMax(0.0);
            reached.mean = drawn.mean();
            reached.std_dev = std::sqrt((drawn - *reached.mean).square().mean());
            reached.probability =
                ((drawn - target.tension).abs() <= target.tolerance).cast<double>().mean();
            bias = *reached.mean - reached.planned;
        }
        reached.obstacle = is_within(reached.planned + bias)          ? TensionObstacle::none
                           : !is_within(reached.of_any_form + bias)   ? TensionObstacle::turnbuckles
                           : !is_within(reached.unconstrained + bias) ? TensionObstacle::form
                                                                      : TensionObstacle::limits;
        result.push_back(reached);
    }
    return result;
}

}  // namespace taut
