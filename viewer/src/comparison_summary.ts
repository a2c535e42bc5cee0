// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { counted, number, percent, short } from "./format";
import type { Comparison, ComparisonRow } from "./result";
import { nameOf, netWords, type Summary } from "./summary_words";

/** "map 95.0 to 95.3 %". */
function coverageWords(method: string, rows: ComparisonRow[]): string {
  const covered = rows.filter((r) => r.method === method && typeof r.coverage === "number").map((r) => percent(r.coverage));
  if (covered.length === 0) return "";
  const [least, most] = [Math.min(...covered.map(Number)), Math.max(...covered.map(Number))];
  return `${method} ${least === most ? "" : `${short(least)} to `}${short(most)} %`;
}

/** The method with the least error at a standard deviation of the survey [m], of surveys of all nodes. */
function bestWords(rows: ComparisonRow[], noise: number): string {
  const at = `With a standard deviation of ${short(1e3 * noise)} mm per coordinate`;
  const mm = (mse: number): string => `${number(1e3 * Math.sqrt(mse))} mm`;
  const best = rows.filter((r) => r.noise === noise && !((r.hidden_fraction ?? 0) > 0)).sort((a, b) => a.mse! - b.mse!)[0];
  if (!best) return `${at} no method gave a result.`;
  const bound = best.cramer_rao_mse;
  return `${at}, ${best.method} has the smallest error of a length: ${mm(best.mse!)} (RMS)${bound ? `; the Cramér-Rao bound is ${mm(bound)}` : ""}.`;
}

export function ofComparison({ net, rows: all }: Comparison): Summary {
  const rows = all.filter((r) => typeof r.mse === "number");
  const methods = [...new Set(all.map((r) => r.method))];
  const noises = [...new Set(all.map((r) => r.noise))].sort((a, b) => a - b);
  // Without noise an interval is as wide as numerical errors are, and always covers.
  const covered = methods.map((method) => coverageWords(method, rows.filter((r) => r.noise > 0))).filter(Boolean);
  return {
    title: "Error of each method",
    done: `${counted(methods.length, "method")} (${methods.join(", ")}) compared on the net ${nameOf(net)}${netWords(net) ? `: ${netWords(net)}` : ""}.`,
    sentences: [
      ...new Set([noises[0]!, noises.at(-1)!].map((noise) => bestWords(rows, noise))),
      covered.length > 0
        ? `True lengths in their 95 % intervals, of surveys with noise: ${covered.join(", ")}.`
        : `${counted(methods.length, "method")} were compared for ${counted(noises.length, "standard deviation")} of the survey.`,
    ],
    figures: [],
  };
}
