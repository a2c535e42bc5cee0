// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { ofControl } from "./control_summary";
import { h } from "./dom";
import { counted, millimetres, number, percent, rootMeanSquare, short } from "./format";
import { ofPlan, planLines } from "./plan_summary";
import type { Findings } from "./result_schema";
import {
  type Comparison, type ComparisonRow, controlOf, type Counts, type Identification, type IdentifiedEdge, isNotDetermined, isSlack, lengthOf, methodsOf, type Result, statusNow, type Study,
} from "./result";

/** What the top of the page says: a title, what was done, three sentences, some numbers. */
export interface Summary {
  title: string;
  done: string;
  sentences: string[];
  figures: { value: string; unit: string; label: string }[];
}

export const nameOf = (net: Counts): string => (net.name ? `“${net.name}”` : "the net");

export function netWords(net: Counts): string {
  return [
    [net.free_nodes, "free node"], [net.supports, "support"],
    [net.interior_edges, "interior edge"], [net.adjustable_edges, "adjustable edge"],
  ].filter(([count]) => typeof count === "number")
    .map(([count, noun]) => counted(count as number, noun as string)).join(", ");
}

export function lawWords(law = ""): string {
  const [kind, size = ""] = law.split(":");
  const scale = size.replace(/([\d.])([a-z])/, "$1 $2");
  if (kind === "uniform") return `anywhere within ±${scale}`;
  if (kind === "normal") return `by a normal law with a standard deviation of ${scale}`;
  if (kind === "bimodal") return `by close to −${scale} or +${scale}`;
  return law ? `by the law ${law}` : "at random";
}

/** "17 times smaller". */
function times(before: number, after: number): string {
  if (!(before > 0) || !(after > 0)) return "";
  const [ratio, word] = before >= after ? [before / after, "smaller"] : [after / before, "larger"];
  return `${short(Number(ratio.toPrecision(2)))} times ${word}`;
}

function ofStudy(study: Study): Summary {
  const [name, method] = methodsOf(study)[0]!;
  const error = 1e3 * Math.sqrt(method.mse ?? NaN);
  const { nominal, identified } = study.form_error;
  const ratio = times(nominal.mean, identified.mean);
  return {
    title: "How long the cables really are, told from the form",
    done:
      `A numerical experiment on the net ${nameOf(study.net)}: ${netWords(study.net)}. Its interior cables were made too long or too short ` +
      `${lawWords(study.prior)}, ${counted(study.samples.total, "time")}; Gaussian processes learnt from ${study.samples.training} of these forms ` +
      `to tell the lengths, and were tried on ${study.samples.validation} that they had not seen.`,
    sentences: [
      `From the form alone, each cable's unstressed length is told to within ${number(error)} mm (root mean square over all cables and trials), where it was unknown ${lawWords(study.prior)}: ${percent(method.mrse)} % of the squared deviation is left.`,
      `A model with the identified lengths predicts the net's true form to ${millimetres(identified.mean)} mm in the mean (${millimetres(identified.max)} mm at most); with the lengths as designed it is ${millimetres(nominal.mean)} mm off${ratio ? `. The error is ${ratio}` : ""}.`,
      method.coverage_95 == null
        ? `The worst cable's error is ${millimetres(method.error_mean_max_abs)} mm in the mean of the trials.`
        : `${method.coverage_95 > 0.9 ? "The stated uncertainty holds" : "The stated uncertainty is too small"}: ${percent(method.coverage_95)} % of the true lengths lie inside their 95 % interval.` +
          (study.samples.with_slack > 0 ? ` In ${counted(study.samples.with_slack, "sample")} of ${study.samples.total} some cable went slack, whose length the form does not show.` : ""),
    ],
    figures: [
      { value: number(error), unit: "mm", label: "error of a length, RMS" },
      { value: percent(method.mrse), unit: "%", label: "of the deviation left (MRSE)" },
      { value: millimetres(nominal.mean), unit: "mm", label: "form error as designed, mean" },
      { value: millimetres(identified.mean), unit: "mm", label: "form error as identified, mean" },
      { value: percent(method.coverage_95), unit: "%", label: `inside 95 % intervals (${name === "gp_as_in_paper" ? "method as in the paper" : name})` },
    ],
  };
}

const methodNames: Record<string, string> = {
  gp: "Gaussian processes", gp_as_in_paper: "Gaussian processes as in the paper",
  balance: "the balance of forces", map: "maximum a posteriori estimation",
};

function warnings(result: Identification): string {
  const slack = result.edges.filter(isSlack).length;
  const open = result.edges.filter(isNotDetermined).length;
  const { outliers, missing, unmatched = [] } = result.survey;
  const found = [
    slack && `${counted(slack, "slack cable")}, of which only a lower bound of the length is known`,
    open && `${counted(open, "cable")} that the survey does not determine`,
    outliers.length && counted(outliers.length, "gross error"),
    missing && counted(missing, "node") + " not surveyed",
    unmatched.length && counted(unmatched.length, "target") + " that fit no node",
  ].filter(Boolean);
  return found.length > 0
    ? `To look at: ${found.join("; ")}.`
    : "No cable is slack, the survey tells about every cable, and the survey shows no gross error and no hidden node.";
}

/** Median half width of the 95 % intervals [m]. */
function medianHalfWidth(edges: IdentifiedEdge[]): number {
  const halves = edges.map((e) => (e.upper - e.lower) / 2).sort((a, b) => a - b);
  return halves[Math.floor(halves.length / 2)] ?? NaN;
}

/** The cable that deviates most, of those that are not slack. */
function longestWords(result: Identification, tense: IdentifiedEdge[]): string {
  if (tense.length === 0) return "";
  const longest = tense.reduce((a, b) => (Math.abs(b.length_deviation) > Math.abs(a.length_deviation) ? b : a));
  const id = result.cable_net.edge_ids?.[longest.edge] ?? String(longest.edge);
  const among = tense.length < result.edges.length ? "of those that are not slack, " : "";
  return `; ${among}the cable ${id} deviates most: ${millimetres(Math.abs(longest.length_deviation))} mm ${longest.length_deviation >= 0 ? "longer" : "shorter"} than designed`;
}

/** How far the model's form is from the survey, and over which targets: the figure tells the same. */
function fitWords({ survey }: Identification): string {
  const left = new Set(survey.outliers.map((o) => o.node));
  const away = (survey.residuals ?? []).filter((r) => left.has(r.node)).map(lengthOf);
  const over = left.size === 0 ? "" : `, over the ${counted(survey.used - left.size, "target")} in use`;
  const apart = away.length === 0 ? "" : `; the ${away.length} left out for gross errors ${away.length === 1 ? "is" : "are up to"} ${millimetres(Math.max(...away))} mm away`;
  return `With these lengths the model's form lies ${millimetres(survey.rms_residual)} mm (RMS) from the surveyed one, at most ${millimetres(survey.max_residual)} mm${over}${apart}.` +
    ratioWords(survey.noise_ratio);
}

function ratioWords(ratio = 0): string {
  return ratio > 0 ? ` The survey's residuals are ${number(ratio)} times what its noise lets expect.` : "";
}

/** How tight the cables are, as far as the draws tell; none without draws. */
function tensionWords(result: Identification): string {
  const { mean_tension, draws } = result;
  if (draws?.reason) return ` How tight the cables are is not told: ${draws.reason}.`;
  if (!mean_tension) return "";
  const kN = (newton: number): string => number(newton / 1e3);
  return ` The cables carry ${kN(mean_tension.mean)} kN in the mean, between ${kN(mean_tension.lower)} and ${kN(mean_tension.upper)} kN with 95 %${asGivenWords(result)}.`;
}

/** What the tensions rest on that nobody told to be unknown. */
function asGivenWords({ uncertain = [] }: Identification): string {
  const told = ["stiffness", "loads", "supports"].filter((name) => !uncertain.some((one) => one.name === name));
  if (told.length === 0) return "";
  const list = told.length === 1 ? told[0] : `${told.slice(0, -1).join(", ")} and ${told[told.length - 1]}`;
  return `, where ${list} are as given`;
}

/** Readings that were left out, and what was seen that the survey contradicts. */
function forceWords({ forces }: Identification): string {
  if (!forces) return "";
  const out = forces.outliers.length;
  const bias = forces.bias ? `: together they contradict the survey, which asks for ${number(1 - forces.bias.part)} times what was read` : "";
  const readings = out > 0 ? ` ${out} of ${counted(forces.measurements, "reading")} of forces ${out === 1 ? "is" : "are"} left out${bias}.` : "";
  const seen = (forces.contradicted_taut?.length ?? 0) + (forces.contradicted_slack?.length ?? 0);
  return readings + (seen > 0 ? " What was seen of taut and slack cables contradicts the survey, and is not used." : "");
}

function frameWords(result: Identification): string {
  const control = controlOf(result);
  return control.length > 0
    ? ` It was moved into the net's frame by ${counted(control.length, "control point")}, which fit to ${millimetres(rootMeanSquare(control.map(lengthOf)))} mm (RMS).`
    : "";
}

/** What a passed check means: the smallest error of each kind that it would have found. */
function detectableWords(result: Result): string {
  const found = "detectable" in result ? result.detectable : undefined;
  if (!found) return "";
  const length = (name: string, error: number | null): string => `${name} ${error === null ? "none" : `${short(Number((1e3 * error).toPrecision(2)))} mm`}`;
  const { scale, temperature } = found;
  return [
    length("target", found.target), length("length", found.length), length("adjustable edge", found.adjustable), length("support", found.support),
    `scale ${scale === null ? "none" : `${short(Number((1e6 * scale).toPrecision(2)))} ppm`}`,
    `temperature ${temperature === null ? "none" : `${short(Number(temperature.toPrecision(2)))} K`}`,
  ].join(", ");
}

/** What was taken as uncertain besides lengths, and which of it the survey does not show. */
function assumptionWords(result: Result): string {
  const assumed = ("assumptions" in result ? result.assumptions : undefined) ?? [];
  const values = (of: typeof assumed): string => of.map((one) => one.value + (one.source === "default" ? " (assumed)" : "")).join(", ");
  const hidden = assumed.filter((one) => !one.testable).map((one) => one.value).join(", ");
  return assumed.length === 0 ? "" : `Uncertain besides lengths: ${values(assumed)}.${hidden ? ` The survey does not show ${hidden}: intervals rest on that.` : ""}`;
}

/** No more than six of one kind. */
function firstOfEachKind(findings: Findings = []): Findings {
  return findings.filter(({ kind }, i) => findings.slice(0, i).filter((other) => other.kind === kind).length < 6);
}

/** May one act on it: the verdict of all checks, and what they found. */
function trustLines(result: Result): HTMLElement | null {
  const trust = "trust" in result ? result.trust : undefined;
  if (!trust) return null;
  const found = "findings" in result ? result.findings : undefined;
  const more = (found?.length ?? 0) - firstOfEachKind(found).length;
  const optionOf = ({ remedy }: Findings[number]): string =>
    remedy ? `--${remedy.parameter} ${remedy.value}`.trim() : "";
  const adviceOf = (finding: Findings[number]): string => `${finding.next} ${optionOf(finding)}`.trim();
  return h("div", { class: `trust ${trust.verdict}` },
    h("p", {}, h("strong", {}, `Checks: ${trust.verdict}`)),
    // Versions before 0.3 wrote reasons alone.
    ...(found ? [] : trust.reasons ?? []).map((reason) => h("p", {}, `${reason}.`)),
    ...firstOfEachKind(found).map((finding, i, all) => {
      const next = all[i + 1];
      const isSaidNext = next !== undefined && adviceOf(next) === adviceOf(finding);
      const option = finding.remedy ? [" ", h("code", {}, optionOf(finding))] : [];
      return h("p", {}, h("strong", {}, `${finding.severity === "passed" ? "note" : finding.severity}: `), finding.reason,
        finding.next && !isSaidNext ? h("small", {}, ` ${finding.next}`, ...option) : "");
    }),
    ...(more > 0 ? [h("p", {}, `${more} more findings of these kinds are in the result.`)] : []),
    ...(detectableWords(result) ? [h("p", { id: "detectable" }, h("small", {}, `Smallest error that these checks find with a probability of 80 %: ${detectableWords(result)}.`))] : []),
    ...(assumptionWords(result) ? [h("p", { id: "assumptions" }, h("small", {}, assumptionWords(result)))] : []));
}

function ofIdentification(result: Identification): Summary {
  const { edges, survey } = result;
  const tense = edges.filter((e) => !isSlack(e));
  const determined = edges.filter((e) => statusNow(e) === "determined");
  const median = `±${millimetres(medianHalfWidth(tense))}`;
  const noise = result.noise === undefined ? "" : ` The survey's noise was taken as ${short(1e3 * result.noise)} mm a coordinate.`;
  const law = result.length_prior ? `, for cables made too long or too short ${lawWords(result.length_prior)}` : "";
  const notSlack = tense.length < edges.length ? ", slack cables apart" : "";
  return {
    title: "How long each cable is, from one survey",
    done:
      `One survey of the net ${nameOf(result.net)}: ${netWords(result.net)}; ${counted(survey.used, "free node")} surveyed.${frameWords(result)} ` +
      `The lengths were identified by ${methodNames[result.method] ?? result.method}${result.method_reason ? ` (${result.method_reason})` : ""}${law}.${noise}`,
    sentences: [
      `${determined.length} of ${counted(edges.length, "interior cable")} are determined${tense.length > 0 ? `; 95 % intervals are ${median} mm (median${notSlack})` : ""}${longestWords(result, tense)}.${tensionWords(result)}`,
      fitWords(result) + forceWords(result),
      warnings(result),
    ],
    figures: [
      { value: `${determined.length} / ${edges.length}`, unit: "", label: "cables determined" },
      { value: millimetres(rootMeanSquare(tense.map((e) => e.length_deviation))), unit: "mm", label: `length deviation, RMS${notSlack}` },
      { value: median, unit: "mm", label: `95 % interval, median${notSlack}` },
      { value: millimetres(survey.rms_residual), unit: "mm", label: "predicted to surveyed, RMS" },
      ...(survey.noise_ratio ? [{ value: number(survey.noise_ratio), unit: "", label: "residuals, over what the noise lets expect" }] : []),
      { value: String(survey.outliers.length), unit: "", label: "gross errors, left out" },
    ],
  };
}

/** "map 95.0 to 95.3 %". */
function coverageWords(method: string, rows: ComparisonRow[]): string {
  const covered = rows.filter((r) => r.method === method && typeof r.coverage === "number").map((r) => percent(r.coverage));
  if (covered.length === 0) return "";
  const [least, most] = [Math.min(...covered.map(Number)), Math.max(...covered.map(Number))];
  return `${method} ${least === most ? "" : `${short(least)} to `}${short(most)} %`;
}

function ofComparison(comparison: Comparison): Summary {
  const rows = comparison.rows.filter((r) => typeof r.mse === "number");
  const methods = [...new Set(comparison.rows.map((r) => r.method))];
  const noises = [...new Set(comparison.rows.map((r) => r.noise))].sort((a, b) => a - b);
  const mm = (mse: number): string => `${number(1e3 * Math.sqrt(mse))} mm`;
  const best = (noise: number): ComparisonRow | undefined =>
    rows.filter((r) => r.noise === noise && !((r.hidden_fraction ?? 0) > 0)).sort((a, b) => a.mse! - b.mse!)[0];
  const at = (noise: number): string => {
    const row = best(noise);
    if (!row) return `At a noise of ${short(1e3 * noise)} mm no method gave a result.`;
    const possible = row.best_possible_mse;
    return `At a noise of ${short(1e3 * noise)} mm a coordinate, ${row.method} does best: ${mm(row.mse!)} a length (RMS)` +
      (possible ? `, where the best possible is ${mm(possible)}.` : ".");
  };
  // Without noise an interval is as wide as the reckoning is exact, and holds all.
  const covered = methods.map((method) => coverageWords(method, rows.filter((r) => r.noise > 0))).filter(Boolean);
  const sentences = [at(noises[0]!)];
  if (noises.length > 1) sentences.push(at(noises.at(-1)!));
  sentences.push(covered.length > 0
    ? `Of the true lengths lie inside the stated 95 % intervals, where there is noise: ${covered.join(", ")}.`
    : `${counted(methods.length, "method")} were compared at ${counted(noises.length, "noise level")}.`);
  return {
    title: "Which method tells the lengths best",
    done: `${counted(methods.length, "method")} (${methods.join(", ")}) compared on the net ${nameOf(comparison.net)}${netWords(comparison.net) ? `: ${netWords(comparison.net)}` : ""}.`,
    sentences,
    figures: [],
  };
}

function summaryOf(result: Result): Summary {
  if (result.format === "taut-study") return ofStudy(result);
  if (result.format === "taut-plan") return ofPlan(result);
  if (result.format === "taut-control") return ofControl(result);
  return result.format === "taut-identification" ? ofIdentification(result) : ofComparison(result);
}

/** The top of the page, for who reads nothing else. */
export function summary(result: Result): HTMLElement {
  const { title, done, sentences, figures } = summaryOf(result);
  document.title = `${result.net.name || "A net"} – taut report`;
  const cards = figures.map(({ value, unit, label }) =>
    h("div", { class: "card" }, h("div", { class: "value" }, value, h("small", {}, unit ? ` ${unit}` : "")), h("div", { class: "label" }, label)));
  const provenance = [result.program, result.date, result.net.fingerprint && `net ${result.net.fingerprint}`].filter(Boolean).join(" · ");
  return h("header", {},
    h("div", { class: "brand" }, h("span", { class: "logo", "aria-hidden": "true" }), h("span", {}, "taut report"), h("span", { class: "quiet provenance" }, provenance)),
    h("h1", {}, result.net.name || "A net", h("small", {}, title)),
    ...(result.format === "taut-plan" ? planLines(result) : [trustLines(result)]),
    h("p", { class: "done" }, done),
    h("ol", { class: "sentences", "aria-label": "What matters" }, ...sentences.map((text) => h("li", {}, text))),
    cards.length > 0 ? h("div", { class: "cards" }, ...cards) : null);
}
