// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import * as Plot from "@observablehq/plot";
import { download } from "./csv";
import { h, svg } from "./dom";
import { type Ink, ink, onWhite } from "./inks";
import type { Item, Selection } from "./selection";

/** The part of a chart that is shown, in its own units. */
export interface View {
  x: [number, number];
  y: [number, number];
}

/** Where a value stands in the drawing, and which value stands at a place. */
export interface Places {
  x(value: number): number;
  y(value: number): number;
  xAt(place: number): number;
  yAt(place: number): number;
}

export interface LegendEntry {
  words: string;
  ink: Ink;
  mark?: "dot" | "line" | "dashes" | "square";
}

export interface Chart {
  /** Of its SVG file, and of its element. */
  name: string;
  /** What it shows, for those who cannot see it. */
  title: string;
  wide?: boolean;
  height?: number;
  whole: View;
  /** Whether both axes have one scale. */
  isPlan?: boolean;
  legend?: LegendEntry[];
  /** A line above the drawing where there is no legend. */
  heading?: string;
  colourBar?: { largest: number; colourAt(part: number): string };
  /** Axes and marks of what is shown. */
  plot(view: View): Plot.PlotOptions;
  /** The edge or node at a place of the drawing. */
  itemAt?(px: number, py: number, places: Places): Item | null;
  /** What marks an edge or a node, null where it is not shown. */
  markOf?(item: Item, places: Places): SVGElement | null;
}

/** Charts that stand side by side, where there is room, above one caption. */
export interface Figure {
  heading: string;
  charts: Chart[];
  caption: string;
}

export const wideWidth = 960;
export const halfWidth = 480;
const rowHeight = 18;
const margin = { left: 60, right: 12, bottom: 42 };
const colourBarRoom = 62;
const mostPlanHeight = 420;

const round = (place: number): string => place.toFixed(1);

/** Many dots as one element, without those outside the view. */
export function dots(points: Iterable<readonly [number, number]>, colour: string, width: number, view: View): Plot.RenderFunction {
  return (_index, scales) => {
    const [x, y] = [scales.x!, scales.y!] as unknown as ((value: number) => number)[];
    let d = "";
    for (const [a, b] of points) {
      if (a >= view.x[0] && a <= view.x[1] && b >= view.y[0] && b <= view.y[1]) d += `M${round(x!(a))} ${round(y!(b))}h0`;
    }
    return svg("path", { d, fill: "none", stroke: colour, "stroke-width": width, "stroke-linecap": "round" });
  };
}

export type Line = readonly [x1: number, y1: number, x2: number, y2: number];

/** Many lines as one element. */
export function lines(all: Iterable<Line>, colour: string, width: number, opacity = 1): Plot.RenderFunction {
  return (_index, scales, _values, dimensions) => {
    const [x, y] = [scales.x!, scales.y!] as unknown as ((value: number) => number)[];
    const { width: right, height: bottom } = dimensions;
    let d = "";
    for (const [x1, y1, x2, y2] of all) {
      const [a, b, c, e] = [x!(x1), y!(y1), x!(x2), y!(y2)];
      if (Math.max(a, c) < 0 || Math.min(a, c) > right || Math.max(b, e) < 0 || Math.min(b, e) > bottom) continue;
      d += `M${round(a)} ${round(b)}L${round(c)} ${round(e)}`;
    }
    const path = svg("path", { d, fill: "none", stroke: colour, "stroke-width": width, "stroke-linecap": "round", "stroke-opacity": opacity });
    path.setAttribute("class", "clipped");
    return path;
  };
}

/** Entries in rows as wide as the drawing, in an element, and the height of the rows. */
function legendOf(entries: LegendEntry[], width: number): { element: SVGElement; height: number } {
  const element = svg("g", { class: "legend", "font-size": 12, "text-anchor": "start", fill: "currentColor" });
  let [x, y] = [margin.left, 14];
  for (const { words, ink: name, mark = "dot" } of entries) {
    const room = 34 + 6.7 * words.length;
    if (x > margin.left && x + room > width) [x, y] = [margin.left, y + rowHeight];
    const stroke = { stroke: ink(name), "stroke-linecap": "round" };
    if (mark === "square") element.append(svg("rect", { x: x + 3, y: y - 9, width: 10, height: 10, fill: ink(name) }));
    else if (mark === "dot") element.append(svg("path", { d: `M${x + 8} ${y - 4}h0`, "stroke-width": 6, ...stroke }));
    else element.append(svg("path", { d: `M${x} ${y - 4}h16`, "stroke-width": 2, ...(mark === "dashes" ? { "stroke-dasharray": "5 4" } : {}), ...stroke }));
    const text = svg("text", { x: x + 22, y });
    text.textContent = words;
    element.append(text);
    x += room;
  }
  return { element, height: entries.length > 0 ? y + 10 : 8 };
}

/** From 0 at the bottom to the largest value at the top, right of the frame. */
function colourBarOf({ largest, colourAt }: NonNullable<Chart["colourBar"]>, x: number, top: number, bottom: number): SVGElement {
  const element = svg("g", { class: "colour-bar", "font-size": 11, "text-anchor": "start", fill: "currentColor" });
  const steps = 48;
  const height = (bottom - top) / steps;
  for (let i = 0; i < steps; ++i) {
    element.append(svg("rect", { x, y: round(bottom - (i + 1) * height), width: 12, height: round(height + 0.3), fill: colourAt((i + 0.5) / steps) }));
  }
  const scale = Plot.scale({ y: { type: "linear", domain: [0, largest || 1], range: [bottom, top] } });
  const step = tickStep(largest || 1, 5);
  for (let value = 0; value <= (largest || 1) * (1 + 1e-9); value += step) {
    const text = svg("text", { x: x + 17, y: round(scale.apply(value) + 4) });
    text.textContent = Number(value.toPrecision(3)).toString();
    element.append(text);
  }
  return element;
}

/** 1, 2 or 5 times a power of ten, so that there are about so many steps up to a value. */
function tickStep(largest: number, count: number): number {
  const power = 10 ** Math.floor(Math.log10(largest / count));
  const times = largest / count / power;
  return power * (times > 5 ? 10 : times > 2 ? 5 : times > 1 ? 2 : 1);
}

/** Between bounds, in their order whichever axis they are of. */
const within = ([low, high]: [number, number], [least, most]: [number, number]): [number, number] => [Math.max(low, least), Math.min(high, most)];

/** A chart with its tools: it zooms to a drawn box, reports the item at the pointer, and can be saved. */
class DrawnChart {
  readonly element: HTMLElement;
  private readonly chart: Chart;
  private readonly selection: Selection;
  private drawing!: SVGSVGElement;
  private places!: Places;
  private frame = { left: 0, right: 0, top: 0, bottom: 0 };
  private readonly marks = svg("g", { class: "marks", "aria-hidden": "true" });
  private readonly wholeButton = h("button", { type: "button", title: "Show the whole chart", onclick: () => this.show(this.chart.whole) }, "Whole");

  constructor(chart: Chart, selection: Selection) {
    this.chart = chart;
    this.selection = selection;
    const named = (words: string) => `${words}: ${chart.title}`;
    const tool = (text: string, words: string, onclick: () => void): HTMLElement => h("button", { type: "button", title: words, "aria-label": named(words), onclick }, text);
    this.wholeButton.setAttribute("aria-label", named("Show the whole chart"));
    this.element = h("div", { class: chart.wide ? "wide" : "half", "data-figure": chart.name },
      h("div", { class: "chart-tools no-print" },
        tool("+", "Zoom in", () => this.zoom(0.5)), tool("−", "Zoom out", () => this.zoom(2)), this.wholeButton,
        tool("Save as SVG", "Save as SVG", () => download(`${chart.name}.svg`, this.text(), "image/svg+xml"))));
    this.show(chart.whole);
    if (chart.markOf) selection.subscribe(() => this.mark());
  }

  /** The drawing on white, as a file of its own. */
  private text(): string {
    const copy = this.drawing.cloneNode(true) as SVGSVGElement;
    for (const part of copy.querySelectorAll("style, .marks, .zooming")) part.remove();
    const { width, height } = this.drawing.viewBox.baseVal;
    copy.prepend(svg("rect", { width, height, fill: "white" }));
    copy.removeAttribute("class");
    copy.removeAttribute("style");
    copy.setAttribute("font-family", "system-ui, 'DejaVu Sans', sans-serif");
    copy.setAttribute("font-size", "12");
    copy.setAttribute("color", "black");
    return `<?xml version="1.0" encoding="UTF-8"?>\n${onWhite(new XMLSerializer().serializeToString(copy))}\n`;
  }

  private show(view: View): void {
    const { chart } = this;
    const width = chart.wide ? wideWidth : halfWidth;
    const legend = legendOf(chart.legend ?? [], width);
    const top = chart.heading ? 26 : legend.height + 4;
    let right = margin.right + (chart.colourBar ? colourBarRoom : 0);
    let height = chart.height ?? 330;
    if (chart.isPlan) {
      const ratio = (chart.whole.y[1] - chart.whole.y[0]) / (chart.whole.x[1] - chart.whole.x[0]);
      const room = width - margin.left - right;
      const plotHeight = Math.min(room * ratio, mostPlanHeight);
      right += room - plotHeight / ratio;
      height = plotHeight + top + margin.bottom;
    }
    const options = chart.plot(view);
    const plot = Plot.plot({
      width, height, marginTop: top, marginRight: right, marginBottom: margin.bottom, marginLeft: margin.left,
      style: { fontSize: "12px", background: "none", overflow: "hidden" },
      ...options,
      x: { domain: view.x, labelAnchor: "center", labelArrow: "none", ...options.x },
      y: { domain: view.y, labelAnchor: "center", labelArrow: "none", ...options.y },
      marks: [Plot.frame({ stroke: ink("grey") }), ...(options.marks ?? [])],
    });
    const [x, y] = [plot.scale("x")!, plot.scale("y")!];
    this.places = { x: (v) => x.apply(v), y: (v) => y.apply(v), xAt: (p) => x.invert!(p), yAt: (p) => y.invert!(p) };
    this.frame = { left: margin.left, right: width - right, top, bottom: height - margin.bottom };
    const drawing = plot as unknown as SVGSVGElement;
    this.clip(drawing);
    if (chart.heading) {
      const text = svg("text", { x: margin.left, y: 16, "font-size": 12, "text-anchor": "start", fill: "currentColor" });
      text.textContent = chart.heading;
      drawing.append(text);
    }
    if (chart.colourBar) drawing.append(colourBarOf(chart.colourBar, this.frame.right + 10, this.frame.top, this.frame.bottom));
    drawing.append(legend.element, this.marks);
    drawing.setAttribute("role", "img");
    drawing.setAttribute("aria-label", chart.title);
    if (this.drawing) this.drawing.replaceWith(drawing);
    else this.element.append(drawing);
    this.drawing = drawing;
    this.wholeButton.disabled = view === chart.whole;
    this.listen();
    this.mark();
  }

  /** Clips the drawing at its frame. */
  private clip(drawing: SVGSVGElement): void {
    const { left, right, top, bottom } = this.frame;
    const id = `frame-${this.chart.name}`;
    const path = svg("clipPath", { id });
    path.append(svg("rect", { x: left, y: top, width: Math.max(right - left, 0), height: Math.max(bottom - top, 0) }));
    drawing.prepend(path);
    for (const part of drawing.querySelectorAll(".clipped")) {
      part.setAttribute("clip-path", `url(#${id})`);
      part.removeAttribute("class");
    }
    this.marks.setAttribute("clip-path", `url(#${id})`);
  }

  /** To a part or a multiple of what is shown, about its middle. */
  private zoom(factor: number): void {
    const { left, right, top, bottom } = this.frame;
    const [cx, cy] = [(left + right) / 2, (top + bottom) / 2];
    const [dx, dy] = [(factor * (right - left)) / 2, (factor * (bottom - top)) / 2];
    this.showPart(cx - dx, cy - dy, cx + dx, cy + dy);
  }

  /** What is between places of the drawing, in a plan as much more as its frame holds. */
  private showPart(left: number, top: number, right: number, bottom: number): void {
    if (this.chart.isPlan) {
      const { frame } = this;
      const ratio = (frame.bottom - frame.top) / (frame.right - frame.left);
      const half = Math.max((right - left) / 2, (bottom - top) / 2 / ratio);
      const [cx, cy] = [(left + right) / 2, (top + bottom) / 2];
      [left, right, top, bottom] = [cx - half, cx + half, cy - half * ratio, cy + half * ratio];
    }
    const { whole } = this.chart;
    const part: View = { x: [this.places.xAt(left), this.places.xAt(right)], y: [this.places.yAt(bottom), this.places.yAt(top)] };
    const view: View = { x: within(part.x, whole.x), y: within(part.y, whole.y) };
    const isWhole = (["x", "y"] as const).every((axis) => view[axis][0] <= whole[axis][0] && view[axis][1] >= whole[axis][1]);
    if (isWhole) return this.show(whole);
    // A plan keeps its scale: it moves to stay inside of the whole.
    this.show(this.chart.isPlan ? { x: moved(part.x, whole.x), y: moved(part.y, whole.y) } : view);
  }

  private placeOf(event: MouseEvent): [number, number] {
    const frame = this.drawing.getBoundingClientRect();
    const scale = this.drawing.viewBox.baseVal.width / frame.width;
    return [(event.clientX - frame.left) * scale, (event.clientY - frame.top) * scale];
  }

  private isInFrame([x, y]: [number, number]): boolean {
    const { left, right, top, bottom } = this.frame;
    return x >= left - 2 && x <= right + 2 && y >= top - 2 && y <= bottom + 2;
  }

  private listen(): void {
    const { drawing, chart, selection } = this;
    let from: [number, number] | null = null;
    const box = svg("rect", { class: "zooming", visibility: "hidden" });
    drawing.append(box);
    const sides = ([x, y]: [number, number]): [number, number, number, number] => [
      Math.max(Math.min(x, from![0]), this.frame.left), Math.max(Math.min(y, from![1]), this.frame.top),
      Math.min(Math.max(x, from![0]), this.frame.right), Math.min(Math.max(y, from![1]), this.frame.bottom),
    ];
    const isDrawn = (place: [number, number]): boolean => from !== null && Math.hypot(place[0] - from[0], place[1] - from[1]) > 8;
    drawing.addEventListener("pointerdown", (event) => {
      const place = this.placeOf(event);
      // Fingers scroll the page; they have the buttons.
      if (event.button !== 0 || event.pointerType === "touch" || !this.isInFrame(place)) return;
      from = place;
      drawing.setPointerCapture(event.pointerId);
    });
    drawing.addEventListener("pointermove", (event) => {
      const place = this.placeOf(event);
      if (isDrawn(place)) {
        const [left, top, right, bottom] = sides(place);
        for (const [name, value] of Object.entries({ x: left, y: top, width: Math.max(right - left, 0), height: Math.max(bottom - top, 0), visibility: "visible" })) box.setAttribute(name, String(value));
      }
      selection.hover(chart.itemAt && this.isInFrame(place) && !isDrawn(place) ? chart.itemAt(...place, this.places) : null);
    });
    drawing.addEventListener("pointerleave", () => selection.hover(null));
    drawing.addEventListener("pointercancel", () => {
      from = null;
      box.setAttribute("visibility", "hidden");
    });
    drawing.addEventListener("pointerup", (event) => {
      const place = this.placeOf(event);
      const part = isDrawn(place) ? sides(place) : null;
      from = null;
      box.setAttribute("visibility", "hidden");
      if (part && part[2] > part[0] + 2 && part[3] > part[1] + 2) this.showPart(...part);
      else if (!part && chart.itemAt && this.isInFrame(place)) selection.select(chart.itemAt(...place, this.places));
    });
    drawing.addEventListener("dblclick", () => this.show(chart.whole));
  }

  private mark(): void {
    const { chart, selection } = this;
    if (!chart.markOf) return;
    const drawn: SVGElement[] = [];
    for (const [item, name] of [[selection.hovered, "mark hovered"], [selection.selected, "mark selected"]] as const) {
      const mark = item && chart.markOf(item, this.places);
      mark?.setAttribute("class", name);
      if (mark) drawn.push(mark);
    }
    this.marks.replaceChildren(...drawn);
  }
}

/** A range of the same width inside of another. */
function moved([low, high]: [number, number], [least, most]: [number, number]): [number, number] {
  const by = low < least ? least - low : high > most ? most - high : 0;
  return [low + by, high + by];
}

export const chartElement = (chart: Chart, selection: Selection): HTMLElement => new DrawnChart(chart, selection).element;
