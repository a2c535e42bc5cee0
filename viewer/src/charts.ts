// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { svg } from "./dom";
import type { Model } from "./model";
import type { Item, Selection } from "./selection";

// The figures are drawings that taut made; their attributes tell where edges and nodes stand
// (src/report/chart.hpp). Here they learn to name what is pointed at and to mark what is selected.

interface Scale {
  (value: number): number;
  invert(place: number): number;
  from: number;
  to: number;
}

function readScale(text: string): Scale {
  const [low, high, from, to] = text.split(" ").map(Number) as [number, number, number, number];
  const scale = (value: number): number => from + ((value - low) / (high - low)) * (to - from);
  return Object.assign(scale, { invert: (place: number) => low + ((place - from) / (to - from)) * (high - low), from, to });
}

interface Chart {
  itemAt(x: number, y: number): Item | null;
  /** A mark of an item, null where the chart does not show it. */
  mark(item: Item): SVGElement | null;
}

/** Edges i = 1, 2, ... along x. */
function edgeChart(drawing: SVGSVGElement, model: Model): Chart {
  const x = readScale(drawing.dataset.x!);
  const y = readScale(drawing.dataset.y!);
  const places = new Map(model.charted.map((edge, i) => [edge, i]));
  return {
    itemAt(place) {
      const i = Math.round(x.invert(place)) - 1;
      const edge = model.charted[i];
      return edge === undefined || place < x.from - 2 || place > x.to + 2 ? null : { of: "edge", index: edge };
    },
    mark(item) {
      const i = item.of === "edge" ? places.get(item.index) : undefined;
      if (i === undefined) return null;
      return svg("line", { x1: x(i + 1), x2: x(i + 1), y1: y.from, y2: y.to });
    },
  };
}

/** Nodes in plan. */
function nodeChart(drawing: SVGSVGElement, model: Model): Chart {
  const x = readScale(drawing.dataset.x!);
  const y = readScale(drawing.dataset.y!);
  const [right, up] = ["xyz".indexOf(drawing.dataset.right!), "xyz".indexOf(drawing.dataset.up!)] as [number, number];
  const placeOf = (node: number): [number, number] => [x(model.form[3 * node + right]!), y(model.form[3 * node + up]!)];
  return {
    itemAt(px, py) {
      let best: Item | null = null;
      let least = 12;
      for (let node = 0; node < model.nodeCount; ++node) {
        const [nx, ny] = placeOf(node);
        const distance = Math.hypot(nx - px, ny - py);
        if (distance < least) [best, least] = [{ of: "node", index: node }, distance];
      }
      return best;
    },
    mark(item) {
      if (item.of === "node") {
        const [cx, cy] = placeOf(item.index);
        return svg("circle", { cx, cy, r: 8 });
      }
      const ends = [0, 1].map((end) => placeOf(model.ends[2 * item.index + end]!)) as [[number, number], [number, number]];
      return svg("line", { x1: ends[0][0], y1: ends[0][1], x2: ends[1][0], y2: ends[1][1] });
    },
  };
}

/** Joins all drawings of the page with what is selected. */
export function linkCharts(model: Model, selection: Selection): void {
  for (const drawing of document.querySelectorAll<SVGSVGElement>("svg[data-chart]")) {
    const chart = drawing.dataset.chart === "edges" ? edgeChart(drawing, model) : nodeChart(drawing, model);
    const marks = svg("g", { "aria-hidden": "true" });
    drawing.append(marks);
    const itemAt = (event: MouseEvent): Item | null => {
      const frame = drawing.getBoundingClientRect();
      const scale = drawing.viewBox.baseVal.width / frame.width;
      return chart.itemAt((event.clientX - frame.left) * scale, (event.clientY - frame.top) * scale);
    };
    drawing.addEventListener("pointermove", (event) => selection.hover(itemAt(event)));
    drawing.addEventListener("pointerleave", () => selection.hover(null));
    drawing.addEventListener("click", (event) => selection.select(itemAt(event)));
    selection.subscribe(() => {
      const drawn: SVGElement[] = [];
      for (const [item, name] of [[selection.hovered, "mark hovered"], [selection.selected, "mark selected"]] as const) {
        const mark = item && chart.mark(item);
        mark?.setAttribute("class", name);
        if (mark) drawn.push(mark);
      }
      marks.replaceChildren(...drawn);
    });
  }
}
