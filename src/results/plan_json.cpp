// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "results/document_parts.hpp"
#include "results/result_parts.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {

Description<FormDeviation> describe(const FormDeviation* /*type*/) {
    return Description<FormDeviation>("form_deviation",
                                      "Distances from the target over the free nodes, and along "
                                      "its normal over those that have one [m].")
        .key("mean", &FormDeviation::mean, size)
        .key("max", &FormDeviation::max, size)
        .key("rmse", &FormDeviation::rmse, size)
        .key("normal_mean", &FormDeviation::normal_mean, size)
        .key("normal_max", &FormDeviation::normal_max, size)
        .key("normal_rmse", &FormDeviation::normal_rmse, size);
}

Description<LimitBreach> describe(const LimitBreach* /*type*/) {
    using Breach = LimitBreach;
    return Description<Breach>("limit_breach")
        .key("kind", TAUT_VALUE(it.kind == Breach::Kind::tension ? "tension" : "reaction"),
             Rule::one_of({"tension", "reaction"}))
        .optional("edge", TAUT_VALUE(when(it.kind == Breach::Kind::tension, it.index)),
                  "Of a tension.")
        .optional("node", TAUT_VALUE(when(it.kind == Breach::Kind::reaction, it.index)),
                  "The support of a reaction.")
        .key("id", TAUT_VALUE(it.kind == Breach::Kind::tension ? c.net->edge_id(it.index)
                                                               : c.net->node_id(it.index)))
        .key("load_case", TAUT_VALUE(unless_empty(it.load_case)), "Null: the loads of the net.")
        .key("value", &Breach::value, size, "Planned [N].")
        .key("limit", &Breach::limit, size, "[N].")
        .key("probability", &Breach::probability, part,
             "Probability that the limit is kept; 0 or 1 without samples.");
}

Description<StageEnd> describe(const StageEnd* /*type*/) {
    return Description<StageEnd>("stage", "A part of the work, done before the next begins.")
        .key("name", &StageEnd::name, "Group of edges; rest: what no stage holds.")
        .key("part", &StageEnd::part, part, "Of the strokes of its edges.")
        .key("step", TAUT_VALUE(when(it.step >= 0, it.step)),
             "The last one of the stage, from 0; null: nothing was turned so far.")
        .key("least_tension", &StageEnd::least_tension,
             "At its end, over all edges, in the estimate [N].")
        .key("most_tension", &StageEnd::most_tension)
        .key("safe_probability", &StageEnd::safe_probability, part,
             "Probability that no step until then breaks a limit; 0 or 1 without samples.");
}

Description<ListedTurning> describe(const ListedTurning* /*type*/) {
    using Turn = ListedTurning;
    return Description<Turn>("turn", "One action of a crew at one turnbuckle.")
        .key("edge", TAUT_VALUE(it.turning.edge))
        .key("edge_id", TAUT_VALUE(c.net->edge_id(it.turning.edge)))
        .key("stroke", TAUT_VALUE(it.turning.stroke),
             "Change of the unstressed length, positive lengthens [m].")
        .key("turns", &Turn::turns, size, "Without sign; null without a pitch.")
        .key("action", TAUT_VALUE(action_of(it.turning.stroke)),
             Rule::one_of({"shorten", "lengthen"}))
        .key("rotation", &Turn::rotation, Rule::one_of({"clockwise", "counterclockwise"}),
             "Seen from the support along the cable; null without a thread.")
        .key("pass", TAUT_VALUE(it.turning.pass), "From 1.")
        .key("crew", TAUT_VALUE(it.turning.crew), "From 1.")
        .key("step", TAUT_VALUE(it.turning.step),
             "From 0; in one step each crew turns at most one edge.")
        .key("reading_after", &Turn::reading_after,
             "Unstressed length then, less the designed one [m].")
        .newer("tension_after_step", TAUT_VALUE(it.turning.tension),
               "Of the edge after this step [N].")
        .newer("frequency_after_step",
               TAUT_VALUE(when(it.turning.frequency > 0.0, it.turning.frequency)), size,
               "Its first natural one then; null without a mass, or where it is no string [Hz].")
        .key("tension_after", &Turn::tension_after, "When all is done [N].");
}

Description<PlanResult::Tension> describe(const PlanResult::Tension* /*type*/) {
    using Tension = PlanResult::Tension;
    return Description<Tension>("planned_tension",
                                "Of an edge; negative in a compressed strut [N].")
        .key("edge", &Tension::edge)
        .key("as_built", &Tension::as_built)
        .key("planned", &Tension::planned)
        .key("lower", &Tension::lower, "95 % interval; null without samples.")
        .key("upper", &Tension::upper)
        .key("limit_lower", &Tension::limit_lower, "Null: none, of a strut.")
        .key("limit_upper", &Tension::limit_upper, "Null: none.");
}

Description<ReachedTension> describe(const ReachedTension* /*type*/) {
    using Reached = ReachedTension;
    return Description<Reached>(
               "target_tension",
               "A target tension, and how near the plan comes to it. Mean, std and "
               "probability are over the samples of the plan, null without; all "
               "else is of the estimate [N].")
        .key("edge", &Reached::edge)
        .key("edge_id", TAUT_VALUE(c.net->edge_id(it.edge)))
        .key("target", &Reached::target, size)
        .key("tolerance", &Reached::tolerance, size)
        .key("as_built", &Reached::as_built, size)
        .key("planned", &Reached::planned, size)
        .key("unconstrained", &Reached::unconstrained, size, "With unlimited strokes.")
        .key("of_any_form", &Reached::of_any_form, size,
             "With unlimited strokes and without regard to the form.")
        .key("mean", &Reached::mean, size)
        .key("std", &Reached::std_dev, size)
        .key("probability", &Reached::probability, part, "That it is within the tolerance.")
        .key("obstacle", &Reached::obstacle, "What keeps it out of the tolerance.");
}

Description<WorstStep> describe(const WorstStep* /*type*/) {
    return Description<WorstStep>("worst_step")
        .key("step", &WorstStep::step)
        .key("breach", &WorstStep::breach);
}

Description<SuggestedEdge> describe(const SuggestedEdge* /*type*/) {
    return Description<SuggestedEdge>("suggested_edge")
        .key("edge", &SuggestedEdge::edge)
        .key("edge_id", TAUT_VALUE(c.net->edge_id(it.edge)))
        .key("stroke", &SuggestedEdge::stroke)
        .key("normal_rmse_after", &SuggestedEdge::normal_rmse_after, size)
        .newer("tension_rmse_after", &SuggestedEdge::tension_rmse_after, size,
               "Of the target tensions, in their tolerances; null without them.");
}

Description<SuggestedTarget> describe(const SuggestedTarget* /*type*/) {
    return Description<SuggestedTarget>("suggested_target")
        .key("node", &SuggestedTarget::node)
        .key("id",
             [](const SuggestedTarget& one, const Context& c) { return c.net->node_id(one.node); })
        .key("normal_std", &SuggestedTarget::normal_std, size,
             "form/normal_std with this target and those before [m].");
}

namespace {

Eigen::VectorXd built_tensions(const PlanRecord& record) {
    const CableNet& built = record.built->net;
    return tensions_of(built, built.unstressed_lengths(), built.nodes());
}

std::vector<PlanResult::Tension> tensions_of_edges(const PlanRecord& record) {
    const Plan& plan = record.turns->plan;
    const Eigen::VectorXd as_built = built_tensions(record);
    std::vector<PlanResult::Tension> edges;
    for (int e = 0; e < record.built->net.edge_count(); ++e) {
        const TensionLimits& limits = record.turns->limits.tension;
        edges.push_back({.edge = e,
                         .as_built = as_built(e),
                         .planned = plan.tensions(e),
                         .lower = {},
                         .upper = {},
                         .limit_lower = {},
                         .limit_upper = {}});
        if (plan.draws > 0) {
            edges.back().lower = plan.tension_lower(e);
            edges.back().upper = plan.tension_upper(e);
        }
        if (!std::isinf(limits.lower(e))) {
            edges.back().limit_lower = limits.lower(e);
        }
        if (!std::isinf(limits.upper(e))) {
            edges.back().limit_upper = limits.upper(e);
        }
    }
    return edges;
}

/// Zero where it is not given.
TurnSize turn_of(const PlanRecord& record) {
    return record.turns->options.turn.value_or(TurnSize());
}

/// Numbers of the free nodes.
std::vector<double> of_free_nodes(const PlanRecord& record, const Eigen::VectorXd& numbers) {
    std::vector<double> result;
    for (const int node : record.net->free_nodes()) {
        result.push_back(numbers(node));
    }
    return result;
}

Description<PlanRecord> plan_identification() {
    return Description<PlanRecord>("", "Verdict of the identification that the plan is based on.")
        .key("verdict", TAUT_VALUE(it.trust->verdict()))
        .key("reasons", TAUT_VALUE(reasons_of(*it.trust)));
}

Description<PlanRecord> plan_form() {
    return Description<PlanRecord>()
        .key("as_built", TAUT_VALUE(it.turns->plan.as_built))
        .key("planned", TAUT_VALUE(it.turns->plan.planned))
        .key("unconstrained", TAUT_VALUE(it.turns->plan.unconstrained),
             "What remains with unlimited strokes, no edge slack.")
        .key("normal_std", TAUT_VALUE(it.turns->plan.normal_std), size,
             "Standard deviation along the normal of the planned form, RMS over the nodes; 0 "
             "without samples [m].");
}

Description<PlanRecord> plan_tension() {
    return Description<PlanRecord>("", "[N].")
        .key("least", TAUT_VALUE(it.turns->plan.tensions.minCoeff()))
        .key("most", TAUT_VALUE(it.turns->plan.tensions.maxCoeff()))
        .key("least_as_built", TAUT_VALUE(built_tensions(it).minCoeff()))
        .key("most_as_built", TAUT_VALUE(built_tensions(it).maxCoeff()))
        .key("limit_probability", TAUT_VALUE(it.turns->plan.limit_probability), part,
             "Probability that all limits are kept; null without samples (0 or 1 in files of "
             "0.2.0).")
        .key("edges", tensions_of_edges, "Of all edges, in their order.");
}

Description<PlanRecord> plan_order() {
    return Description<PlanRecord>()
        .key("passes", TAUT_VALUE(it.turns->order.passes), "Over the net.")
        .key("crews", TAUT_VALUE(it.turns->crews))
        .key("walk", TAUT_VALUE(it.turns->order.walk), size, "Of all crews, in straight lines [m].")
        .key("safe", TAUT_VALUE(it.turns->order.is_safe),
             "Whether no step breaks a limit, with the required probability.")
        .newer("stages", TAUT_VALUE(it.turns->order.stages))
        .newer("safe_probability", TAUT_VALUE(it.turns->order.safe_probability), part,
               "Probability that no step breaks a limit; 0 or 1 without samples.")
        .key(
            "worst",
            [](const PlanRecord& record) {
                const WorstStep& worst = record.turns->order.worst;
                return worst.step < 0 ? std::nullopt : std::optional(worst);
            },
            "The step with the worst breach, where the order is not safe.");
}

Description<PlanRecord> plan_options() {
    return Description<PlanRecord>()
        .newer("target", TAUT_VALUE(it.target->surface() != nullptr ? "surface" : "form"),
               Rule::one_of({"form", "surface"}))
        .newer_object(
            "node_weights",
            Description<PlanRecord>()
                .key("normal", TAUT_VALUE(of_free_nodes(it, it.target->normal_weights())),
                     Rule::list_of(size))
                .key("tangential", TAUT_VALUE(of_free_nodes(it, it.target->tangential_weights())),
                     Rule::list_of(size)),
            "Of the deviation of each free node.")
        .key("confidence", TAUT_VALUE(it.turns->options.confidence), part)
        .key("actuator", TAUT_VALUE(it.turns->options.actuator_std), size,
             "Standard deviation of a stroke from the planned one [m].")
        .key("pitch", TAUT_VALUE(when(it.turns->options.turn.has_value(), turn_of(it).pitch)), size,
             "Change of length per turn; null: not given [m].")
        .key("step", TAUT_VALUE(when(it.turns->options.turn.has_value(), turn_of(it).step())), size,
             "By the smallest part of a turn; 0: any [m].")
        .key("tolerance", TAUT_VALUE(it.turns->options.tolerance), size, "[m].")
        .newer("form_tolerance",
               TAUT_VALUE(when(!it.turns->options.target_tensions.empty(),
                               it.turns->options.weighing_tolerance())),
               size,
               "Form deviation that counts as much as target tensions off by their tolerances; "
               "null without them [m].")
        .key("thread",
             TAUT_VALUE(when(it.turns->thread.has_value(),
                             it.turns->thread == Thread::right ? "right" : "left")),
             Rule::one_of({"right", "left"}), "Of the turnbuckles; null: not given.");
}

/// Targets that would make the planned form better known.
Description<PlanRecord> plan_targets() {
    return Description<PlanRecord>()
        .key("noise", TAUT_VALUE(it.turns->options.survey_noise.value()))
        .key("targets", TAUT_VALUE(it.turns->plan.suggested_targets));
}

}  // namespace

Description<PlanRecord> describe(const PlanRecord* /*type*/) {
    const Rule points = Rule::list_of(Rule::point());
    auto result = document<PlanRecord>("plan",
                                       "Result of taut plan: which turnbuckle to turn how far, in "
                                       "which order, and the form and tensions that follow.");
    result.key("net_fingerprint", TAUT_VALUE(it.net->fingerprint()))
        .key("net", [](const PlanRecord& record) -> const CableNet& { return *record.net; })
        .newer("warnings", plan_warnings,
               "Why nobody should turn by the plan, the worst reason first; they head its lists.")
        .object("identification", plan_identification())
        .key("turns", listed_turnings, "In the order of the work.")
        .key("touched", TAUT_VALUE(it.turns->plan.strokes.size()), Rule::count(),
             "Edges that are turned.")
        .key("largest_stroke", TAUT_VALUE(it.turns->plan.largest_stroke()), size, "[m].")
        .newer("limits_given", TAUT_VALUE(it.turns->limits.has_forces(it.built->net)),
               "Whether there are limits of forces other than no slack edge.")
        .key("feasible", TAUT_VALUE(it.turns->plan.is_feasible),
             "Whether all limits are kept with the required probability.")
        .key("converged", TAUT_VALUE(it.turns->plan.has_converged))
        .key("violations", TAUT_VALUE(it.turns->plan.breaches),
             "Limits that are broken, or kept with too small a probability; the worst first.")
        .object("form", plan_form())
        .object("tension", plan_tension())
        .newer("target_tensions", TAUT_VALUE(it.turns->plan.target_tensions),
               "Ascending by edge; empty: none were given.")
        .object("order", plan_order())
        .newer("suggested_adjustable", TAUT_VALUE(it.turns->suggested_adjustable),
               "Edges that would help most if they were adjustable, each with those before it; "
               "null: not asked for.")
        .object("options", plan_options())
        .object("whole_steps",
                Description<PlanRecord>().key(
                    "normal_rmse_of_free_strokes",
                    TAUT_VALUE(it.turns->plan.normal_rmse_of_free_strokes), size, "[m]."),
                "Cost of whole steps of a turn.")
        .object("tolerance",
                Description<PlanRecord>()
                    .key("reached", TAUT_VALUE(it.turns->plan.is_within_tolerance))
                    .key("fewest_bound", TAUT_VALUE(it.turns->plan.fewest_bound),
                         "To first order no fewer edges reach it."),
                "Both null without a given tolerance.")
        .newer(
            "suggested_targets",
            TAUT_VALUE(it.turns->options.survey_noise ? plan_targets().write(it, c) : ResultJson()),
            plan_targets().rule().or_null(),
            "Targets whose survey would make the planned form better known; null: not asked for.")
        .key("draws", TAUT_VALUE(it.turns->plan.draws))
        .key("no_draws_because",
             TAUT_VALUE(when(it.turns->plan.draws == 0, it.turns->plan.no_draws_because)),
             "Why there are none; null: there are.")
        .key("built_form", TAUT_VALUE(points_json(it.built->net.nodes())), points)
        .key("planned_form", TAUT_VALUE(points_json(it.turns->plan.form)), points)
        .key("planned_form_std", TAUT_VALUE(points_json(it.turns->plan.form_std)), points,
             "Standard deviation of each coordinate; 0 without samples.")
        .newer("planned_form_covariance",
               TAUT_VALUE(covariances_json(it.turns->plan.form_covariance)), covariances_rule(),
               "Covariance of each node's place in planned_form, as xx, xy, xz, yy, yz, zz; null "
               "without samples [m2].")
        .key("target_form", TAUT_VALUE(points_json(it.target->at(it.turns->plan.form).places())),
             points)
        .key("target_normals",
             TAUT_VALUE(points_json(it.target->at(it.turns->plan.form).normals())), points,
             "Unit normals of the target; 0 at nodes without.")
        .key("cable_net", TAUT_VALUE(net_json(*it.net)), net_rule().with_text("As designed."));
    return add_run(result);
}

std::string plan_to_json(const PlanRecord& record, const RunRecord& run) {
    return to_text(json_of(record, {.net = record.net, .run = &run}));
}

}  // namespace taut
