// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";
import { counted, millimetres, number, percent, short } from "./format";
import type { LimitBreach, Plan } from "./result";
import { nameOf, netWords, type Summary } from "./summary";

const kN = (newton: number): string => number(newton / 1e3);

/** "tension of edge 12: 1.43 kN, the limit is 1.50 kN". */
export function breachWords({ kind, id, load_case, value, limit }: LimitBreach): string {
  const under = load_case === null ? "" : ` under ${load_case}`;
  return `${kind === "tension" ? "tension of edge" : "reaction of support"} ${id}${under}: ${kN(value)} kN, the limit is ${kN(limit)} kN`;
}

const isNearer = ({ form }: Plan): boolean => form.planned.normal_rmse <= form.as_built.normal_rmse;

function formSentence(plan: Plan): string {
  const { as_built, planned, unconstrained } = plan.form;
  if (plan.turns.length === 0) {
    const since = plan.tolerance.reached ? `which is within the ${millimetres(plan.options.tolerance)} mm that were asked for` : "and no stroke within the limits brings it nearer";
    return `Nothing is to be turned: as built, the net is ${millimetres(as_built.normal_rmse)} mm from its target (RMS along the normal), ${since}.`;
  }
  const by = `Turning ${counted(plan.touched, "cable")} by at most ${millimetres(plan.largest_stroke)} mm ${isNearer(plan) ? "brings" : "takes"} the net from ${millimetres(as_built.normal_rmse)} mm to ${millimetres(planned.normal_rmse)} mm from its target (RMS along the normal)`;
  return `${by}; ${millimetres(unconstrained.normal_rmse)} mm could not be removed by any stroke.` + stepWords(plan) + toleranceWords(plan);
}

/** What whole steps of a turn cost. */
function stepWords(plan: Plan): string {
  const free = plan.whole_steps.normal_rmse_of_free_strokes;
  if (!plan.options.step || !(free > 0)) return "";
  const part = plan.form.planned.normal_rmse / free - 1;
  return ` With free strokes it would be ${millimetres(free)} mm: whole steps of ${millimetres(plan.options.step)} mm cost ${part > 0 ? `${number(100 * part, 2)} %` : "nothing"}.`;
}

function toleranceWords(plan: Plan): string {
  const { tolerance } = plan.options;
  if (tolerance === null) return "";
  const { reached, fewest_bound } = plan.tolerance;
  const bound = !reached || fewest_bound === null ? "" : `; to first order no fewer than ${counted(fewest_bound, "cable")} can do`;
  return ` The ${millimetres(tolerance)} mm that were asked for are ${reached ? "reached" : "not reached"}${bound}.`;
}

function limitSentence(plan: Plan): string {
  const { tension, draws, options } = plan;
  const range = `Tensions go from ${kN(tension.least)} to ${kN(tension.most)} kN, where they are ${kN(tension.least_as_built)} to ${kN(tension.most_as_built)} kN as built.`;
  if (plan.limits_given === false) {
    const sure = draws > 0 ? `with a probability of ${percent(tension.limit_probability ?? 0)} % (${counted(draws, "draw")}), where ${short(100 * options.confidence)} % was asked for` : `by the estimate, which cannot be promised${plan.no_draws_because ? `: ${plan.no_draws_because}` : ""}`;
    return `No limits of tension or reaction were given; ${plan.feasible ? "" : "not surely enough "}no cable goes slack ${sure}. ${range}`;
  }
  if (draws > 0) {
    return `${plan.feasible ? "All limits are kept together with a probability of" : "Not all limits are kept: the probability that they are is"} ${percent(tension.limit_probability ?? 0)} % (${counted(draws, "draw")}), where ${short(100 * options.confidence)} % was asked for. ${range}`;
  }
  return `Limits cannot be promised; by the estimate they are ${plan.feasible ? "kept" : "not all kept"}${plan.no_draws_because ? `: ${plan.no_draws_because}` : ""}. ${range}`;
}

/** How surely the work breaks no limit; nothing where that is not known. */
function orderProbability({ order, draws, options }: Plan): string {
  if (draws === 0 || order.safe_probability === undefined) return "";
  return `, with a probability of ${percent(order.safe_probability)} % (required: ${short(100 * options.confidence)} %)`;
}

function orderSentence(plan: Plan): string {
  const { order, turns } = plan;
  if (turns.length === 0) return "There is no work for a crew.";
  const work = `${counted(order.crews, "crew")} ${order.crews === 1 ? "goes" : "go"} over the net ${order.passes === 1 ? "once" : `${order.passes} times`}, ${number(order.walk)} m between stations in all`;
  if (order.safe) return `${work}; no step breaks a limit that was kept before the work${orderProbability(plan)}.`;
  const sure = orderProbability(plan) ? ` Its steps break no limit${orderProbability(plan)}.` : "";
  const worst = order.worst ? ` At step ${order.worst.step + 1} it is worst: ${breachWords(order.worst.breach)}${order.worst.breach.probability > 0 ? `, kept in ${percent(order.worst.breach.probability)} % of the draws` : ""}.` : "";
  return `${work}. No safe order was found; this is the least unsafe one.${sure}${worst}`;
}

/** What the plan is for; nothing where there is nothing to do. */
function aimOf(plan: Plan): string {
  if (plan.turns.length === 0) return "";
  if (!plan.feasible) return ", and breaks the limits, which no strokes can all keep, the least";
  if (plan.limits_given === false) return isNearer(plan) ? ", and brings the form nearer to its target while no cable goes slack" : ", and keeps cables from going slack, which takes the form from its target";
  return isNearer(plan) ? ", and brings the form nearer to its target while no cable leaves its limits" : ", and brings all cables into their limits, which takes the form from its target";
}

export function ofPlan(plan: Plan): Summary {
  const { form, tension, draws } = plan;
  return {
    title: "Which turnbuckle to turn how far",
    done: `A plan for the net ${nameOf(plan.net)}: ${netWords(plan.net)}. It stands on the lengths that were identified from a survey${aimOf(plan)}.`,
    sentences: [formSentence(plan), limitSentence(plan), orderSentence(plan)],
    figures: [
      { value: String(plan.touched), unit: "", label: "cables to turn" },
      { value: millimetres(plan.largest_stroke), unit: "mm", label: "largest stroke" },
      { value: `${number(1e3 * form.as_built.normal_rmse, 2)} → ${number(1e3 * form.planned.normal_rmse, 2)}`, unit: "mm", label: "from the target along its normal, RMS" },
      { value: `${kN(tension.least)} – ${kN(tension.most)}`, unit: "kN", label: "tension as planned" },
      draws > 0
        ? { value: percent(tension.limit_probability ?? 0), unit: "%", label: `probability that all limits are kept, ${short(100 * plan.options.confidence)} % wanted` }
        : { value: "–", unit: "", label: "probability of the limits: not known without draws" },
    ],
  };
}

function limitsKept({ feasible, limits_given }: Plan): string {
  if (limits_given === false) return `No limits of tension or reaction were given; ${feasible ? "no cable goes slack" : "cables may go slack"}`;
  return feasible ? "All limits are kept" : "Limits cannot all be kept";
}

/** May one act on it: the verdict of what it stands on, and whether limits are kept. */
export function planLines(plan: Plan): HTMLElement[] {
  const { verdict, reasons } = plan.identification;
  const about = {
    passed: "",
    doubtful: "look into what it names before turning",
    failed: "what is planned on it may do harm; mend what it names first",
  }[verdict];
  const shown = 5;
  const stands = h("div", { class: `trust ${verdict}` },
    h("p", {}, h("strong", {}, `The identification that this plan stands on: ${verdict}`), about ? `, ${about}` : ""),
    ...reasons.slice(0, shown).map((reason) => h("p", {}, reason)),
    ...(reasons.length > shown ? [h("p", {}, `${reasons.length - shown} more findings are in the plan.`)] : []));
  const more = plan.violations.length - shown;
  const words = plan.feasible ? (plan.order.safe ? "" : "; but no safe order was found") : "; the plan breaks them the least. In the way stand:";
  const limits = h("div", { class: `trust ${!plan.feasible ? "failed" : plan.order.safe && plan.draws > 0 ? "passed" : "doubtful"}`, id: "verdict" },
    h("p", {}, h("strong", {}, limitsKept(plan)),
      !plan.feasible ? "" : plan.draws === 0 ? ", by the estimate alone" : `, with the ${short(100 * plan.options.confidence)} % that were asked for`, words),
    ...(plan.feasible ? [] : plan.violations.slice(0, shown).map((breach) => h("p", {}, `${breachWords(breach)}.`))),
    !plan.feasible && more > 0 ? h("p", {}, `And ${more} more, in the table below.`) : null,
    plan.converged ? null : h("p", {}, "The search for the best plan ended before it had converged: another may be nearer to the target."));
  const warnings = plan.warnings ?? [];
  return [
    ...(warnings.length === 0 ? [] : [h("div", { class: "trust failed", id: "warnings" }, ...warnings.map((text) => h("p", {}, h("strong", {}, text))))]),
    stands, limits];
}
