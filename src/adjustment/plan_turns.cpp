// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/adjustment/plan_turns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "adjustment/built_net_parts.hpp"
#include "adjustment/resolved_request.hpp"
#include "adjustment/tension_targets.hpp"
#include "adjustment/work_stages.hpp"
#include "statics/arguments.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/cable_vibration.hpp"

namespace taut {
namespace {

void check_stroke(const char* field, double stroke) {
    if (!(stroke > 0.0) || std::isinf(stroke)) {
        throw RequestError(field,
                           fmt::format("is {}, expected more than 0", format_length(stroke)));
    }
}

/// Narrows `edges` to those of the ranges, and gives their limits.
Limits limits_of_ranges(const CableNet& net, std::vector<StrokeRange> ranges,
                        std::vector<int>& edges) {
    std::ranges::sort(ranges, {}, &StrokeRange::edge);
    for (const StrokeRange& range : ranges) {
        check_edges(net.edge_count(), std::array{range.edge});
        if (!std::ranges::binary_search(edges, range.edge) &&
            !std::ranges::binary_search(net.adjustable_edges(), range.edge)) {
            throw RequestError("stroke", fmt::format("names edge '{}', which is not adjustable",
                                                     net.edge_id(range.edge)));
        }
        if (!(range.shortest <= 0.0 && range.longest >= 0.0) ||
            !std::isfinite(range.longest - range.shortest)) {
            throw RequestError(
                "stroke", fmt::format("of edge '{}' goes from {:g} to {:g} m, expected a range "
                                      "that holds 0",
                                      net.edge_id(range.edge), range.shortest, range.longest));
        }
    }
    std::erase_if(ranges, [&](const StrokeRange& range) {
        return !std::ranges::binary_search(edges, range.edge);
    });
    if (ranges.empty()) {
        throw RequestError("stroke", "leaves no edge that may be turned");
    }
    edges.clear();
    std::ranges::transform(ranges, std::back_inserter(edges), &StrokeRange::edge);
    Limits limits = stroke_limits(net, edges, 0.0);
    for (size_t k = 0; k < ranges.size(); ++k) {
        limits.shortest_stroke(static_cast<Eigen::Index>(k)) = ranges[k].shortest;
        limits.longest_stroke(static_cast<Eigen::Index>(k)) = ranges[k].longest;
    }
    return limits;
}

/// Narrows the strokes so that no edge ends further than `total` from its designed length.
void limit_total_stroke(const CableNet& net, const BuiltNet& built, double total,
                        const std::vector<int>& edges, Limits& limits) {
    constexpr double rounding = 1e-9;
    check_stroke("total_stroke", total);
    for (size_t k = 0; k < edges.size(); ++k) {
        const int edge = edges[k];
        const double offset = turned_from_design(net, built, edge);
        if (std::abs(offset) > total * (1.0 + rounding)) {
            throw RequestError(
                "total_stroke",
                fmt::format("is {}, but the turnbuckle of edge '{}' already is {:.2f} mm from its "
                            "designed length",
                            format_length(total), net.edge_id(edge), 1e3 * offset));
        }
        const auto at = static_cast<Eigen::Index>(k);
        limits.shortest_stroke(at) =
            std::max(limits.shortest_stroke(at), std::min(0.0, -total - offset));
        limits.longest_stroke(at) =
            std::min(limits.longest_stroke(at), std::max(0.0, total - offset));
    }
}

std::string text_of(const TensionRange& range) {
    const auto bound = [](const std::optional<TensionBound>& of) {
        return !of           ? ""
               : of->is_part ? fmt::format("{:g} %", 100.0 * of->value)
                             : fmt::format("{:g} N", of->value);
    };
    return fmt::format("{}..{}", bound(range.least), bound(range.most));
}

void take_tension(const CableNet& net, const TensionRange& range, TensionLimits& limits) {
    check_tension_range(range);
    std::vector<int> edges;
    if (range.group) {
        edges = edges_of_group(net, *range.group, "tension");
    } else {
        for (int edge = 0; edge < net.edge_count(); ++edge) {
            if (!net.is_strut(edge)) {
                edges.push_back(edge);
            }
        }
    }
    const auto is_strut = [&net](int edge) { return net.is_strut(edge); };
    if (range.group && std::ranges::any_of(edges, is_strut) &&
        !std::ranges::all_of(edges, is_strut)) {
        throw RequestError("tension",
                           fmt::format("is {} of the group '{}', which has cables and "
                                       "struts: give limits of each in a group of its own",
                                       text_of(range), *range.group));
    }
    const bool has_negative =
        (range.least && range.least->value < 0.0) || (range.most && range.most->value <= 0.0);
    if (has_negative && !std::ranges::all_of(edges, is_strut)) {
        throw RequestError(
            "tension", fmt::format("is {}, expected a lower limit of 0 or more and an upper one "
                                   "above it: only struts carry compression",
                                   text_of(range)));
    }
    const bool has_part =
        (range.least && range.least->is_part) || (range.most && range.most->is_part);
    if (has_part && net.data().breaking_load.size() == 0) {
        throw RequestError("tension",
                           fmt::format("is {}, a part of the breaking load, but the net has no "
                                       "breaking_load (in N)",
                                       text_of(range)));
    }
    if (has_part && std::ranges::any_of(edges, is_strut)) {
        throw RequestError("tension",
                           fmt::format("is {}, a part of the breaking load, but '{}' has "
                                       "struts: give forces",
                                       text_of(range), range.group.value_or("")));
    }
    const auto force_of = [&](const TensionBound& bound, int edge) {
        return bound.is_part ? bound.value * net.data().breaking_load(edge) : bound.value;
    };
    const Eigen::VectorXd& buckling_load = net.data().buckling_load;
    const auto take = [&](int edge) {
        if (range.least) {
            const double buckling = buckling_load.size() > 0 && net.is_strut(edge)
                                        ? -buckling_load(edge)
                                        : -std::numeric_limits<double>::infinity();
            limits.lower(edge) = std::max(force_of(*range.least, edge), buckling);
        }
        if (range.most) {
            limits.upper(edge) = force_of(*range.most, edge);
        }
    };
    std::ranges::for_each(edges, take);
}

std::vector<WorkStage> stages_of(const CableNet& net, const std::vector<int>& turnable,
                                 const std::vector<GivenStage>& given) {
    std::vector<WorkStage> stages;
    stages.reserve(given.size());
    for (const GivenStage& one : given) {
        const std::vector<int>& edges = edges_of_group(net, one.group, "stages");
        if (std::ranges::none_of(
                edges, [&](int edge) { return std::ranges::binary_search(turnable, edge); })) {
            throw RequestError(
                "stages",
                fmt::format("is of the group '{}', but no edge of that may be turned", one.group));
        }
        stages.push_back({.name = one.group, .edges = edges, .part = one.part});
    }
    check_stages(net, stages);
    return stages;
}

ReactionLimit limit_of(const CableNet& net, const ReactionBound& bound) {
    if (!bound.group) {
        return {.name = "all supports", .supports = net.all_supports(), .upper = bound.upper};
    }
    ReactionLimit limit{.name = *bound.group, .supports = {}, .upper = bound.upper};
    std::set<int> supports;
    for (const int edge : edges_of_group(net, *bound.group, "reaction")) {
        for (const int node : net.edges()[edge]) {
            if (net.is_support(node)) {
                supports.insert(node);
            }
        }
    }
    limit.supports.assign(supports.begin(), supports.end());
    if (limit.supports.empty()) {
        throw RequestError(
            "reaction",
            fmt::format("is at the group '{}', but no edge of that is at a support", *bound.group));
    }
    return limit;
}

/// "total stroke" of "total_stroke".
std::string in_words(std::string field) {
    std::ranges::replace(field, '_', ' ');
    return field;
}

}  // namespace

RequestError::RequestError(const std::string& field, const std::string& problem)
    : std::invalid_argument("the " + in_words(field) + " " + problem),
      m_field(field),
      m_problem(problem) {}

void check_tension_range(const TensionRange& range) {
    const TensionBound least = range.least.value_or(
        TensionBound{.value = range.group ? -std::numeric_limits<double>::infinity() : 0.0});
    const TensionBound most =
        range.most.value_or(TensionBound{.value = std::numeric_limits<double>::infinity()});
    const bool is_comparable = least.is_part == most.is_part || std::isinf(most.value);
    const bool is_negative = !(least.value >= 0.0) || !(most.value > 0.0);
    const bool may_be_negative = range.group && !least.is_part && !most.is_part;
    if ((is_negative && !may_be_negative) || std::isnan(least.value) || std::isnan(most.value) ||
        (is_comparable && !(most.value > least.value))) {
        throw RequestError("tension",
                           fmt::format("is {}, expected a lower limit{} and an upper one above it",
                                       text_of(range), may_be_negative ? "" : " of 0 or more"));
    }
    if ((least.is_part && least.value > 1.0) || (most.is_part && most.value > 1.0)) {
        throw RequestError(
            "tension",
            fmt::format("is {}, expected no more than 100 % of the breaking load", text_of(range)));
    }
}

ResolvedRequest resolve(const CableNet& net, const BuiltNet& built, const PlanRequest& request) {
    ResolvedRequest result{.options = request.options, .limits = {}};
    std::vector<int>& edges = result.options.edges;
    if (edges.empty()) {
        edges = net.adjustable_edges();
    }
    check_edges(net.edge_count(), edges);
    std::ranges::sort(edges);
    Limits& limits = result.limits;
    if (request.stroke_ranges.empty()) {
        check_stroke("stroke", request.stroke);
        limits = stroke_limits(net, edges, request.stroke);
    } else {
        limits = limits_of_ranges(net, request.stroke_ranges, edges);
    }
    if (request.total_stroke) {
        limit_total_stroke(net, built, *request.total_stroke, edges, limits);
    }
    // Limits of all edges first, so that those of a group override them.
    for (const bool is_of_group : {false, true}) {
        for (const TensionRange& range : request.tension) {
            if (range.group.has_value() == is_of_group) {
                take_tension(net, range, limits.tension);
            }
        }
    }
    for (const ReactionBound& bound : request.reaction) {
        limits.reactions.push_back(limit_of(net, bound));
    }
    if (!request.target_tension.empty()) {
        result.options.target_tensions = tension_targets_of(net, request.target_tension);
    }
    if (result.options.form_tolerance && result.options.target_tensions.empty()) {
        throw RequestError("form_tolerance",
                           "weighs the form against target tensions, and none "
                           "are given");
    }
    for (const AddedLoads& added : request.load_cases) {
        check_form(added.name.c_str(), net.node_count(), added.loads);
        limits.load_cases.push_back({.name = added.name,
                                     .loads = built.net.loads() + added.loads,
                                     .tension = limits.tension});
    }
    return result;
}

PlannedTurns plan_turns(const CableNet& net, const BuiltNet& built, const FormTarget& target,
                        const PlanRequest& request, const Progress& progress) {
    if (request.suggest_adjustable < 0) {
        throw RequestError("suggest_adjustable",
                           fmt::format("is {}, expected 0 or more", request.suggest_adjustable));
    }
    auto [options, limits] = resolve(net, built, request);
    std::vector<WorkStage> stages = stages_of(net, options.edges, request.stages);
    PlannedTurns turns{.options = std::move(options),
                       .limits = std::move(limits),
                       .plan = {},
                       .order = {},
                       .suggested_adjustable = {},
                       .crews = request.crews,
                       .thread = request.thread};
    turns.plan = plan_strokes(built, target, turns.limits, turns.options, progress);
    turns.order = order_turns(built, turns.limits, turns.plan,
                              {.crews = request.crews,
                               .stages = std::move(stages),
                               .turn_step = turns.options.turn ? turns.options.turn->step() : 0.0,
                               .confidence = turns.options.confidence,
                               .actuator_std = turns.options.actuator_std,
                               .seed = turns.options.seed},
                              progress);
    for (Turning& turning : turns.order.turnings) {
        turning.frequency =
            expected_frequency(net, turning.edge, turning.length, turning.tension).value_or(0.0);
    }
    if (request.suggest_adjustable > 0) {
        turns.suggested_adjustable =
            suggested_edges(built, target, turns.limits, turns.options, turns.plan,
                            request.suggest_adjustable, progress);
    }
    return turns;
}

}  // namespace taut
