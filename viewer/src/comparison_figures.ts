// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import * as Plot from "@observablehq/plot";
import type { Chart, Figure } from "./chart";
import { short } from "./format";
import { type Ink, ink } from "./inks";
import type { Comparison, ComparisonRow } from "./result";

type Rows = ComparisonRow[];

interface Series {
  name: string;
  ink: Ink;
  dashed: boolean;
  points: [x: number, mm: number][];
}

const inks: Ink[] = ["blue", "orange", "green", "magenta", "brown", "dim"];

/** By place; the first row of each counts. An error of 0 has no logarithm and is skipped. */
function pointsOf(rows: Rows, place: (row: ComparisonRow) => number | null, key: "mse" | "cramer_rao_mse"): [number, number][] {
  const points = new Map<number, number>();
  for (const row of rows) {
    const [x, mse] = [place(row), row[key]];
    if (x !== null && typeof mse === "number" && mse > 0 && !points.has(x)) points.set(x, 1e3 * Math.sqrt(mse));
  }
  return [...points].sort(([a], [b]) => a - b);
}

/** A curve for each method, then the Cramér-Rao bound. @param all methods, each of which keeps its ink where it has no curve */
function seriesOver(all: string[], rows: Rows, place: (row: ComparisonRow) => number | null): Series[] {
  const own = all.map((name, i): Series => ({ name, ink: inks[i % inks.length]!, dashed: false, points: pointsOf(rows.filter((r) => r.method === name), place, "mse") }));
  return [...own, { name: "Cramér-Rao bound", ink: "ink" as const, dashed: true, points: pointsOf(rows, place, "cramer_rao_mse") }].filter((s) => s.points.length > 0);
}

/** The values of one key that occur with each value of another. */
function partners(rows: Rows, of: (row: ComparisonRow) => number | null, other: (row: ComparisonRow) => number | null): Map<number, Set<number>> {
  const result = new Map<number, Set<number>>();
  for (const row of rows) {
    const [key, value] = [of(row), other(row)];
    if (key === null || value === null) continue;
    if (!result.has(key)) result.set(key, new Set());
    result.get(key)!.add(value);
  }
  return result;
}

/** The value with the most different partners: the one at which the other key was varied. Of several the one that comes first. */
function mostVaried(all: Map<number, Set<number>>, isBefore: (a: number, b: number) => boolean): number {
  return [...all].reduce((best, next) =>
    next[1].size > best[1].size || (next[1].size === best[1].size && isBefore(next[0], best[0])) ? next : best)[0];
}

const noiseOf = (row: ComparisonRow): number => row.noise;
const trainingOf = (row: ComparisonRow): number | null => row.training_samples ?? null;
const hiddenOf = (row: ComparisonRow): number => row.hidden_fraction ?? 0;
const less = (a: number, b: number): boolean => a < b;
const more = (a: number, b: number): boolean => a > b;
/** Surveys without noise do not exist; of the others the lowest. */
const lowestNoise = (a: number, b: number): boolean => (a > 0 && !(b > 0)) || (a > 0 === b > 0 && a < b);

/** Of the decades between the least and the largest positive x, the part that 0 stands apart. */
const zeroGap = 0.25;

/** Errors on a logarithmic axis, over places on another or on a linear one; 0 stands apart on the left. */
function errorChart(name: string, title: string, xLabel: string, series: Series[], linear = false): Chart[] {
  const xs = [...new Set(series.flatMap((s) => s.points.map(([x]) => x)))].sort((a, b) => a - b);
  if (xs.length === 0) return [];
  const positive = xs.filter((x) => x > 0).map(Math.log10);
  const [least, most] = positive.length > 0 ? [positive[0]!, positive.at(-1)!] : [0, 0];
  const place = (x: number): number => (linear ? x : x > 0 ? Math.log10(x) : least - zeroGap * Math.max(most - least, 1));
  const isApart = (x: number): boolean => !linear && !(x > 0);
  // Errors of a survey without noise are far below the others: they are given as text.
  const lowest = Math.min(...series.flatMap((s) => s.points.filter(([x]) => !isApart(x)).map(([, y]) => y))) / 3;
  const isDrawn = ([, y]: [number, number]): boolean => !Number.isFinite(lowest) || y >= lowest;
  const drawn = series.flatMap((s) => s.points.filter(isDrawn).map(([, y]) => Math.log10(y)));
  const inWords = series.flatMap((s) => s.points.filter((p) => !isDrawn(p)).map(([x, y]) => ({ x: place(x), y, ink: s.ink })));
  const height = 300 + 18 * series.length;
  const margin = 0.1;
  let [low, high] = [Math.min(...drawn) - margin, Math.max(...drawn) + margin];
  const strip = Math.min(0.5, inWords.length > 0 ? (18 * (inWords.length + 0.5)) / 240 : 0);
  low -= ((high - low) * strip) / (1 - strip);
  const room = 0.08 * Math.max(place(xs.at(-1)!) - place(xs[0]!), 1);
  const labels = new Map(xs.map((x) => [place(x), short(x)]));
  return [{
    name, title, height,
    legend: series.map((s) => ({ words: s.name, ink: s.ink, mark: s.dashed ? "dashes" : "line" })),
    whole: { x: [place(xs[0]!) - room, place(xs.at(-1)!) + room], y: [10 ** low, 10 ** high] },
    plot: (view) => ({
      x: { label: xLabel, axis: null },
      y: { type: "log", label: "root mean squared error [mm]", tickFormat: (value: number) => (/^[125]/.test(value.toExponential()) ? short(value) : ""), ticks: 8 },
      marks: [
        Plot.gridY({ stroke: ink("grid"), strokeOpacity: 1 }),
        Plot.axisX(xs.map(place).filter((x) => x >= view.x[0] && x <= view.x[1]), { label: xLabel, labelAnchor: "center", labelArrow: "none", tickFormat: (x: number) => labels.get(x) ?? "" }),
        ...series.flatMap((s, i) => {
          // Each curve is thinner than the one before, so that coinciding curves are both visible.
          const width = 1.4 + 0.7 * (series.length - 1 - i);
          const points = s.points.filter(isDrawn).map(([x, y]) => ({ x: place(x), y, joined: !isApart(x) }));
          return [
            Plot.line(points.filter((p) => p.joined), { x: "x", y: "y", stroke: ink(s.ink), strokeWidth: width, ...(s.dashed ? { strokeDasharray: "5 4" } : {}), clip: true }),
            Plot.dot(points, { x: "x", y: "y", r: (width + 4) / 2, fill: ink(s.ink), clip: true }),
          ];
        }),
        ...inWords.flatMap(({ x, y, ink: colour }, i) => {
          const at = { x: [x], y: [10 ** low], dy: -8 - 18 * i };
          return [Plot.dot([0], { ...at, r: 3, fill: ink(colour), clip: true }), Plot.text([`${short(y)} mm`], { ...at, dx: 8, text: [`${short(y)} mm`], textAnchor: "start", clip: true })];
        }),
      ],
    }),
  }];
}

/** Rows of the noise and number of training samples with the most shares of hidden nodes; none where there is only one share. */
function hiddenVaried(rows: Rows): Rows {
  const hidden = partners(rows, noiseOf, hiddenOf);
  const noise = mostVaried(hidden, less);
  if (hidden.get(noise)!.size < 2) return [];
  const atNoise = rows.filter((row) => row.noise === noise);
  const ofTraining = partners(atNoise, trainingOf, hiddenOf);
  const training = ofTraining.size > 0 ? mostVaried(ofTraining, more) : null;
  const some = atNoise.filter((row) => trainingOf(row) === null || trainingOf(row) === training);
  return new Set(some.map(hiddenOf)).size > 1 ? some : [];
}

/** Error of each method over the noise of the survey, the number of training samples and the share of hidden nodes. */
export function comparisonFigures({ rows: all }: Comparison): Figure[] {
  if (all.length === 0) return [];
  const methods = [...new Set(all.map((row) => row.method))];
  const leastHidden = Math.min(...all.map(hiddenOf));
  const rows = all.filter((row) => hiddenOf(row) <= leastHidden);
  const inMm = (row: ComparisonRow): number => 1e3 * row.noise;
  const overNoise = (some: Rows, label: string): Chart[] =>
    errorChart("error_over_noise", "Error of each method over the standard deviation of the survey", `standard deviation of a surveyed coordinate [mm]${label}`, seriesOver(methods, some, inMm));
  const charts: Chart[] = [];
  const noises = partners(rows, trainingOf, noiseOf);
  if (noises.size === 0) {
    charts.push(...overNoise(rows, ""));
  } else {
    const training = mostVaried(noises, more);
    charts.push(...overNoise(rows.filter((row) => (trainingOf(row) ?? training) === training), `, ${short(training)} training samples`));
    const trainings = partners(rows, noiseOf, trainingOf);
    const noise = mostVaried(trainings, lowestNoise);
    const places = [...trainings.get(noise)!].sort((a, b) => a - b);
    // A method without training does not depend on their number: a level line.
    const levelled = rows.filter((row) => row.noise === noise).flatMap((row): Rows =>
      trainingOf(row) !== null ? [row] : [places[0]!, places.at(-1)!].map((training_samples) => ({ ...row, training_samples })));
    charts.push(...errorChart("error_over_training", "Error of each method over the number of training samples", `training samples, survey std ${short(1e3 * noise)} mm`, seriesOver(methods, levelled, trainingOf)));
  }
  const overHidden = hiddenVaried(all);
  if (overHidden.length > 0) {
    charts.push(...errorChart("error_over_hidden", "Error of each method over the share of nodes not surveyed", `nodes not surveyed [%], survey std ${short(1e3 * overHidden[0]!.noise)} mm`,
      seriesOver(methods, overHidden, (row) => 100 * hiddenOf(row)), true));
  }
  return [{
    heading: "Error of each method", charts,
    caption: "Root mean squared error of the identified lengths. The Cramér-Rao bound is the posterior standard deviation of the problem linearised at the truth: to first order, no " +
      "method has a smaller mean error. Lines are level over the number of training samples for methods without training.",
  }];
}
