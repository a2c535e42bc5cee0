// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h, section } from "./dom";
import { millimetres, number, percent } from "./format";
import { plainTable } from "./plain_table";
import { missedWords } from "./plan_summary";
import type { FormDeviation, Plan, TargetTension } from "./result";

const kN = (newton: number | null): string => number(newton === null ? null : newton / 1e3);

/** How far the mean over the samples, or the estimate without, is from the target, in tolerances. */
const offTarget = (t: TargetTension): number => Math.abs((t.mean ?? t.planned) - t.target) / t.tolerance;

const isFormWeighed = ({ options: { node_weights } }: Plan): boolean => node_weights === undefined || [...node_weights.normal, ...node_weights.tangential].some((w) => w > 0);

/** The target tensions, the worst first; nothing where there are none. */
function targetTensions(plan: Plan): (HTMLElement | null)[] {
  const all = [...(plan.target_tensions ?? [])].sort((a, b) => offTarget(b) - offTarget(a));
  if (all.length === 0) return [];
  const most = 40;
  return [
    plainTable("Target tensions", ["Target tensions [kN]", "target", "tolerance", "as built", "as planned", "unconstrained optimum", "mean", "std", "within tolerance [%]"],
      all.slice(0, most).map((t) => [`edge ${t.edge_id}`, kN(t.target), kN(t.tolerance), kN(t.as_built), kN(t.planned), kN(t.unconstrained), kN(t.mean), kN(t.std), percent(t.probability)]), ["", "", "", "", "here"]),
    h("p", { class: "quiet" }, `${missedWords(plan)}Mean, std and probability are over the posterior samples of the plan. ${isFormWeighed(plan) ? `A form deviation of ${millimetres(plan.options.form_tolerance)} mm counts as much as one tolerance of tension.` : "The form does not count: all its weights are 0."}${all.length > most ? ` ${all.length - most} more are in the plan's file.` : ""}`),
  ];
}

/** Deviation from the target as built, as planned and without limits; then the limits that are not kept. */
export function planSection(plan: Plan): HTMLElement {
  const { as_built, planned, unconstrained, normal_std } = plan.form;
  const rows: [string, keyof FormDeviation][] = [
    ["normal, RMS", "normal_rmse"], ["normal, mean", "normal_mean"], ["normal, max", "normal_max"],
    ["3D, RMS", "rmse"], ["3D, mean", "mean"], ["3D, max", "max"],
  ];
  const std = plan.draws > 0
    ? `The planned form has a std along the normal of ${millimetres(normal_std)} mm (RMS). Another survey reduces it; turning does not.`
    : "The uncertainty of the planned form is not known: the plan has no posterior samples.";
  const most = 40;
  const violations = plan.violations.slice(0, most);
  return section("plan", "Deviation from the target, and limits",
    plainTable("Deviation from the target", ["Deviation from the target [mm]", "as built", "as planned", "unconstrained optimum"],
      rows.map(([label, key]) => [label, millimetres(as_built[key]), millimetres(planned[key]), millimetres(unconstrained[key])]), ["", "", "here", ""]),
    h("p", { class: "quiet" }, std, " The unconstrained optimum minimises the weighted RMS with unlimited strokes; its other numbers may be larger than the planned ones."),
    ...targetTensions(plan),
    plan.violations.length === 0 ? h("p", { class: "quiet" }, `${plan.limits_given === false ? "No limits of tension or reaction were given; no cable goes slack" : "Every limit is kept"}${plan.draws > 0 ? " with the required probability" : " by the estimate"}.`)
      : plainTable("Limits that are not kept with the required probability", [plan.feasible ? "Least probable limits" : "Limits not kept", "load case", "as planned [kN]", "limit [kN]", "probability [%]"],
        violations.map((b) => [`${b.kind === "tension" ? "tension of edge" : "reaction of support"} ${b.id}`, b.load_case ?? "loads of the net", number(b.value / 1e3), number(b.limit / 1e3), plan.draws > 0 ? percent(b.probability) : "–"]), ["", "text", "", "", ""]),
    plan.violations.length > most ? h("p", { class: "quiet" }, `${plan.violations.length - most} more are in the plan's file`) : null);
}
