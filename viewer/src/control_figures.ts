// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import * as Plot from "@observablehq/plot";
import { type Chart, type Figure, type Line, lines } from "./chart";
import { counted } from "./format";
import { type Ink, ink } from "./inks";
import type { Control, ControlRound, ControlStrategy } from "./result";

// Grey and dashed differ from the two hues by lightness and shape.
const styles: Record<ControlStrategy["strategy"], { ink: Ink; dashed?: boolean; words: string }> = {
  "true lengths": { ink: "ink", dashed: true, words: "true lengths: bound for all others" },
  identified: { ink: "blue", words: "identified: lengths from each round's survey" },
  design: { ink: "orange", words: "design: each survey, design lengths" },
  "design, once": { ink: "dim", words: "design, once: turned in round 1 only" },
};

/** Between sorted values, linearly. @param part 0: the least, 1: the most */
function quantileOf(sorted: number[], part: number): number {
  const place = part * (sorted.length - 1);
  const [below, above] = [Math.floor(place), Math.min(Math.floor(place) + 1, sorted.length - 1)];
  return sorted[below]! + (place - below) * (sorted[above]! - sorted[below]!);
}

/** With fewer jobs the middle half shows no more than the range. */
const leastForQuartiles = 4;

/** Distances of each job after a round [mm], ascending. */
const distancesAfter = (strategy: ControlStrategy, round: number): number[] =>
  strategy.states.filter((s) => s.round === round).map((s) => 1e3 * s.normal_rmse).sort((a, b) => a - b);

interface RoundChart {
  name: string;
  title: string;
  yLabel: string;
  wide?: boolean;
  first: number;
  range: [number, number];
  log?: boolean;
  value(round: ControlRound): number;
  spread?: boolean;
}

/** One line a strategy over the rounds, which stand side by side at each round. */
function roundChart(spec: RoundChart, { strategies }: Control): Chart {
  const last = strategies[0].rounds.length - 1;
  // Side by side, so that equal values are all visible.
  const placeOf = (strategy: number, round: number): number => round + 0.1 * (strategy - (strategies.length - 1) / 2);
  const bounded = (value: number): number => (spec.log ? Math.max(value, spec.range[0]) : value);
  const rounds = Array.from({ length: last - spec.first + 1 }, (_, i) => spec.first + i);
  return {
    name: spec.name, title: spec.title, ...(spec.wide ? { wide: true } : {}), height: 300 + 18 * strategies.length,
    legend: strategies.map(({ strategy }) => ({ words: styles[strategy].words, ink: styles[strategy].ink, mark: styles[strategy].dashed ? "dashes" : "line" })),
    whole: { x: [spec.first - 0.5, last + 0.5], y: spec.range },
    plot: (view) => ({
      x: { axis: null },
      y: { label: spec.yLabel, ...(spec.log ? { type: "log" as const, tickFormat: (v: number) => (/^[125]/.test(v.toExponential()) ? String(Number(v.toPrecision(3))) : "") } : { ticks: 6 }) },
      marks: [
        Plot.gridY({ stroke: ink("grid"), strokeOpacity: 1 }),
        Plot.axisX(rounds.filter((r) => r >= view.x[0] && r <= view.x[1]), { label: "after round", labelAnchor: "center", labelArrow: "none", tickFormat: (r: number) => (r === 0 ? "as built" : String(r)) }),
        ...strategies.flatMap((strategy, i) => {
          const style = styles[strategy.strategy];
          const points = strategy.rounds.slice(spec.first).map((round, k) => ({ x: placeOf(i, spec.first + k), y: bounded(spec.value(round)) }));
          const spread = (part: number): Line[] => rounds.flatMap((round): Line[] => {
            const all = distancesAfter(strategy, round);
            const x = placeOf(i, round);
            return all.length === 0 ? [] : [[x, bounded(quantileOf(all, part)), x, bounded(quantileOf(all, 1 - part))]];
          });
          const isWide = spec.spread && strategy.states.filter((s) => s.round === spec.first).length >= leastForQuartiles;
          return [
            ...(spec.spread ? [lines(spread(0), ink(style.ink), 1)] : []),
            ...(isWide ? [lines(spread(0.25), ink(style.ink), 5, 0.35)] : []),
            Plot.line(points, { x: "x", y: "y", stroke: ink(style.ink), strokeWidth: style.dashed ? 1.2 : 1.8, ...(style.dashed ? { strokeDasharray: "5 4" } : {}), clip: true }),
            Plot.dot(points, { x: "x", y: "y", r: 3.25, fill: ink(style.ink), clip: true }),
          ];
        }),
      ],
    }),
  };
}

/** Least and largest distance of any job [mm]; a value far below the others is cut, as it would compress the scale. */
function distanceRange({ strategies }: Control): [number, number] | null {
  const all = strategies.flatMap((s) => [...s.states.map((state) => state.normal_rmse), ...s.rounds.map((round) => round.normal_rmse)]);
  const most = all.reduce((a, b) => Math.max(a, b), 0);
  if (!(most > 0)) return null;
  const least = Math.max(all.reduce((a, b) => Math.min(a, b), Infinity), 1e-4 * most);
  return [1e3 * least * 10 ** -0.08, 1e3 * most * 10 ** 0.08];
}

export function controlFigures(control: Control): Figure[] {
  const { trials } = control.settings;
  const rounds = control.strategies.flatMap((s) => s.rounds);
  const failed = rounds.reduce((sum, round) => sum + round.failed, 0);
  const failures = failed === 0 ? "" : ` ${failed === 1 ? "1 plan" : `${failed} plans`} of all jobs failed; nothing was turned then, and these are included.`;
  const share = (round: ControlRound): number => (100 * round.broken_trials) / trials;
  const turned = (round: ControlRound): number => 1e3 * round.turned;
  const upTo = (value: (round: ControlRound) => number, least: number): [number, number] => [0, Math.max(1.06 * Math.max(...rounds.map(value)), least)];
  const range = distanceRange(control);
  const spread = trials === 1
    ? "; one job does not show how much jobs differ."
    : `; thin lines are the range of the jobs${trials >= leastForQuartiles ? ", thick ones the middle half." : "."}`;
  return [
    {
      heading: "Deviation from the target",
      charts: [roundChart({
        name: "control_form", title: "Normal deviation from the target, after each round", yLabel: "normal deviation, RMS [mm]", wide: true,
        first: 0, range: range ?? [0, 1], log: range !== null, value: (round) => 1e3 * round.normal_rmse, spread: trials > 1,
      }, control)],
      caption: `Normal deviation of the true form from the target${range ? ", on a logarithmic scale" : ""}: dots are the root mean square over all nodes and ${counted(trials, "job")}${spread}${failures}`,
    },
    {
      heading: "Broken limits and work",
      charts: [
        roundChart({ name: "control_limits", title: "Share of jobs in which a limit is broken, after each round", yLabel: "jobs with a broken limit [%]", first: 0, range: upTo(share, 10), value: share }, control),
        roundChart({ name: "control_strokes", title: "Strokes turned in each round", yLabel: "sum of the strokes of a round [mm]", first: 1, range: upTo(turned, 1), value: turned }, control),
      ],
      caption: `Share of ${counted(trials, "job")} in which the true tension of an edge exceeds a limit; and the sum of all strokes of a round, mean of the jobs.${failures}`,
    },
  ];
}
