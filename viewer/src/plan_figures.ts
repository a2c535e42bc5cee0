// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { type Chart, dots, type Figure, type Line, lines } from "./chart";
import { dotWidth, edgeChart } from "./edge_chart";
import { counted, number, rootMeanSquare } from "./format";
import { ink } from "./inks";
import type { Model } from "./model";
import { nodeMap, planThinning, sideOf } from "./net_map";
import { hasLimit, marginOf } from "./plan_model";
import type { Plan, PlannedTension } from "./result";
import { mostAlong, thinningWords } from "./thinning";

/** By more than the tolerance of equilibrium [N]: a planned tension may equal its limit. */
const exceedsLimit = (tension: PlannedTension): boolean => marginOf(tension) < -1;

/** Deviation of the free nodes from the target before and after turning, on one scale. */
function deviationFigure(model: Model): Figure {
  const side = sideOf(model.form);
  const of = (key: string): { nodes: number[]; values: number[] } => {
    const { values } = model.quantities.find((q) => q.key === key)!;
    const nodes = Array.from({ length: model.nodeCount }, (_, i) => i).filter((i) => Number.isFinite(values[i]!));
    return { nodes, values: nodes.map((i) => Math.abs(values[i]!)) };
  };
  const largest = (values: number[]): number => values.reduce((most, v) => Math.max(most, v), 0);
  const directions = [
    { key: "normal", words: "normal deviation", built: of("normal_built"), planned: of("normal_planned") },
    { key: "distance", words: "3D deviation", built: of("distance_built"), planned: of("distance_planned") },
  ].filter((d) => d.built.nodes.length > 0);
  const most = largest(directions.flatMap((d) => [largest(d.built.values), largest(d.planned.values)]));
  const charts = directions.flatMap(({ key, words, ...both }) => (["built", "planned"] as const).map((which): Chart => nodeMap({
    name: `plan_${key}_${which}`, title: `The ${words} from the target, as ${which}, in plan`, heading: `${words}, as ${which} [mm]`, largest: most, ...both[which],
  }, model, side)));
  const summaries = directions.map(({ words, built, planned }) =>
    `${words} ${number(rootMeanSquare(built.values))} mm RMS as built and ${number(rootMeanSquare(planned.values))} mm as planned ` +
    `(max ${number(largest(built.values))} and ${number(largest(planned.values))} mm)`);
  return {
    heading: "Deviation from the target, before and after turning", charts,
    caption: `Deviation of the free nodes from the target: ${summaries.join("; ")}. All have the same view and the same colour scale.${planThinning(model)}`,
  };
}

/** A line that is level over edges with the same limit, and interrupted where the limit is not in the drawing. */
function limitLines(limits: (number | null)[], top: number): Line[] {
  const all: Line[] = [];
  const isDrawn = (limit: number | null | undefined): limit is number => typeof limit === "number" && limit <= top;
  for (let first = 0, last = 0; first < limits.length; first = last) {
    const limit = limits[first]!;
    while (last < limits.length && limits[last] === limit) ++last;
    if (!isDrawn(limit)) continue;
    const before = limits[first - 1];
    if (isDrawn(before)) all.push([first + 0.5, before, first + 0.5, limit]);
    all.push([first + 0.5, limit, last + 0.5, limit]);
  }
  return all;
}

/** Tensions as built and as planned, with their intervals and limits, over all edges. */
function tensionFigure(plan: Plan, model: Model): Figure {
  const { edges: tensions } = plan.tension;
  const kN = 1e-3;
  const count = tensions.length;
  const most = tensions.reduce((top, t) => Math.max(top, t.as_built, t.planned, t.upper ?? 0), 0);
  // Limits far above all tensions would compress the scale.
  const highest = tensions.reduce((top, t) => (t.limit_upper !== null && t.limit_upper <= 2 * most ? Math.max(top, t.limit_upper) : top), most);
  const top = highest > 0 ? 1.05 * kN * highest : 1;
  const exceeding = tensions.flatMap((t, i) => (exceedsLimit(t) ? [i] : []));
  const above = tensions.filter((t) => t.limit_upper !== null && kN * t.limit_upper > top).length;
  const drawn = plan.draws > 0 && tensions.some((t) => t.lower !== null);
  const limited = tensions.some(hasLimit);
  const bottom = 1.05 * kN * tensions.reduce((least, t) => Math.min(least, t.as_built, t.planned, t.lower ?? 0), 0);
  const limits = [...limitLines(tensions.map((t) => (t.limit_lower === null || kN * t.limit_lower < bottom ? null : kN * t.limit_lower)), top), ...limitLines(tensions.map((t) => (t.limit_upper === null ? null : kN * t.limit_upper)), top)];
  return {
    heading: "Tensions and their limits",
    charts: count === 0 ? [] : [edgeChart({
      name: "plan_tensions", title: "Tensions as built and as planned, with their limits", xLabel: "edge i, in the order of the net", yLabel: "tension [kN]",
      range: [bottom, top], always: exceeding,
      legend: [
        { words: "as built", ink: "amber" }, { words: "as planned", ink: "deep" },
        ...(exceeding.length > 0 ? [{ words: "as planned, limit exceeded", ink: "magenta" } as const] : []),
        ...(drawn ? [{ words: "95 % interval", ink: "grey", mark: "line" } as const] : []),
        { words: "limit", ink: "orange", mark: "line" },
      ],
      marks(edges, view) {
        const of = (some: readonly number[], value: (t: PlannedTension) => number) => some.map((i): [number, number] => [i + 1, kN * value(tensions[i]!)]);
        const width = (size: number) => dotWidth(edges.length, size);
        const known = edges.filter((i) => tensions[i]!.lower !== null);
        return [
          dots(of(edges, (t) => t.as_built), ink("amber"), width(5), view),
          lines(known.map((i) => [i + 1, kN * tensions[i]!.lower!, i + 1, kN * tensions[i]!.upper!] as const), ink("grey"), 0.9),
          dots(of(edges.filter((i) => !exceedsLimit(tensions[i]!)), (t) => t.planned), ink("deep"), width(3.4), view),
          dots(of(edges.filter((i) => exceedsLimit(tensions[i]!)), (t) => t.planned), ink("magenta"), width(5), view),
          lines(limits, ink("orange"), 1.2),
        ];
      },
    }, model)],
    caption: `Tension of ${counted(count, "edge")} as built and as planned${drawn ? ", with the 95 % interval" : ""}; ` +
      `${limited ? "lines are the limits" : "no limits were given, but no edge may go slack"}. ` +
      `${exceeding.length === 0 ? "No planned tension exceeds a limit." : `${counted(exceeding.length, "planned tension")} ${exceeding.length === 1 ? "exceeds" : "exceed"} a limit.`}` +
      `${above > 0 ? ` Upper limits of ${counted(above, "edge")} lie above the drawing.` : ""}${thinningWords([[count, mostAlong, "edge"]])}`,
  };
}

export const planFigures = (plan: Plan, model: Model): Figure[] => [deviationFigure(model), tensionFigure(plan, model)];
