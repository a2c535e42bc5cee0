// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";
import { nice } from "./format";
import type { Model } from "./model";
import type { Item } from "./selection";

/** What is labelled with its name. */
export const labelled = ["none", "supports", "adjustable edges", "nodes", "edges"] as const;
export type Labelled = (typeof labelled)[number];

function itemsOf(model: Model, which: Labelled): Item[] {
  const of = (kind: Item["of"], count: number, is: (index: number) => boolean = () => true): Item[] =>
    Array.from({ length: count }, (_, index) => ({ of: kind, index })).filter(({ index }) => is(index));
  switch (which) {
    case "none": return [];
    case "supports": return of("node", model.nodeCount, (node) => model.isSupport[node] === 1);
    case "nodes": return of("node", model.nodeCount);
    case "adjustable edges": return of("edge", model.edgeCount, (edge) => model.isAdjustable[edge] === 1);
    case "edges": return of("edge", model.edgeCount);
  }
}

/** Names over the view, as many as have room, and a scale bar. */
export class NetLabels {
  readonly canvas = h("canvas", { class: "labels", "aria-hidden": "true" });
  private items: Item[] = [];

  constructor(private readonly model: Model) {}

  show(which: Labelled): void {
    this.items = itemsOf(this.model, which);
  }

  /**
   * @param screen places of all nodes, in CSS pixels; @param selected is labelled first
   * @param metresPerPixel null where it differs from place to place
   */
  draw(screen: Float32Array, size: { width: number; height: number; ratio: number }, look: { ink: string; ground: string }, selected: Item | null, metresPerPixel: number | null): void {
    const { width, height, ratio } = size;
    if (width === 0 || height === 0) return;  // it is not shown
    Object.assign(this.canvas, { width: width * ratio, height: height * ratio });
    const context = this.canvas.getContext("2d");
    if (!context) return;
    context.scale(ratio, ratio);
    Object.assign(context, { font: "12px system-ui, sans-serif", fillStyle: look.ink, strokeStyle: look.ground, lineWidth: 3, lineJoin: "round" });
    const taken: [number, number, number][] = [];
    for (const item of selected ? [selected, ...this.items] : this.items) {
      const [x, y] = this.placeOf(item, screen);
      if (!(x >= 0 && x <= width && y >= 12 && y <= height)) continue;
      const text = item.of === "edge" ? this.model.edgeId(item.index) : this.model.nodeId(item.index);
      const wide = context.measureText(text).width + 6;
      if (taken.some(([a, b, w]) => Math.abs(b - y) < 14 && x < a + w && a < x + wide)) continue;
      taken.push([x, y, wide]);
      context.strokeText(text, x + 5, y - 4);
      context.fillText(text, x + 5, y - 4);
    }
    if (metresPerPixel === null) return;
    const bar = nice(metresPerPixel * 0.25 * width);
    const pixels = bar / metresPerPixel;
    context.fillRect(12, height - 14, pixels, 2);
    for (const x of [12, 10 + pixels]) context.fillRect(x, height - 18, 2, 10);
    context.strokeText(`${bar} m`, 20 + pixels, height - 9);
    context.fillText(`${bar} m`, 20 + pixels, height - 9);
  }

  private placeOf({ of, index }: Item, screen: Float32Array): [number, number] {
    if (of === "node") return [screen[2 * index]!, screen[2 * index + 1]!];
    const [s, t] = [this.model.ends[2 * index]!, this.model.ends[2 * index + 1]!];
    return [(screen[2 * s]! + screen[2 * t]!) / 2, (screen[2 * s + 1]! + screen[2 * t + 1]!) / 2];
  }
}
