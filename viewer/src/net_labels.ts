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

/** A bar that is so long on the screen, and what that is. */
export interface ScaleBar { pixels: number; words: string }

/** A bar of a round number of a unit. */
export function scaleBar(unitsPerPixel: number, width: number, unit: string): ScaleBar {
  const length = nice(unitsPerPixel * 0.25 * width);
  return { pixels: length / unitsPerPixel, words: `${length} ${unit}` };
}

/** Names over the view, as many as have room, and scale bars. */
export class NetLabels {
  readonly canvas = h("canvas", { class: "labels", "aria-hidden": "true" });
  private items: Item[] = [];

  constructor(private readonly model: Model) {}

  show(which: Labelled): void {
    this.items = itemsOf(this.model, which);
  }

  /**
   * @param screen places of all nodes, in CSS pixels; @param selected is labelled first
   * @param under draws what is under the names; @param bars from below
   */
  draw(screen: Float32Array, size: { width: number; height: number; ratio: number }, look: { ink: string; ground: string }, selected: Item | null, under: (context: CanvasRenderingContext2D) => void, bars: ScaleBar[]): void {
    const { width, height, ratio } = size;
    if (width === 0 || height === 0) return;  // it is not shown
    Object.assign(this.canvas, { width: width * ratio, height: height * ratio });
    const context = this.canvas.getContext("2d");
    if (!context) return;
    context.scale(ratio, ratio);
    under(context);
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
    bars.forEach(({ pixels, words }, i) => {
      const y = height - 14 - 20 * i;
      context.fillRect(12, y, pixels, 2);
      for (const x of [12, 10 + pixels]) context.fillRect(x, y - 4, 2, 10);
      context.strokeText(words, 20 + pixels, y + 5);
      context.fillText(words, 20 + pixels, y + 5);
    });
  }

  private placeOf({ of, index }: Item, screen: Float32Array): [number, number] {
    if (of === "node") return [screen[2 * index]!, screen[2 * index + 1]!];
    const [s, t] = [this.model.ends[2 * index]!, this.model.ends[2 * index + 1]!];
    return [(screen[2 * s]! + screen[2 * t]!) / 2, (screen[2 * s + 1]! + screen[2 * t + 1]!) / 2];
  }
}
