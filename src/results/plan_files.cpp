// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/plan_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "files/csv_field.hpp"
#include "results/result_parts.hpp"
#include "taut/files/printable.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/version.hpp"

namespace taut {
namespace {

using Json = ResultJson;

Json deviation_json(const FormDeviation& d) {
    return {{"mean", d.mean},
            {"max", d.max},
            {"rmse", d.rmse},
            {"normal_mean", d.normal_mean},
            {"normal_max", d.normal_max},
            {"normal_rmse", d.normal_rmse}};
}

/// A turning with its results.
struct Listed {
    Turning turning;
    double reading_after = 0.0;  ///< unstressed length then, less the designed one [m]
    double tension_after = 0.0;  ///< when all is done [N]
};

std::vector<Listed> listed_turnings(const PlanRecord& record) {
    std::map<int, double> length;
    std::vector<Listed> list;
    for (const Turning& turning : record.turns->order.turnings) {
        const auto [it, is_new] =
            length.try_emplace(turning.edge, record.built->net.unstressed_lengths()(turning.edge));
        it->second += turning.stroke;
        list.push_back(
            {.turning = turning,
             .reading_after = it->second - record.net->unstressed_lengths()(turning.edge),
             .tension_after = record.turns->plan.tensions(turning.edge)});
    }
    return list;
}

std::optional<double> count_of_turns(const PlanRecord& record, double stroke) {
    return record.turns->options.turn
               ? std::optional(std::abs(stroke) / record.turns->options.turn->pitch)
               : std::nullopt;
}

/// Of the support at an edge's end; empty where it has none.
std::string support_id(const CableNet& net, int edge) {
    for (const int node : net.edges()[edge]) {
        if (net.free_index(node) < 0) {
            return net.node_id(node);
        }
    }
    return {};
}

std::optional<Thread> thread_of(const PlanRecord& record, int edge) {
    const std::vector<int>& adjustable = record.net->adjustable_edges();
    const std::vector<Thread>& threads = record.net->data().thread;
    const auto found = std::ranges::find(adjustable, edge);
    if (record.turns->thread || threads.empty() || found == adjustable.end()) {
        return record.turns->thread;
    }
    return threads[static_cast<size_t>(found - adjustable.begin())];
}

Json breach_json(const CableNet& net, const LimitBreach& breach) {
    const bool is_edge = breach.kind == LimitBreach::Kind::tension;
    return {{"kind", is_edge ? "tension" : "reaction"},
            {is_edge ? "edge" : "node", breach.index},
            {"id", is_edge ? net.edge_id(breach.index) : net.node_id(breach.index)},
            {"load_case", breach.load_case.empty() ? Json() : Json(breach.load_case)},
            {"value", breach.value},
            {"limit", breach.limit},
            {"probability", breach.probability}};
}

Json planned_tension_json(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    const CableNet& built = record.built->net;
    const Eigen::VectorXd as_built = tensions(built, built.unstressed_lengths(), built.nodes());
    Json edges = Json::array();
    for (int e = 0; e < built.edge_count(); ++e) {
        const double upper = record.turns->limits.tension.upper(e);
        Json edge{{"edge", e},
                  {"as_built", as_built(e)},
                  {"planned", plan.tensions(e)},
                  {"lower", plan.draws > 0 ? Json(plan.tension_lower(e)) : Json()},
                  {"upper", plan.draws > 0 ? Json(plan.tension_upper(e)) : Json()},
                  {"limit_lower", record.turns->limits.tension.lower(e)},
                  {"limit_upper", std::isinf(upper) ? Json() : Json(upper)}};
        edges.push_back(std::move(edge));
    }
    return {{"least", plan.tensions.minCoeff()},
            {"most", plan.tensions.maxCoeff()},
            {"least_as_built", as_built.minCoeff()},
            {"most_as_built", as_built.maxCoeff()},
            {"limit_probability", or_null(plan.limit_probability)},
            {"edges", edges}};
}

Json turn_order_json(const PlanRecord& record) {
    const TurnOrder& order = record.turns->order;
    return {{"passes", order.passes},
            {"crews", record.turns->crews},
            {"walk", order.walk},
            {"safe", order.is_safe},
            {"safe_probability", order.safe_probability},
            {"worst", order.worst.step < 0
                          ? Json()
                          : Json{{"step", order.worst.step},
                                 {"breach", breach_json(*record.net, order.worst.breach)}}}};
}

/// Targets that would make the planned form better known; null where they were not asked for.
Json suggested_targets_json(const PlanRecord& record) {
    if (!record.turns->options.survey_noise) {
        return {};
    }
    Json targets = Json::array();
    for (const SuggestedTarget& target : record.turns->plan.suggested_targets) {
        targets.push_back({{"node", target.node},
                           {"id", record.net->node_id(target.node)},
                           {"normal_std", target.normal_std}});
    }
    return {{"noise", *record.turns->options.survey_noise}, {"targets", targets}};
}

Json suggested_edges_json(const PlanRecord& record) {
    if (!record.turns->suggested_adjustable) {
        return {};
    }
    Json result = Json::array();
    for (const SuggestedEdge& further : *record.turns->suggested_adjustable) {
        result.push_back({{"edge", further.edge},
                          {"edge_id", record.net->edge_id(further.edge)},
                          {"stroke", further.stroke},
                          {"normal_rmse_after", further.normal_rmse_after}});
    }
    return result;
}

/// Weights of the free nodes.
Json node_weights_json(const PlanRecord& record) {
    Json result{{"normal", Json::array()}, {"tangential", Json::array()}};
    for (const int node : record.net->free_nodes()) {
        result["normal"].push_back(record.target->normal_weights()(node));
        result["tangential"].push_back(record.target->tangential_weights()(node));
    }
    return result;
}

}  // namespace

std::string_view action_of(double stroke) {
    return stroke < 0.0 ? "shorten" : "lengthen";
}

std::optional<std::string_view> rotation_of(double stroke, std::optional<Thread> thread) {
    if (!thread) {
        return std::nullopt;
    }
    return (stroke < 0.0) == (*thread == Thread::right) ? "clockwise" : "counterclockwise";
}

std::vector<std::string> plan_warnings(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    const TurnOrder& order = record.turns->order;
    std::vector<std::string> warnings;
    if (const std::string failure = failure_of(*record.trust); !failure.empty()) {
        warnings.push_back(fmt::format(
            "DO NOT TURN BY THIS LIST: the identification failed its checks: {}", failure));
    }
    if (!plan.is_feasible) {
        warnings.emplace_back("DO NOT TURN BY THIS LIST: the plan breaks limits");
    } else if (!order.is_safe && order.worst.breach.probability > 0.0) {
        warnings.push_back(fmt::format(
            "NO SAFE ORDER WAS FOUND: the probability that no step breaks a limit is {:.1f} % "
            "(required: {:g} %)",
            100.0 * order.safe_probability, 100.0 * record.turns->options.confidence));
    } else if (!order.is_safe) {
        warnings.push_back(
            fmt::format("NO SAFE ORDER WAS FOUND: step {} breaks a limit", order.worst.step + 1));
    }
    if (plan.draws == 0 && record.turns->limits.has_forces()) {
        warnings.push_back(
            fmt::format("LIMITS CANNOT BE PROMISED: tensions are not reported, because {}",
                        plan.no_draws_because));
    }
    return warnings;
}

std::string plan_to_json(const PlanRecord& record, const RunRecord& run) {
    const Plan& plan = record.turns->plan;
    const CableNet& net = *record.net;
    Json turns = Json::array();
    for (const Listed& listed : listed_turnings(record)) {
        const Turning& turning = listed.turning;
        turns.push_back(
            {{"edge", turning.edge},
             {"edge_id", net.edge_id(turning.edge)},
             {"stroke", turning.stroke},
             {"turns", or_null(count_of_turns(record, turning.stroke))},
             {"action", action_of(turning.stroke)},
             {"rotation", or_null(rotation_of(turning.stroke, thread_of(record, turning.edge)))},
             {"pass", turning.pass},
             {"crew", turning.crew},
             {"step", turning.step},
             {"reading_after", listed.reading_after},
             {"tension_after", listed.tension_after}});
    }
    Json violations = Json::array();
    for (const LimitBreach& breach : plan.breaches) {
        violations.push_back(breach_json(net, breach));
    }
    Json document{
        {"format", "taut-plan"},
        {"version", 2},
        {"program", "taut " + std::string(version())},
        {"net_fingerprint", net.fingerprint()},
        {"net", counts_json(net)},
        {"warnings", plan_warnings(record)},
        {"identification", trust_json(*record.trust)},
        {"turns", turns},
        {"touched", plan.strokes.size()},
        {"largest_stroke", plan.largest_stroke()},
        {"limits_given", record.turns->limits.has_forces()},
        {"feasible", plan.is_feasible},
        {"converged", plan.has_converged},
        {"violations", violations},
        {"form",
         {{"as_built", deviation_json(plan.as_built)},
          {"planned", deviation_json(plan.planned)},
          {"unconstrained", deviation_json(plan.unconstrained)},
          {"normal_std", plan.normal_std}}},
        {"tension", planned_tension_json(record)},
        {"order", turn_order_json(record)},
        {"suggested_adjustable", suggested_edges_json(record)},
        {"options",
         {{"target", record.target->surface() != nullptr ? "surface" : "form"},
          {"node_weights", node_weights_json(record)},
          {"confidence", record.turns->options.confidence},
          {"actuator", record.turns->options.actuator_std},
          {"pitch", record.turns->options.turn ? Json(record.turns->options.turn->pitch) : Json()},
          {"step", record.turns->options.turn ? Json(record.turns->options.turn->step()) : Json()},
          {"tolerance", or_null(record.turns->options.tolerance)},
          {"thread", !record.turns->thread
                         ? Json()
                         : Json(*record.turns->thread == Thread::right ? "right" : "left")}}},
        {"whole_steps", {{"normal_rmse_of_free_strokes", plan.normal_rmse_of_free_strokes}}},
        {"tolerance",
         {{"reached", or_null(plan.is_within_tolerance)},
          {"fewest_bound", or_null(plan.fewest_bound)}}},
        {"suggested_targets", suggested_targets_json(record)},
        {"draws", plan.draws},
        {"no_draws_because", plan.draws > 0 ? Json() : Json(plan.no_draws_because)},
        {"built_form", points_json(record.built->net.nodes())},
        {"planned_form", points_json(plan.form)},
        {"planned_form_std", points_json(plan.form_std)},
        {"target_form", points_json(record.target->at(plan.form).places())},
        {"target_normals", points_json(record.target->at(plan.form).normals())},
        {"cable_net", net_json(net)}};
    add_run(document, run);
    return to_text(document);
}

std::string plan_to_csv(const PlanRecord& record) {
    std::string text;
    for (const std::string& warning : plan_warnings(record)) {
        text += fmt::format("# {}\n", printable(warning));
    }
    text +=
        "number,crew,pass,step,edge,support,action,rotation,turns,stroke_mm,scale_reading_mm,"
        "tension_after_kN\n";
    int number = 0;
    for (const Listed& listed : listed_turnings(record)) {
        const Turning& turning = listed.turning;
        const auto turns = count_of_turns(record, turning.stroke);
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{},{:.3f},{:.3f},{}\n", ++number, turning.crew, turning.pass,
            turning.step + 1, csv_field(record.net->edge_id(turning.edge)),
            csv_field(support_id(*record.net, turning.edge)), action_of(turning.stroke),
            rotation_of(turning.stroke, thread_of(record, turning.edge)).value_or(""),
            turns ? fmt::format("{:.3f}", *turns) : "", 1e3 * turning.stroke,
            1e3 * listed.reading_after,
            record.turns->plan.draws > 0 ? fmt::format("{:.3f}", 1e-3 * listed.tension_after) : "");
    }
    return text;
}

}  // namespace taut
