// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";
import { number, short } from "./format";
import type { Assumption, Detectable, Finding, Result } from "./result";

/** How a finding's value is shown: its unit, and the factor to that from SI units. */
interface Scale {
  unit: string;
  factor: number;
  /** What stands before the value. */
  before?: string;
}

const mm: Scale = { unit: "mm", factor: 1e3 };
const timesChance: Scale = { unit: "times what chance allows", factor: 1 };
const percent: Scale = { unit: "%", factor: 100 };

/** How to bring an edge or a node into sight; null where the net has none of that name. */
export type ShowItem = (of: "edge" | "node", id: string) => (() => void) | null;

/** What each kind of finding is about: of what its ids are, and how its value is shown; values without a scale are not. */
const kinds: Record<Finding["kind"], { name: string; of?: "edge" | "node"; scale?: Scale }> = {
  no_convergence: { name: "Convergence" },
  survey_scale: { name: "Scale of the survey", scale: { unit: "ppm", factor: 1e6 } },
  survey_frame: { name: "Frame of the survey", scale: mm },
  survey_noise: { name: "Standard deviation of the survey", scale: { unit: "times the given one", factor: 1 } },
  missing_load: { name: "Missing load", scale: { unit: "N at each node", factor: 1 } },
  prior: { name: "Prior of the length deviations", scale: { ...mm, before: "std " } },
  common_deviation: { name: "Common length deviation", scale: mm },
  run_scales: { name: "Scales of cable runs", scale: { ...percent, before: "std " } },
  length: { name: "Length outlier", of: "edge", scale: mm },
  slip: { name: "Slip at a clamp", of: "edge", scale: mm },
  swapped_cables: { name: "Swapped cables", of: "edge", scale: mm },
  adjustable_edge: { name: "Boundary outlier, adjustable edge", of: "edge", scale: mm },
  support: { name: "Boundary outlier, support", of: "node", scale: mm },
  boundary: { name: "Boundary outliers" },
  target: { name: "Target", of: "node", scale: mm },
  adjacent_targets: { name: "Adjacent targets", of: "node" },
  swapped_targets: { name: "Swapped targets", of: "node" },
  target_far_from_node: { name: "Target far from its node", of: "node", scale: mm },
  misplaced_names: { name: "Misplaced names", of: "node" },
  predicted_form: { name: "Predicted form", scale: mm },
  slack_marks: { name: "Marks of slack and taut edges", of: "edge" },
  force_scale: { name: "Scale of the force measurements", scale: percent },
  given_stiffness: { name: "Given stiffness", scale: percent },
  force_measurement: { name: "Force measurement", of: "edge", scale: { unit: "kN", factor: 1e-3 } },
  uncertain_parameter: { name: "Uncertain parameter", scale: { unit: "times the assumed std", factor: 1 } },
  tensions: { name: "Tensions" },
  length_change: { name: "Length change", of: "edge", scale: mm },
  turns: { name: "Turns", scale: { unit: "times the given strokes", factor: 1 } },
  actuator_std: { name: "Excess actuator std", scale: mm },
  epoch: { name: "Epoch", scale: timesChance },
  repeated_survey: { name: "Repeated survey", scale: timesChance },
  net_balance: { name: "Net out of balance", of: "node", scale: { unit: "times the mean tension", factor: 1 } },
  sag: { name: "Sag of cables", of: "edge", scale: mm },
  other: { name: "Finding" },
};

/** "5.10 ± 0.40 mm"; nothing where the kind has no value. */
function valueWords({ kind, value, std }: Finding): string {
  const { scale } = kinds[kind] ?? kinds.other;
  if (!scale || value === null) return "";
  return `${scale.before ?? ""}${number(scale.factor * value)}${std ? ` ± ${number(scale.factor * std, 2)}` : ""} ${scale.unit}`;
}

const mostIds = 8;
const idWords = (ids: string[]): string => ids.slice(0, mostIds).join(", ") + (ids.length > mostIds ? ` and ${ids.length - mostIds} more` : "");

const optionOf = ({ remedy }: Finding): string => (remedy ? `--${remedy.parameter} ${remedy.value}`.trim() : "");
const adviceOf = (finding: Finding): string => `${finding.next} ${optionOf(finding)}`.trim();

/** Names of a finding, each a button that brings it into sight. */
function idButtons({ kind, ids }: Finding, show: ShowItem): (HTMLElement | string)[] {
  const { of } = kinds[kind] ?? kinds.other;
  return ids.slice(0, mostIds).flatMap((id, i) => {
    const onclick = of && show(of, id);
    return [i > 0 ? ", " : " ", onclick ? h("button", { type: "button", class: "link", title: "Show it in the net", onclick }, id) : id];
  }).concat(ids.length > mostIds ? [` and ${ids.length - mostIds} more`] : []);
}

/** One finding: severity, kind, ids and value; then why, and what to do about it. @param withAdvice whether the next one does not give the same */
function findingItem(finding: Finding, withAdvice: boolean, show: ShowItem): HTMLElement {
  const { kind, severity, confounded_with } = finding;
  const { name } = kinds[kind] ?? kinds.other;
  const value = valueWords(finding);
  const option = optionOf(finding);
  return h("li", { "data-kind": kind },
    h("div", {}, h("span", { class: `tag ${severity}` }, severity === "passed" ? "note" : severity), " ", h("strong", {}, name, ...idButtons(finding, show)), value ? `: ${value}` : ""),
    h("div", {}, finding.reason),
    confounded_with.length > 0 ? h("div", { class: "quiet" }, `Confounded with ${idWords(confounded_with)}.`) : null,
    withAdvice && adviceOf(finding) ? h("div", { class: "next" }, finding.next, option ? " " : "", option ? h("code", {}, option) : null) : null);
}

/** No more than six of one kind. */
const firstOfEachKind = (findings: Finding[]): Finding[] =>
  findings.filter(({ kind }, i) => findings.slice(0, i).filter((other) => other.kind === kind).length < 6);

function findingList(findings: Finding[], show: ShowItem): HTMLElement[] {
  if (findings.length === 0) return [];
  const shown = firstOfEachKind(findings);
  const hidden = findings.length - shown.length;
  return [
    h("ul", { class: "findings", "aria-label": "Findings" }, ...shown.map((finding, i) => findingItem(finding, shown[i + 1] === undefined || adviceOf(shown[i + 1]!) !== adviceOf(finding), show))),
    ...(hidden > 0 ? [h("p", { class: "quiet" }, `${hidden} more findings of these kinds are in the result file.`)] : []),
  ];
}

/** What passed checks mean: the smallest error of each kind that they would have found. */
function smallestErrorWords(found: Detectable | undefined): string {
  if (!found) return "";
  const entry = (name: string, error: number | null, unit: string, factor = 1): [string, string] =>
    [name, error === null ? "" : `${short(Number((factor * error).toPrecision(2)))} ${unit}`];
  const all = [
    entry("length", found.length, "mm", 1e3), entry("turnbuckle", found.adjustable, "mm", 1e3), entry("support", found.support, "mm", 1e3),
    entry("target", found.target, "mm", 1e3), entry("scale", found.scale, "ppm", 1e6), entry("temperature", found.temperature, "K"),
    ...(found.load === undefined ? [] : [entry("load at each node", found.load, "N")]),
    ...(found.force ? [entry("one force", found.force, "%", 1e2)] : []),
    ...(found.force_scale ? [entry("all forces", found.force_scale, "%", 1e2)] : []),
  ];
  const [shown, never] = [all.filter(([, size]) => size), all.filter(([, size]) => !size).map(([name]) => name)];
  return (shown.length > 0 ? `Smallest error this survey would show (with a probability of 80 %): ${shown.map(([name, size]) => `${name} ${size}`).join(", ")}.` : "") +
    (never.length > 0 ? ` It would show no error of: ${never.join(", ")}.` : "");
}

/** The uncertain parameters, and those of them that the survey does not show. */
function uncertainWords(assumed: Assumption[] = []): string {
  if (assumed.length === 0) return "";
  const hidden = assumed.filter((one) => !one.testable).map((one) => one.value).join(", ");
  return `Uncertain besides the lengths: ${assumed.map((one) => one.value + (one.source === "default" ? " (assumed)" : "")).join(", ")}.` +
    (hidden ? ` The survey does not show ${hidden}: intervals depend on these values. ` : " ");
}

/** The verdict of all checks, what they found, and what they would not have found. */
export function checksBox(result: Result, show: ShowItem): HTMLElement | null {
  if (!("trust" in result) || !result.trust) return null;
  const { verdict, reasons = [] } = result.trust;
  const found = "findings" in result ? result.findings : undefined;
  const smallest = "detectable" in result ? smallestErrorWords(result.detectable) : "";
  const uncertain = "assumptions" in result ? uncertainWords(result.assumptions) : "";
  const smallestPart = smallest ? h("span", { id: "detectable" }, smallest) : null;
  const isFirst = verdict === "passed";
  return h("div", { class: `trust ${verdict}` },
    h("p", {}, h("strong", {}, `Checks: ${verdict}.`), ...(isFirst ? [" ", smallestPart] : [])),
    // Before version 0.3 a result had reasons, but no findings.
    ...(found ? findingList(found, show) : reasons.map((reason) => h("p", {}, `${reason}.`))),
    !isFirst && smallestPart ? h("p", {}, smallestPart) : null,
    uncertain ? h("p", { id: "assumptions", class: "quiet" }, uncertain, "Other widths are given as uncertain parameters (", h("code", {}, "--uncertain NAME:WIDTH"), ").") : null);
}
