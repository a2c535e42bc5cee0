// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import * as Plot from "@observablehq/plot";
import { dots, type Figure, type LegendEntry, lines } from "./chart";
import { around, edgeChart } from "./edge_chart";
import { counted, excludedTargets, millimetres, number, rootMeanSquare } from "./format";
import { type Ink, ink } from "./inks";
import type { Model } from "./model";
import { netFigure, nodeMap, planThinning, type Side, sideOf } from "./net_map";
import { type Identification, isSlack, lengthOf, type Status, statusOf } from "./result";
import { mostAlong, thinningWords } from "./thinning";

const kinds: { status: Status; ink: Ink; words: string }[] = [
  { status: "determined", ink: "deep", words: "determined" },
  { status: "weakly_determined", ink: "green", words: "weakly determined" },
  { status: "not_determined", ink: "grey", words: "not determined" },
  { status: "slack", ink: "orange", words: "slack: lower bound" },
];

/** Length deviations with their 95 % intervals; the dot of a slack edge is at its lower bound. */
function intervalFigure({ edges: all }: Identification, model: Model): Figure {
  const count = all.length;
  const slack = all.filter(isSlack).length;
  const widest = all.reduce((most, e) => (isSlack(e) ? most : Math.max(most, e.upper - e.lower)), 0);
  const present = kinds.filter((kind) => all.some((e) => statusOf(e) === kind.status));
  const of = (key: "lower" | "upper" | "length_deviation"): number[] => all.map((e) => 1e3 * e[key]);
  const [lower, upper, deviation] = [of("lower"), of("upper"), of("length_deviation")];
  const parts = [
    slack < count && `Identified length less design length of ${counted(count - slack, "interior edge")}${slack > 0 ? " in tension" : ""}, with the 95 % interval; ` +
      `the widest is ±${millimetres(widest / 2)} mm.`,
    slack > 0 && `The dots of ${counted(slack, "slack edge")} are lower bounds.`,
  ].filter(Boolean);
  return {
    heading: "Length deviations with their intervals",
    charts: [edgeChart({
      name: "length_intervals", title: "Length deviations of the interior edges with their intervals", yLabel: "length deviation [mm]",
      range: around(lower, upper, deviation),
      legend: [{ words: "95 % interval", ink: "grey", mark: "line" }, ...present.map((kind): LegendEntry => ({ words: kind.words, ink: kind.ink }))],
      marks(edges, view) {
        const width = Math.min(Math.max(80 / Math.sqrt(Math.max(edges.length, 1)), 2.6), 5);
        return present.flatMap((kind) => {
          const some = edges.filter((i) => statusOf(all[i]!) === kind.status);
          return [
            lines(some.map((i) => [i + 1, lower[i]!, i + 1, upper[i]!] as const), ink("grey"), 0.9),
            dots(some.map((i): [number, number] => [i + 1, kind.status === "slack" ? lower[i]! : deviation[i]!]), ink(kind.ink), kind.status === "determined" ? width : 1.7 * width, view),
          ];
        });
      },
    }, model)],
    caption: parts.join(" ") + thinningWords([[count, mostAlong, "edge"]]),
  };
}

/** Residuals of the survey: of the targets in use, and of those excluded as gross errors. */
function residualsOf(result: Identification) {
  const left = new Set(result.survey.outliers.map((o) => o.node));
  const all = result.survey.residuals ?? [];
  return { used: all.filter((r) => !left.has(r.node)), out: all.filter((r) => left.has(r.node)) };
}

function mapFigure(result: Identification, model: Model, side: Side): Figure {
  const { used, out } = residualsOf(result);
  const distances = used.map((r) => 1e3 * lengthOf(r));
  const largest = distances.reduce((most, d) => Math.max(most, d), 0);
  const apart = out.length === 0 ? "" : ` Not included, marked in orange: ${excludedTargets(out.length)}, up to ${number(1e3 * Math.max(...out.map(lengthOf)))} mm away.`;
  return {
    heading: "Predicted and surveyed form",
    charts: used.length === 0 ? [] : [nodeMap({
      name: "residual_map", title: "Distance between surveyed and predicted nodes, in plan", heading: "surveyed to predicted [mm]",
      nodes: used.map((r) => r.node), values: distances, largest, marked: out.map((r) => r.node),
    }, model, side)],
    caption: `Distance between the surveyed positions of ${counted(used.length, "node")} and the predicted form: ` +
      `${number(rootMeanSquare(distances))} mm RMS, max ${number(largest)} mm.${apart}${planThinning(model)}`,
  };
}

/** Standardised residuals of all coordinates, with the normal distribution. */
function histogramFigure(result: Identification): Figure {
  const { used, out } = residualsOf(result);
  const values = used.flatMap((r) => r.standardised ?? []);
  const [reach, bins] = [5, 40];
  const width = (2 * reach) / bins;
  const counts = new Array<number>(bins).fill(0);
  for (const value of values) ++counts[Math.min(Math.max(Math.floor((value + reach) / width), 0), bins - 1)]!;
  const bars = counts.map((y, i) => ({ x1: -reach + i * width, x2: -reach + (i + 1) * width, y }));
  const normal = Array.from({ length: 121 }, (_, i): [number, number] => {
    const x = -reach + (2 * reach * i) / 120;
    return [x, (values.length * width * Math.exp(-0.5 * x * x)) / Math.sqrt(2 * Math.PI)];
  });
  const large = values.filter((v) => Math.abs(v) > 3).length;
  const apart = out.length === 0 ? "" : ` Not included: ${excludedTargets(out.length)}.`;
  return {
    heading: "Standardised residuals of the survey",
    charts: values.length === 0 ? [] : [{
      name: "residual_histogram", title: "Histogram of the standardised residuals",
      whole: { x: [-reach, reach], y: [0, 1.08 * Math.max(...counts, 0.4 * values.length * width)] },
      legend: [{ words: "survey", ink: "bar", mark: "square" }, { words: "normal distribution", ink: "orange", mark: "line" }],
      plot: () => ({
        x: { label: "residual / its standard deviation" }, y: { label: "coordinates", ticks: 5 },
        marks: [
          Plot.gridY({ stroke: ink("grid"), strokeOpacity: 1 }),
          Plot.rect(bars, { x1: "x1", x2: "x2", y1: 0, y2: "y", fill: ink("bar"), insetRight: 0.8, clip: true }),
          Plot.line(normal, { stroke: ink("orange"), strokeWidth: 1.4, clip: true }),
        ],
      }),
    }],
    caption: `Surveyed less predicted coordinate over the standard deviation of the survey (a priori), for ${counted(values.length, "coordinate")}. The fit follows part of the noise: where all ` +
      `assumptions hold, the histogram is somewhat narrower than the normal distribution. ${large === 0 ? "None exceeds" : large === 1 ? "1 exceeds" : `${large} exceed`} three standard deviations. Residuals beyond ±5 are counted in the last bins.${apart}`,
  };
}

export function identificationFigures(result: Identification, model: Model): Figure[] {
  const side = sideOf(model.form);
  return [netFigure(model, side, "predicted"), intervalFigure(result, model), mapFigure(result, model, side), histogramFigure(result)];
}
