// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import * as Plot from "@observablehq/plot";
import { dots, type Figure, lines, type View } from "./chart";
import { around, dotWidth, edgeChart } from "./edge_chart";
import { millimetres, number } from "./format";
import { ink } from "./inks";
import type { Model } from "./model";
import { netFigure, nodeMap, planThinning, type Side, sideOf } from "./net_map";
import type { Study } from "./result";
import { mostAlong, thinningWords } from "./thinning";

/** More dots make the chart slow and no clearer. */
const mostDots = 30_000;

const inMm = (metres: readonly number[]): number[] => metres.map((value) => 1e3 * value);
const meanOf = (values: readonly number[]): number => values.reduce((sum, v) => sum + v, 0) / values.length;
/** Not Math.max(...values): there may be too many for one call. */
const largestOf = (values: readonly number[]): number => values.reduce((most, v) => Math.max(most, Math.abs(v)), 0);

/** True, identified and error over the interior edges for the first validation sample (the paper's figure errorplot_q1). */
function deviationFigure(study: Study, model: Model): Figure {
  const [truth, estimate] = [inMm(study.sample.true), inMm(study.sample.identified)];
  const error = truth.map((t, i) => t - estimate[i]!);
  const count = truth.length;
  return {
    heading: "Length deviations: true, identified, error",
    charts: [edgeChart({
      name: "length_deviations", title: "True and identified length deviations of the interior edges", yLabel: "length deviation [mm]",
      range: around(truth, estimate, error),
      legend: [{ words: "true", ink: "amber" }, { words: "identified", ink: "deep" }, { words: "error: true minus identified", ink: "magenta" }],
      marks(edges, view) {
        const of = (values: number[]) => edges.map((i): [number, number] => [i + 1, values[i]!]);
        const width = (size: number) => dotWidth(edges.length, size);
        return [
          lines(edges.map((i) => [i + 1, truth[i]!, i + 1, estimate[i]!] as const), ink("grey"), 0.8),
          dots(of(truth), ink("amber"), width(5.4), view), dots(of(estimate), ink("deep"), width(2.4), view), dots(of(error), ink("magenta"), width(2.6), view),
        ];
      },
    }, model)],
    caption: `True and identified length deviation of ${count === 1 ? "the interior edge" : `the ${count} interior edges`} for the first validation sample, ` +
      `and the error between them: max ${number(largestOf(error))} mm.${thinningWords([[count, mostAlong, "edge"]])}`,
  };
}

/** All errors e_i(k) with mean and standard deviation over the interior edges (the paper's figure boxplot). */
function errorFigure(study: Study, model: Model): Figure {
  const [mean, std] = [inMm(study.errors.mean), inMm(study.errors.std)];
  const all = (study.errors.all ?? []).map(inMm);
  const above = mean.map((m, i) => m + std[i]!);
  const below = mean.map((m, i) => m - std[i]!);
  const { validation } = study.samples;
  const most = Math.min(Math.max(Math.floor(mostDots / Math.max(all.length > 0 ? validation : 1, 1)), 1), mostAlong);
  const worst = mean.reduce((best, m, i) => (Math.abs(m) > Math.abs(mean[best]!) ? i : best), 0);
  /** Extended a little at both ends, so that a single edge shows as a dash. */
  const curve = (edges: readonly number[], values: number[]): [number, number][] => {
    if (edges.length === 0) return [];
    const [first, last] = [edges[0]!, edges.at(-1)!];
    return [[first + 0.6, values[first]!], ...edges.map((i): [number, number] => [i + 1, values[i]!]), [last + 1.4, values[last]!]];
  };
  const line = (points: [number, number][], stroke: string, strokeWidth: number): Plot.Markish => Plot.line(points, { stroke, strokeWidth, clip: true });
  return {
    heading: "Errors over all validation samples",
    charts: [edgeChart({
      name: "length_errors", title: "Errors of the identified lengths over the interior edges", yLabel: "error [mm]", most,
      range: around(above, below, ...all),
      legend: [
        ...(all.length > 0 ? [{ words: "error in one sample", ink: "dim" } as const] : []),
        { words: "mean", ink: "blue", mark: "line" }, { words: "mean ± standard deviation", ink: "orange", mark: "line" },
      ],
      marks(edges, view: View) {
        function* points(): Iterable<[number, number]> {
          for (const i of edges) for (const error of all[i] ?? []) yield [i + 1, error];
        }
        const width = Math.min(Math.max(150 / Math.sqrt(edges.length * Math.max(validation, 1)), 1.5), 5);
        return [
          dots(points(), ink("dim"), width, view),
          line(curve(edges, above), ink("orange"), 1.2), line(curve(edges, below), ink("orange"), 1.2), line(curve(edges, mean), ink("blue"), 1.6),
        ];
      },
    }, model)],
    caption: `Error (true minus identified) of every interior edge in ${validation === 1 ? "the one validation sample" : `all ${validation} validation samples`}, with mean and mean ± one standard deviation ` +
      `over the samples. The largest mean error is ${number(Math.abs(mean[worst]!))} mm, at edge ${model.edgeId(model.charted[worst]!)} (i = ${worst + 1}); ` +
      `the mean standard deviation of an edge is ${number(meanOf(std))} mm.${thinningWords([[mean.length, most, "edge"]])}`,
  };
}

/** Nominal and identified form error of the first validation sample in plan, on one scale (the paper's figure deviations). */
function formErrorFigure(study: Study, model: Model, side: Side): Figure {
  const { nominal, identified } = study.sample.form_error;
  const nodes = Array.from(model.isFixed, (fixed, i) => (fixed ? -1 : i)).filter((i) => i >= 0);
  const largest = 1e3 * Math.max(largestOf(nominal), largestOf(identified));
  const chart = (which: string, errors: number[]) => nodeMap({
    name: `form_error_${which}`, title: `The ${which} form error at the free nodes, in plan`, heading: `${which} form error [mm]`,
    nodes, values: inMm(errors), largest,
  }, model, side);
  const ratio = meanOf(nominal) / meanOf(identified);
  const change = Number.isFinite(ratio) && ratio > 0
    ? ` Identification makes the mean form error ${number(ratio >= 1 ? ratio : 1 / ratio)} times ${ratio >= 1 ? "smaller" : "larger"}.` : "";
  return {
    heading: "Form error over the net", charts: [chart("nominal", nominal), chart("identified", identified)],
    caption: `Distance of the nominal form (mean ${millimetres(meanOf(nominal))} mm) and of the form with the identified lengths (mean ${millimetres(meanOf(identified))} mm) ` +
      `from the true form at the free nodes, for the first validation sample. Both have the same view and the same colour scale.${change}${planThinning(model)}`,
  };
}

export function studyFigures(study: Study, model: Model): Figure[] {
  const side = sideOf(model.form);
  return [netFigure(model, side, "nominal"), deviationFigure(study, model), errorFigure(study, model), formErrorFigure(study, model, side)];
}
