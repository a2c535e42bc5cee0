// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import * as Plot from "@observablehq/plot";
import { type Chart, type LegendEntry, type View, wideWidth } from "./chart";
import { svg } from "./dom";
import { ink } from "./inks";
import type { Model } from "./model";
import { mostAlong, thinned } from "./thinning";

export interface EdgeChart {
  name: string;
  title: string;
  xLabel?: string;
  yLabel: string;
  /** Least and largest value. */
  range: [number, number];
  legend: LegendEntry[];
  /** Edges that are drawn however many there are, as places in model.charted. */
  always?: number[];
  /** How many edges are drawn at most. */
  most?: number;
  /** @param edges places in model.charted of what is drawn; edge i stands at x = i + 1 */
  marks(edges: readonly number[], view: View): Plot.Markish[];
}

/** Around 0, as far as any of the values. */
export function around(...values: Iterable<number>[]): [number, number] {
  let reach = 0;
  for (const some of values) for (const value of some) if (Math.abs(value) > reach) reach = Math.abs(value);
  const range = reach > 0 ? 1.05 * reach : 1;
  return [-range, range];
}

/** Edges are counted from 1; a mark left of that or in between would be none of them. */
const edgeNumber = (value: number): string => (Number.isInteger(value) && value > 0 ? String(value) : "");

/** Edges i = 1, 2, ... along x, which can be pointed at and selected. */
export function edgeChart(spec: EdgeChart, model: Model): Chart {
  const count = model.charted.length;
  const border = 0.5 + 0.008 * count;
  const placeOf = new Map(model.charted.map((edge, i) => [edge, i]));
  return {
    name: spec.name, title: spec.title, legend: spec.legend, wide: true,
    whole: { x: [1 - border, count + border], y: spec.range },
    plot(view) {
      const shown: number[] = [];
      for (let i = Math.max(0, Math.ceil(view.x[0]) - 1); i < count && i + 1 <= view.x[1]; ++i) shown.push(i);
      const some = thinned(shown, spec.most ?? mostAlong);
      const extra = some.length < shown.length ? (spec.always ?? []).filter((i) => i + 1 >= view.x[0] && i + 1 <= view.x[1]) : [];
      const edges = extra.length > 0 ? [...new Set([...some, ...extra])].sort((a, b) => a - b) : some;
      return {
        x: { label: spec.xLabel ?? "interior edge i", ticks: 10, tickFormat: edgeNumber },
        y: { label: spec.yLabel, ticks: 8, grid: true },
        marks: [Plot.gridX({ ticks: 10, stroke: ink("grid"), strokeOpacity: 1 }), Plot.gridY({ stroke: ink("grid"), strokeOpacity: 1 }), ...spec.marks(edges, view)],
      };
    },
    itemAt(px, _py, places) {
      const edge = model.charted[Math.round(places.xAt(px)) - 1];
      return edge === undefined ? null : { of: "edge", index: edge };
    },
    markOf(item, places) {
      const i = item.of === "edge" ? placeOf.get(item.index) : undefined;
      if (i === undefined) return null;
      const x = places.x(i + 1);
      return x < -2 || x > wideWidth + 2 ? null : svg("line", { x1: x, x2: x, y1: 0, y2: 1000 });
    },
  };
}

/** The width of dots: few may be larger. */
export const dotWidth = (count: number, width: number): number => width * Math.min(Math.max(Math.sqrt(300 / Math.max(count, 1)), 1), 1.8);
