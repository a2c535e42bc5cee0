// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { counted, excludedTargets, fixed, millimetres, number, rootMeanSquare, short } from "./format";
import { controlOf, type Identification, type IdentifiedEdge, isElastic, isNotDetermined, isSlack, leftOut, lengthOf, statusOf } from "./result";
import { ellipseWords, nameOf, netWords, priorWords, type Summary } from "./summary_words";

const methodNames: Record<string, string> = {
  gp: "Gaussian processes", gp_as_in_paper: "Gaussian processes as in the paper",
  balance: "the balance of forces", map: "maximum a posteriori estimation",
};

function attentionWords(result: Identification): string {
  const slack = result.edges.filter(isSlack).length;
  const open = result.edges.filter(isNotDetermined).length;
  const { outliers, missing, unmatched = [] } = result.survey;
  const found = [
    slack && `${counted(slack, "slack cable")} (lower bound only)`,
    open && `${counted(open, "cable")} not determined by the survey`,
    outliers.length && counted(outliers.length, "gross error"),
    missing && counted(missing, "node") + " not surveyed",
    unmatched.length && counted(unmatched.length, "target") + " without a node",
  ].filter(Boolean);
  return found.length > 0
    ? `Needs attention: ${found.join("; ")}.`
    : "No cable is slack, the survey covers every node and every cable, and it shows no gross error.";
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
  const among = tense.length < result.edges.length ? ", of those that are not slack" : "";
  return ` Cable ${id} deviates most${among}: ${millimetres(Math.abs(longest.length_deviation))} mm ${longest.length_deviation >= 0 ? "longer" : "shorter"} than designed.`;
}

/** Distance of the predicted form from the survey, over the same targets as the caption of its figure. */
function fitWords(result: Identification): string {
  const { survey } = result;
  const left = new Set(survey.outliers.map((o) => o.node));
  const away = (survey.residuals ?? []).filter((r) => left.has(r.node)).map(lengthOf);
  const over = left.size === 0 ? "" : `, over the ${counted(survey.used - left.size, "target")} in use`;
  const apart = away.length === 0 ? "" : ` ${excludedTargets(away.length)}, up to ${millimetres(Math.max(...away))} mm away.`;
  return `The form predicted with these lengths is ${millimetres(survey.rms_residual)} mm (RMS) from the surveyed one, max ${millimetres(survey.max_residual)} mm${over}.${apart}` +
    ellipseWords(result.cable_net, result.form_covariance, "predicted");
}

/** The global test: what the survey's residuals show of its standard deviation, over the one given. */
function varianceFactor({ survey, diagnostics }: Identification): { factor: number; expected: string; words: string } | null {
  const { ratio = 0, std = 0 } = diagnostics?.noise ?? {};
  const isTested = ratio > 0 && std > 0;
  const factor = isTested ? ratio : (survey.noise_ratio ?? 0);
  if (!(factor > 0)) return null;
  if (!isTested) return { factor, expected: "", words: "" };
  const [low, high] = [Math.max(1 - 1.96 * std, 0), 1 + 1.96 * std];
  return { factor, expected: ` (expected ${fixed(low, 2)} to ${fixed(high, 2)})`, words: factor > high ? "more than" : factor < low ? "less than" : "as expected from" };
}

function varianceWords(result: Identification): string {
  const found = varianceFactor(result);
  if (!found) return "";
  const given = result.noise === undefined ? "standard deviation" : `standard deviation of ${short(1e3 * result.noise)} mm`;
  return ` Variance factor ${fixed(found.factor, 2)}${found.expected}${found.words ? `: the survey scatters ${found.words} its ${given}` : ""}.`;
}

/** Tensions by the posterior samples, or why there are none; nothing without samples. */
function tensionWords(result: Identification): string {
  const { mean_tension, draws } = result;
  if (draws?.reason) return ` Tensions are not reported: ${draws.reason.replace(/\.$/, "")}.`;
  if (!mean_tension) return "";
  const kN = (newton: number): string => number(newton / 1e3);
  return ` The mean tension is ${kN(mean_tension.mean)} kN (95 %: ${kN(mean_tension.lower)} to ${kN(mean_tension.upper)} kN)${assumedWords(result)}.`;
}

/** What tensions depend on and is no uncertain parameter. */
function assumedWords({ cable_net, uncertain = [] }: Identification): string {
  const hasLoads = cable_net.loads?.some((load) => load.some((force) => force !== 0)) || ("mass" in cable_net && !uncertain.some((one) => one.name === "mass"));
  const names = ["stiffness", ...(hasLoads ? ["loads"] : []), "supports", ...(cable_net.supports.some((_, i) => isElastic(cable_net, i)) ? ["support-stiffness"] : [])];
  const exact = names.filter((name) => !uncertain.some((one) => one.name === name));
  if (exact.length === 0) return "";
  return `, if ${exact.length === 1 ? exact[0] : `${exact.slice(0, -1).join(", ")} and ${exact.at(-1)}`} are as designed`;
}

/** Force measurements that were excluded, and marks of slack and taut cables that the survey contradicts. */
function forceWords({ forces }: Identification): string {
  if (!forces) return "";
  const out = leftOut(forces.outliers);
  const bias = forces.bias && (forces.bias.probability ?? 1) > 0.95 ? `: the survey implies forces ${number(1 - forces.bias.part)} times the measured ones` : "";
  const measured = out > 0 ? ` ${out} of ${counted(forces.measurements, "force measurement")} ${out === 1 ? "is" : "are"} excluded${bias}.` : "";
  const marked = (forces.contradicted_taut?.length ?? 0) + (forces.contradicted_slack?.length ?? 0);
  return measured + (marked > 0 ? " The edges marked as slack or taut contradict the survey: taut ignored the marks." : "");
}

function frameWords(result: Identification): string {
  const control = controlOf(result);
  return control.length > 0
    ? ` It was transformed into the net's frame with ${counted(control.length, "control point")}, residual ${millimetres(rootMeanSquare(control.map(lengthOf)))} mm (RMS).`
    : "";
}

export function ofIdentification(result: Identification): Summary {
  const { edges, survey } = result;
  const tense = edges.filter((e) => !isSlack(e));
  const determined = edges.filter((e) => statusOf(e) === "determined").length;
  const median = `±${millimetres(medianHalfWidth(tense))}`;
  const noise = result.noise === undefined ? "" : ` The standard deviation of the survey (a priori) is ${short(1e3 * result.noise)} mm per coordinate.`;
  const prior = result.length_prior ? ` Prior: lengths deviate ${priorWords(result.length_prior)}.` : "";
  const notSlack = tense.length < edges.length ? ", without slack cables" : "";
  const factor = varianceFactor(result);
  const surveys = Math.max(1, result.epochs?.length ?? 0);
  return {
    title: `Unstressed length of each cable, from ${surveys === 1 ? "one survey" : counted(surveys, "survey")}`,
    done:
      `${surveys === 1 ? "One survey" : counted(surveys, "survey")} of the net ${nameOf(result.net)}: ${netWords(result.net)}; ${counted(survey.used, "free node")} surveyed${surveys === 1 ? "" : " in the last"}.${frameWords(result)} ` +
      `The lengths were identified by ${methodNames[result.method] ?? result.method}${result.method_reason ? ` (${result.method_reason})` : ""}.${prior}${noise}`,
    sentences: [
      `${determined} of ${counted(edges.length, "interior cable")} are determined${tense.length > 0 ? `; 95 % intervals are ${median} mm (median${notSlack})` : ""}.${longestWords(result, tense)}${tensionWords(result)}`,
      fitWords(result) + varianceWords(result) + forceWords(result),
      attentionWords(result),
    ],
    figures: [
      { value: `${determined} / ${edges.length}`, unit: "", label: "cables determined" },
      { value: millimetres(rootMeanSquare(tense.map((e) => e.length_deviation))), unit: "mm", label: `length deviation, RMS${notSlack}` },
      { value: median, unit: "mm", label: `95 % interval, median${notSlack}` },
      { value: millimetres(survey.rms_residual), unit: "mm", label: "predicted to surveyed, RMS" },
      ...(factor ? [{ value: fixed(factor.factor, 2), unit: "", label: `variance factor${factor.expected}` }] : []),
      { value: String(survey.outliers.length), unit: "", label: "gross errors, excluded" },
    ],
  };
}
