// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";
import { counted, millimetres, number, percent, short } from "./format";
import type { LimitBreach, Plan } from "./result";
import { ellipseWords, nameOf, netWords, type Summary } from "./summary_words";

const kN = (newton: number): string => number(newton / 1e3);

/** "tension of edge 12: 1.43 kN, limit 1.50 kN". */
export function breachWords({ kind, id, load_case, value, limit }: LimitBreach): string {
  const under = load_case === null ? "" : ` under ${load_case}`;
  return `${kind === "tension" ? "tension of edge" : "reaction of support"} ${id}${under}: ${kN(value)} kN, limit ${kN(limit)} kN`;
}

const isNearer = ({ form }: Plan): boolean => form.planned.normal_rmse <= form.as_built.normal_rmse;

function formSentence(plan: Plan): string {
  const { as_built, planned, unconstrained } = plan.form;
  if (plan.turns.length === 0) {
    const why = plan.tolerance.reached ? `within the tolerance of ${millimetres(plan.options.tolerance)} mm` : "and no stroke within the limits brings it nearer";
    return `Nothing to turn: as built, the net is ${millimetres(as_built.normal_rmse)} mm from its target (RMS along the normal), ${why}.` + tensionWords(plan);
  }
  const by = `Turning ${counted(plan.touched, "cable")} by at most ${millimetres(plan.largest_stroke)} mm ${isNearer(plan) ? "brings" : "takes"} the net from ${millimetres(as_built.normal_rmse)} mm to ${millimetres(planned.normal_rmse)} mm from its target (RMS along the normal)`;
  // The optimum minimises a weighted RMS: this one may be above that of the plan.
  const remaining = unconstrained.normal_rmse < 0.98 * planned.normal_rmse
    ? `even with unlimited strokes ${millimetres(unconstrained.normal_rmse)} mm would remain` : "unlimited strokes would bring it no nearer";
  return `${by}; ${remaining}.` + tensionWords(plan) + stepWords(plan) + toleranceWords(plan) + ellipseWords(plan.cable_net, plan.planned_form_covariance, "planned");
}

/** How many target tensions are within their tolerance; nothing where there are none. */
function tensionWords({ target_tensions, draws }: Plan): string {
  if (!target_tensions?.length) return "";
  const within = target_tensions.filter((t) => t.obstacle === "none").length;
  return ` ${within} of ${counted(target_tensions.length, "target tension")} ${within === 1 ? "is" : "are"} within tolerance${draws > 0 ? " in the mean of the posterior samples" : " by the estimate"}.`;
}

/** Why target tensions are missed, and which are not known well enough, each a sentence with a blank behind it. */
export function missedWords({ target_tensions, options }: Plan): string {
  const all = target_tensions ?? [];
  const sentence = (count: number, words: string): string =>
    (count > 0 ? `${count} of ${counted(all.length, "target tension")} ${count === 1 ? "is" : "are"} ${words}. ` : "");
  const missed = (obstacle: string, why: string): string => sentence(all.filter((t) => t.obstacle === obstacle).length, `missed: ${why}`);
  return missed("turnbuckles", "no strokes of these turnbuckles were found that reach all targets, not even unlimited ones with any form")
    + missed("form", "the target form is in the way")
    + missed("limits", `limits of strokes or forces${options.step ? ", whole steps" : ""}${options.tolerance === null ? "" : ", the fewest turned cables"} are in the way`)
    + sentence(all.filter((t) => t.std !== null && t.std >= t.tolerance).length, "known no better than the tolerance: force measurements would show more");
}

/** What rounding to whole steps of a turn costs. */
function stepWords(plan: Plan): string {
  const free = plan.whole_steps.normal_rmse_of_free_strokes;
  if (!plan.options.step || !(free > 0)) return "";
  const part = plan.form.planned.normal_rmse / free - 1;
  return ` Without rounding to steps of ${millimetres(plan.options.step)} mm it would be ${millimetres(free)} mm${part > 0 ? ` (rounding costs ${number(100 * part, 2)} %)` : ""}.`;
}

function toleranceWords(plan: Plan): string {
  const { tolerance } = plan.options;
  if (tolerance === null) return "";
  const { reached, fewest_bound } = plan.tolerance;
  const bound = !reached || fewest_bound === null ? "" : `; to first order, at least ${counted(fewest_bound, "cable")} must be turned for it`;
  return ` The tolerance of ${millimetres(tolerance)} mm is ${reached ? "reached" : "not reached"}${bound}.`;
}

/** " (required: 95 %; 50 samples)" */
const required = ({ draws, options }: Plan): string => ` (required: ${short(100 * options.confidence)} %; ${counted(draws, "posterior sample")})`;

function limitSentence(plan: Plan): string {
  const { tension, draws, feasible } = plan;
  const range = `Tensions are ${kN(tension.least)} to ${kN(tension.most)} kN as planned, and ${kN(tension.least_as_built)} to ${kN(tension.most_as_built)} kN as built.`;
  const given = plan.limits_given === false ? "No limits of tension or reaction were given. " : "";
  const kept = given ? "No cable goes slack" : "All limits are kept";
  if (draws > 0) return `${given}${kept} with a probability of ${percent(tension.limit_probability ?? 0)} %${required(plan)}${feasible ? "" : ", which is too low"}. ${range}`;
  const estimate = feasible ? `${kept} by the estimate` : given ? "Cables go slack by the estimate" : "Not all limits are kept by the estimate";
  return `${given}${estimate}; the probability is not known${plan.no_draws_because ? `: ${plan.no_draws_because.replace(/\.$/, "")}` : ""}. ${range}`;
}

/** Probability that no step breaks a limit; nothing where it is not known. */
function orderProbability({ order, draws, options }: Plan): string {
  if (draws === 0 || order.safe_probability === undefined) return "";
  return `, with a probability of ${percent(order.safe_probability)} % (required: ${short(100 * options.confidence)} %)`;
}

/** The tensions after each stage in which something is turned. */
function stageSentences({ order, draws }: Plan): string {
  const some = (order.stages ?? []).filter((one, k, all) => one.step !== null && one.step !== all[k - 1]?.step);
  return some.map((one) => ` After stage ${one.name}, ${number(100 * one.part)} % of its strokes: ${kN(one.least_tension)} to ${kN(one.most_tension)} kN${draws > 0 ? `; probability that no step until then breaks a limit: ${percent(one.safe_probability)} %` : ""}.`).join("");
}

function orderSentence(plan: Plan): string {
  const { order, turns } = plan;
  if (turns.length === 0) return "The crews have no work.";
  const work = `Order of work: ${order.passes} ${order.passes === 1 ? "pass" : "passes"}, ${counted(order.crews, "crew")}, ${number(order.walk)} m of walking.`;
  if (order.safe) return `${work} No step breaks a limit that was kept before the work${orderProbability(plan)}.`;
  const sure = orderProbability(plan) ? ` Its steps break no limit${orderProbability(plan)}.` : "";
  const worst = order.worst ? ` The worst is step ${order.worst.step + 1}: ${breachWords(order.worst.breach)}${order.worst.breach.probability > 0 ? `, kept with a probability of ${percent(order.worst.breach.probability)} %` : ""}.` : "";
  return `${work} No safe order was found; this one has the smallest excess.${sure}${worst}`;
}

/** The aim of the plan; nothing where there is nothing to do. */
function aimOf(plan: Plan): string {
  if (plan.turns.length === 0) return "";
  if (!plan.feasible) return " No strokes keep all limits; the plan has the smallest excess.";
  const limits = plan.limits_given === false ? "keeps all cables taut" : "keeps all cables within their limits";
  if (plan.target_tensions?.length) return ` It ${limits} and weighs the target form against target tensions.`;
  return isNearer(plan) ? ` It ${limits} and brings the form nearer to its target.` : ` It ${limits}, which takes the form away from its target.`;
}

export function ofPlan(plan: Plan): Summary {
  const { form, tension, draws } = plan;
  const probability = `probability that ${plan.limits_given === false ? "no cable goes slack" : "all limits are kept"}`;
  return {
    title: "Which turnbuckle to turn, and how far",
    done: `A plan for the net ${nameOf(plan.net)}: ${netWords(plan.net)}. It uses the lengths that were identified from a survey.${aimOf(plan)}`,
    sentences: [formSentence(plan), limitSentence(plan), orderSentence(plan) + stageSentences(plan)],
    figures: [
      { value: String(plan.touched), unit: "", label: "cables to turn" },
      { value: millimetres(plan.largest_stroke), unit: "mm", label: "largest stroke" },
      { value: `${number(1e3 * form.as_built.normal_rmse, 2)} → ${number(1e3 * form.planned.normal_rmse, 2)}`, unit: "mm", label: "normal deviation from the target, RMS" },
      { value: `${kN(tension.least)} – ${kN(tension.most)}`, unit: "kN", label: "tension as planned" },
      draws > 0
        ? { value: percent(tension.limit_probability ?? 0), unit: "%", label: `${probability} (required: ${short(100 * plan.options.confidence)} %)` }
        : { value: "–", unit: "", label: `${probability}: not known without posterior samples` },
    ],
  };
}

function limitsKept({ feasible, limits_given }: Plan): string {
  if (limits_given === false) return `No limits of tension or reaction were given; ${feasible ? "no cable goes slack" : "cables may go slack"}`;
  return feasible ? "All limits are kept" : "Limits cannot all be kept";
}

/** Whether one may turn by the plan: the checks of the identification, and the limits. */
export function planBoxes(plan: Plan): HTMLElement[] {
  const { verdict, reasons } = plan.identification;
  const advice = {
    passed: "",
    doubtful: " Resolve its findings before turning.",
    failed: " Turning by this plan may do harm. Resolve the findings and identify again.",
  }[verdict];
  const shown = 5;
  const checks = h("div", { class: `trust ${verdict}` },
    h("p", {}, h("strong", {}, `Checks of the identification: ${verdict}.`), advice),
    reasons.length === 0 ? null : h("ul", { class: "findings" }, ...reasons.slice(0, shown).map((reason) => h("li", {}, reason))),
    reasons.length > shown ? h("p", {}, `${reasons.length - shown} more findings are in the plan's file.`) : null);
  const more = plan.violations.length - shown;
  const together = !plan.feasible && plan.violations.length > 0 && plan.violations.every((breach) => breach.probability > 0.5);
  const words = plan.feasible ? (plan.order.safe ? "" : "; but no safe order was found") : together ? ". Each limit is likelier kept than not; all of them together are not kept often enough. The least probable:" : "; the plan has the smallest excess. These are not kept:";
  const limits = h("div", { class: `trust ${!plan.feasible ? "failed" : plan.order.safe && plan.draws > 0 ? "passed" : "doubtful"}`, id: "verdict" },
    h("p", {}, h("strong", {}, limitsKept(plan)),
      !plan.feasible ? "" : plan.draws === 0 ? ", by the estimate alone" : `, with the required probability of ${short(100 * plan.options.confidence)} %`, words, plan.feasible ? "." : ""),
    ...(plan.feasible ? [] : plan.violations.slice(0, shown).map((breach) => h("p", {}, `${breachWords(breach)}${together ? `, kept with a probability of ${percent(breach.probability)} %` : ""}.`))),
    !plan.feasible && more > 0 ? h("p", {}, `${more} more are in the table below.`) : null,
    plan.converged ? null : h("p", {}, "The search for the best plan did not converge: another plan may be nearer to the target."));
  const warnings = plan.warnings ?? [];
  return [
    ...(warnings.length === 0 ? [] : [h("div", { class: "trust failed", id: "warnings" }, ...warnings.map((text) => h("p", {}, h("strong", {}, text))))]),
    checks, limits];
}
