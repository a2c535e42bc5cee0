// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import * as Plot from "@observablehq/plot";
import { type Chart, dots, type Figure, halfWidth, type Line, lines, type Places, type View } from "./chart";
import { colourAt, css } from "./colours";
import { svg } from "./dom";
import { counted } from "./format";
import { ink } from "./inks";
import type { Model } from "./model";
import type { Item } from "./selection";
import { mostInPlan, thinned, thinningWords } from "./thinning";

type Axis = 0 | 1 | 2;
export const axisNames = ["x", "y", "z"] as const;

/** The side from which a net shows most of itself. */
export interface Side {
  right: Axis;
  up: Axis;
  seen: string;
}

export function sideOf(form: Float32Array): Side {
  const size = axisNames.map((_, k) => {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < form.length; i += 3) [low, high] = [Math.min(low, form[i]!), Math.max(high, form[i]!)];
    return high - low;
  }) as [number, number, number];
  // A net counts as upright where one of its sides is less than half as wide as it is high.
  if (size[1] < 0.5 * size[2] && size[1] <= size[0]) return { right: 0, up: 2, seen: "along y" };
  if (size[0] < 0.5 * size[2]) return { right: 1, up: 2, seen: "along x" };
  return { right: 0, up: 1, seen: "from above" };
}

/** Where all nodes stand in a drawing. */
type Place = (node: number) => [number, number];

export const placeIn = (form: Float32Array, { right, up }: Side): Place => (node) => [form[3 * node + right]!, form[3 * node + up]!];

/** All nodes, with a border; a net that is flat in one direction still gets a strip to stand in. */
function wholeOf(model: Model, place: Place): View {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < model.nodeCount; ++i) {
    const [x, y] = place(i);
    [left, right, low, high] = [Math.min(left, x), Math.max(right, x), Math.min(low, y), Math.max(high, y)];
  }
  const border = 0.04 * Math.max(right - left, high - low);
  return { x: [left - border, right + border], y: [low - border, high + border] };
}

/** Edges of which some part may be in view. */
function edgesIn(model: Model, place: Place, view: View, edges: number[]): readonly Line[] {
  const all: Line[] = [];
  for (const edge of edges) {
    const [a, b] = place(model.ends[2 * edge]!);
    const [c, d] = place(model.ends[2 * edge + 1]!);
    if (Math.max(a, c) < view.x[0] || Math.min(a, c) > view.x[1] || Math.max(b, d) < view.y[0] || Math.min(b, d) > view.y[1]) continue;
    all.push([a, b, c, d]);
  }
  return thinned(all, mostInPlan);
}

const isIn = (view: View, [x, y]: [number, number]): boolean => x >= view.x[0] && x <= view.x[1] && y >= view.y[0] && y <= view.y[1];

function axesOf(side: Side | null): Pick<Plot.PlotOptions, "x" | "y"> {
  if (!side) return { x: { axis: null }, y: { axis: null } };
  return { x: { label: `${axisNames[side.right]} [m]`, ticks: 6 }, y: { label: `${axisNames[side.up]} [m]`, ticks: 5 } };
}

/** Finds the node at the pointer, and marks nodes and edges. */
function pointing(model: Model, place: Place): Required<Pick<Chart, "itemAt" | "markOf">> {
  const placed = (node: number, places: Places): [number, number] => {
    const [x, y] = place(node);
    return [places.x(x), places.y(y)];
  };
  return {
    itemAt(px, py, places) {
      let best: Item | null = null;
      let least = 12;
      for (let node = 0; node < model.nodeCount; ++node) {
        const [x, y] = placed(node, places);
        const distance = Math.hypot(x - px, y - py);
        if (distance < least) [best, least] = [{ of: "node", index: node }, distance];
      }
      return best;
    },
    markOf(item, places) {
      if (item.of === "node") {
        const [cx, cy] = placed(item.index, places);
        return svg("circle", { cx, cy, r: 8 });
      }
      const [x1, y1] = placed(model.ends[2 * item.index]!, places);
      const [x2, y2] = placed(model.ends[2 * item.index + 1]!, places);
      return svg("line", { x1, y1, x2, y2 });
    },
  };
}

const isEdge = (model: Model, kind: "interior" | "adjustable"): number[] =>
  Array.from(model.isAdjustable, (adjustable, edge) => (Boolean(adjustable) === (kind === "adjustable") ? edge : -1)).filter((edge) => edge >= 0);

export interface NodeMap {
  name: string;
  title: string;
  heading: string;
  nodes: number[];
  values: number[];
  /** End of the colour scale. */
  largest: number;
  /** Nodes that are ringed, without a value. */
  marked?: number[];
}

/** Values at nodes, by colour. */
export function nodeMap(map: NodeMap, model: Model, side: Side): Chart {
  const place = placeIn(model.form, side);
  const whole = wholeOf(model, place);
  const edges = Array.from({ length: model.edgeCount }, (_, e) => e);
  const meanLength = edges.reduce((sum, e) => {
    const [a, b] = [place(model.ends[2 * e]!), place(model.ends[2 * e + 1]!)];
    return sum + Math.hypot(a[0] - b[0], a[1] - b[1]);
  }, 0) / Math.max(edges.length, 1);
  const colourOf = (part: number): string => css(colourAt("sequential", part));
  return {
    name: map.name, title: map.title, heading: map.heading, whole, isPlan: true,
    colourBar: { largest: map.largest, colourAt: colourOf },
    plot(view) {
      const at = map.nodes.map((node, i) => ({ place: place(node), value: map.values[i]! })).filter((n) => isIn(view, n.place));
      const some = thinned(at, mostInPlan);
      // Two neighbours nearly touch.
      const size = (0.82 * meanLength * (halfWidth - 130)) / (view.x[1] - view.x[0]);
      const width = Math.min(Math.max(size, 1.5), 16);
      const levels = new Map<number, [number, number][]>();
      for (const { place: p, value } of some) {
        const level = Math.min(Math.floor((map.largest > 0 ? value / map.largest : 0) * 64), 63);
        const same = levels.get(level);
        if (same) same.push(p);
        else levels.set(level, [p]);
      }
      return {
        ...axesOf(side),
        marks: [
          lines(edgesIn(model, place, view, edges), ink("faint"), 0.8),
          dots(some.map((n) => n.place), ink("grey"), width + 1, view),
          ...[...levels].map(([level, points]) => dots(points, colourOf((level + 0.5) / 64), width, view)),
          dots((map.marked ?? []).map(place), ink("orange"), width, view),
        ],
      };
    },
    ...pointing(model, place),
  };
}

/** Edges and nodes, each kind in its colour. */
function netDrawing(name: string, title: string, model: Model, place: Place, side: Side | null): Chart {
  const nodes = Array.from(model.isSupport, (support, node) => ({ node, support: support === 1 }));
  const struts = isEdge(model, "interior").filter((edge) => model.isStrut[edge]);
  return {
    name, title, whole: wholeOf(model, place), isPlan: true,
    legend: [
      { words: "free node", ink: "blue" }, { words: "support", ink: "ink", mark: "square" },
      { words: "interior edge", ink: "grey", mark: "line" }, { words: "adjustable edge", ink: "orange", mark: "line" },
      ...(struts.length > 0 ? [{ words: "strut", ink: "blue", mark: "line" } as const] : []),
    ],
    plot(view) {
      // Dots that would touch hide the edges: they shrink with the number of nodes.
      const size = Math.min(Math.max(60 / Math.sqrt(model.nodeCount), 0.6), 5);
      const of = (support: boolean) => thinned(nodes.filter((n) => n.support === support).map((n) => place(n.node)).filter((p) => isIn(view, p)), mostInPlan);
      return {
        ...axesOf(side),
        marks: [
          lines(edgesIn(model, place, view, isEdge(model, "interior")), ink("grey"), 1),
          lines(edgesIn(model, place, view, isEdge(model, "adjustable")), ink("orange"), 1.8),
          lines(edgesIn(model, place, view, struts), ink("blue"), 2.6),
          dots(of(false), ink("blue"), size, view),
          Plot.dot(of(true), { x: "0", y: "1", symbol: "square", r: Math.max(1.2 * size, 2), fill: ink("ink") }),
        ],
      };
    },
    ...pointing(model, place),
  };
}

/** The net slantwise from above, and from the side that shows most of it (the paper's figure 3D). */
function netCharts(model: Model, side: Side): Chart[] {
  const [turn, height] = [(25 * Math.PI) / 180, (38 * Math.PI) / 180];
  const slanting: Place = (node) => {
    const [x, y, z] = [0, 1, 2].map((k) => model.form[3 * node + k]!) as [number, number, number];
    const back = -x * Math.sin(turn) + y * Math.cos(turn);
    return [x * Math.cos(turn) + y * Math.sin(turn), back * Math.sin(height) + z * Math.cos(height)];
  };
  return [
    netDrawing("net_view", "The net, seen slantwise from above", model, slanting, null),
    netDrawing("net_plan", `The net, seen ${side.seen}`, model, placeIn(model.form, side), side),
  ];
}

export const planThinning = (model: Model): string => thinningWords([[model.edgeCount, mostInPlan, "edge"], [model.nodeCount, mostInPlan, "node"]]);

/** @param which form it is: "nominal" */
export function netFigure(model: Model, side: Side, which: string): Figure {
  const supports = model.isSupport.reduce((sum, s) => sum + s, 0);
  const adjustable = model.isAdjustable.reduce((sum, a) => sum + a, 0);
  return {
    heading: "The net", charts: netCharts(model, side),
    caption: `The ${which} form in parallel projection and seen ${side.seen}: ${counted(model.nodeCount - supports, "free node")}, ${counted(supports, "support")}, ` +
      `${counted(model.edgeCount - adjustable, "interior edge")} of uncertain unstressed length and ${counted(adjustable, "adjustable edge")} of known unstressed length.${planThinning(model)}`,
  };
}
