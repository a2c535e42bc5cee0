// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { Color, Scene, Vector3, WebGLRenderer } from "three";
import { colourAt, linear, palette, type Rgb } from "./colours";
import { type EdgeLines, ThinLines, WideLines } from "./edge_lines";
import { drawEllipses, type Ellipse, ellipseOf, uncertainNodes } from "./error_ellipses";
import { type Displacement, type Model, type Quantity, rangeOf } from "./model";
import { NetCamera, type Viewpoint } from "./net_camera";
import { type Labelled, NetLabels, scaleBar } from "./net_labels";
import { discTexture, NodeDots } from "./node_dots";
import { nearestItem } from "./picking";
import type { Item, Selection } from "./selection";
import { arrowLines, strokeColours } from "./stroke_arrows";

/** More edges than this are drawn as lines one pixel wide. */
const mostWideLines = 8000;
/** While the view moves no more edges than this are drawn, so that it moves without a graphics card too. */
const mostWhileMoving = 30_000;
/** Steps of a colour scale. */
const levels = 256;

/** The same numbers in an order without order: the first of them are spread over all. */
function shuffled(numbers: number[]): number[] {
  let state = 1;
  for (let i = numbers.length - 1; i > 0; --i) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const j = Math.floor((state / 2 ** 32) * (i + 1));
    [numbers[i], numbers[j]] = [numbers[j]!, numbers[i]!];
  }
  return numbers;
}

interface Theme {
  ground: string;
  ink: Rgb;
  none: Rgb;
  mark: string;
}
const themes: Record<"light" | "dark", Theme> = {
  light: { ground: "#ffffff", ink: [0.13, 0.15, 0.17], none: [0.7, 0.73, 0.76], mark: "#e6007e" },
  dark: { ground: "#23282d", ink: [0.93, 0.94, 0.95], none: [0.36, 0.39, 0.42], mark: "#ff5cb0" },
};

/** The net in three dimensions. Draws only when something has changed. */
export class NetView {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera: NetCamera;
  private readonly groups: { edges: number[]; lines: EdgeLines }[];
  private readonly ghost = new ThinLines();
  private readonly arrows = new WideLines(3);
  private readonly selectedLine = new WideLines(7);
  private readonly hoveredLine = new WideLines(5);
  private readonly freeDots: NodeDots;
  private readonly supportDots: NodeDots;
  private readonly markDots: NodeDots;
  private readonly labels: NetLabels;
  private readonly freeNodes: number[];
  private readonly supports: number[];
  private readonly positions: Float32Array;
  private readonly uncertain: ReturnType<typeof uncertainNodes>;
  /** Of the nodes in the form that is known as well as the ellipses say; null where another one is shown. */
  private middles: Float32Array | null = null;
  private exaggeration = 0;
  private quantity: Quantity;
  private theme: Theme = themes.light;
  private screen: Float32Array | null = null;
  private pending = false;
  private resting = 0;

  constructor(container: HTMLElement, private readonly model: Model, private readonly selection: Selection) {
    const many = model.edgeCount > mostWideLines;
    this.renderer = new WebGLRenderer({ antialias: !many, preserveDrawingBuffer: true });
    this.canvas = this.renderer.domElement;
    this.labels = new NetLabels(model);
    container.append(this.canvas, this.labels.canvas);
    this.quantity = model.quantities[0]!;
    this.positions = model.form.slice();
    this.uncertain = uncertainNodes(model.covariances);

    const all = Array.from({ length: model.edgeCount }, (_, e) => e);
    if (many) shuffled(all);
    this.groups = [
      { edges: all.filter((e) => !model.isAdjustable[e] && !model.isStrut[e]), lines: many ? new ThinLines() : new WideLines(2.2) },
      { edges: all.filter((e) => model.isAdjustable[e] && !model.isStrut[e]), lines: many ? new ThinLines() : new WideLines(3.4) },
      { edges: all.filter((e) => model.isStrut[e]), lines: many ? new ThinLines() : new WideLines(6) },
    ];
    const nodes = Array.from({ length: model.nodeCount }, (_, i) => i);
    this.freeNodes = nodes.filter((i) => !model.isSupport[i]);
    this.supports = nodes.filter((i) => model.isSupport[i]);
    const disc = discTexture();
    const ratio = many ? 1 : Math.min(devicePixelRatio, 2);
    this.renderer.setPixelRatio(ratio);
    const size = Math.min(Math.max(90 / Math.sqrt(model.nodeCount), 1.5), 6) * ratio;
    this.freeDots = new NodeDots(size, many ? null : disc);
    this.supportDots = new NodeDots(many ? 2 * ratio : 1.4 * size, null);
    this.markDots = new NodeDots(13 * ratio, disc);
    (this.ghost.object.material as { transparent?: boolean; opacity?: number }).transparent = true;
    (this.ghost.object.material as { opacity?: number }).opacity = 0.8;
    // Marks are drawn last and over all else.
    for (const { material } of [this.selectedLine, this.hoveredLine, this.markDots.object]) Object.assign(material, { depthTest: false, transparent: true });
    this.arrows.object.visible = model.strokes.size > 0;
    if (model.strokes.size > 0) this.arrows.setColours(strokeColours(model));
    this.scene.add(this.ghost.object, this.arrows.object, ...this.groups.map((g) => g.lines.object), this.supportDots.object, this.freeDots.object,
      this.hoveredLine.object, this.selectedLine.object, this.markDots.object);
    this.selectedLine.object.renderOrder = this.hoveredLine.object.renderOrder = 1;
    this.markDots.object.renderOrder = 2;

    const arrows = arrowLines(model, model.form);
    const points = new Float32Array(model.form.length + arrows.length);
    points.set(model.form);
    points.set(arrows, model.form.length);
    this.camera = new NetCamera(this.canvas, points, () => this.move());
    this.listen();
    selection.subscribe(() => this.mark());
    new ResizeObserver(() => this.resize()).observe(container);
    this.theme = matchMedia("(prefers-color-scheme: dark)").matches ? themes.dark : themes.light;
    this.renderer.setClearColor(new Color(this.theme.ground));
    this.place(null, 0);
    this.mark();
    this.resize();
  }

  setTheme(dark: boolean): void {
    this.theme = dark ? themes.dark : themes.light;
    this.renderer.setClearColor(new Color(this.theme.ground));
    this.colour();
    this.mark();
  }

  setQuantity(quantity: Quantity): void {
    this.quantity = quantity;
    this.colour();
  }

  /** Shows base + factor * vectors, with the base behind it; the result's form where there is none. */
  setDisplacement(displacement: Displacement | null, factor: number): void {
    this.place(displacement, factor);
    this.colour();
    this.mark();
  }

  private place(displacement: Displacement | null, factor: number): void {
    const base = displacement?.base ?? this.model.form;
    for (let i = 0; i < base.length; ++i) {
      this.positions[i] = base[i]! + (displacement ? factor * displacement.vectors[i]! : 0);
    }
    this.middles = !displacement || displacement.certain === "end" ? this.positions : displacement.certain === "base" ? base : null;
    for (const { edges, lines } of this.groups) {
      if (edges.length > 0) lines.setPositions(this.endsOf(edges, this.positions));
      lines.object.visible = edges.length > 0;
    }
    if (this.model.strokes.size > 0) this.arrows.setPositions(arrowLines(this.model, this.positions));
    this.ghost.object.visible = displacement !== null && factor > 0;
    if (this.ghost.object.visible) {
      const all = this.groups.flatMap((g) => g.edges);
      this.ghost.setPositions(this.endsOf(all, base));
      const none = linear(this.theme.none);
      this.ghost.setColours(new Float32Array(6 * all.length).map((_, i) => none[i % 3]!));
    }
  }

  /** Draws the 95 % ellipses of the nodes' places so many times too large; none at 0. */
  setEllipses(exaggeration: number): void {
    this.exaggeration = exaggeration;
    this.request();
  }

  /** Whether the form that is shown has them. */
  get hasEllipses(): boolean {
    return this.middles !== null;
  }

  setViewpoint(viewpoint: Viewpoint): void {
    this.camera.setViewpoint(viewpoint);
    this.request();
  }

  setLabels(which: Labelled): void {
    this.labels.show(which);
    this.request();
  }

  /** Brings an edge or a node near. */
  lookAt({ of, index }: Item): void {
    const nodes = of === "edge" ? [this.model.ends[2 * index]!, this.model.ends[2 * index + 1]!] : [index];
    const middle = new Vector3();
    for (const node of nodes) middle.addScaledVector(new Vector3().fromArray(this.positions, 3 * node), 1 / nodes.length);
    this.camera.lookAt(middle);
    this.request();
  }

  /** Where a node stands on the canvas, in CSS pixels. */
  placeOf(node: number): [number, number] {
    const screen = this.projected();
    return [screen[2 * node]!, screen[2 * node + 1]!];
  }

  /** The ellipses as drawn, in CSS pixels. */
  ellipses(): { node: number; at: [number, number]; ellipse: Ellipse }[] {
    const { middles, exaggeration } = this;
    if (!middles || exaggeration === 0) return [];
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const screen = middles === this.positions ? this.projected() : this.camera.project(middles, width, height);
    const rates = this.camera.rates(width, height);
    return this.uncertain.flatMap(([node, covariance]) => {
      const rate = rates(middles.subarray(3 * node, 3 * node + 3));
      if (!rate) return [];
      const { major, minor, angle } = ellipseOf(covariance, ...rate);
      return [{ node, at: [screen[2 * node]!, screen[2 * node + 1]!], ellipse: { major: exaggeration * major, minor: exaggeration * minor, angle } }];
    });
  }

  /** Draws at once and gives the picture, for print. */
  picture(): string {
    const theme = this.theme;
    this.setTheme(false);
    this.draw();
    const { width, height } = this.canvas;
    const whole = Object.assign(document.createElement("canvas"), { width, height });
    const context = whole.getContext("2d")!;
    for (const layer of [this.canvas, this.labels.canvas]) context.drawImage(layer, 0, 0, width, height);
    const url = whole.toDataURL("image/png");
    this.theme = theme;
    this.setTheme(theme === themes.dark);
    return url;
  }

  private endsOf(edges: number[], positions: Float32Array): Float32Array {
    const result = new Float32Array(6 * edges.length);
    edges.forEach((e, i) => {
      for (let end = 0; end < 2; ++end) {
        const node = 3 * this.model.ends[2 * e + end]!;
        for (let k = 0; k < 3; ++k) result[6 * i + 3 * end + k] = positions[node + k]!;
      }
    });
    return result;
  }

  private nodePositions(nodes: number[]): Float32Array {
    const result = new Float32Array(3 * nodes.length);
    nodes.forEach((node, i) => result.set(this.positions.subarray(3 * node, 3 * node + 3), 3 * i));
    return result;
  }

  /** How to find the colour of an edge's or node's value; null where it has none. */
  private colouring(): (index: number) => Rgb | null {
    const { kind, values, names } = this.quantity;
    const [low, high] = kind === "names" ? [0, levels - 1] : rangeOf(this.model, this.quantity);
    const map = kind === "names"
      ? names!.map((name) => linear(name.colour))
      : Array.from({ length: levels }, (_, i) => linear(colourAt(kind, i / (levels - 1))));
    return (index) => {
      const value = values[index]!;
      return Number.isNaN(value) ? null : map[Math.round(((value - low) / (high - low)) * (levels - 1))]!;
    };
  }

  private colour(): void {
    const ofNodes = this.quantity.of === "node";
    const colourOf = this.colouring();
    const none = linear(this.theme.none);
    const ink = linear(this.theme.ink);
    const free = this.quantity.key === "kind" ? linear(palette.blue) : none;
    for (const { edges, lines } of this.groups) {
      if (edges.length === 0) continue;
      const colours = new Float32Array(6 * edges.length);
      edges.forEach((e, i) => {
        for (let end = 0; end < 2; ++end) {
          colours.set(colourOf(ofNodes ? this.model.ends[2 * e + end]! : e) ?? none, 6 * i + 3 * end);
        }
      });
      lines.setColours(colours);
    }
    for (const [nodes, dots] of [[this.freeNodes, this.freeDots], [this.supports, this.supportDots]] as const) {
      const colours = new Float32Array(3 * nodes.length);
      nodes.forEach((node, i) => {
        const own = ofNodes ? colourOf(node) : null;
        colours.set(own ?? (nodes === this.supports ? ink : free), 3 * i);
      });
      dots.set(this.nodePositions(nodes), colours);
    }
    this.freeDots.object.visible = ofNodes || this.model.edgeCount <= mostWideLines;
    const [scale, most] = ofNodes ? [160, 11] : this.quantity.key === "kind" ? [125, 8] : [70, 5];
    this.freeDots.object.material.size = Math.min(Math.max(scale / Math.sqrt(this.model.nodeCount), 1.5), most) * this.renderer.getPixelRatio();
    this.request();
  }

  private mark(): void {
    const colour = new Color(this.theme.mark);
    const dots: number[] = [];
    const show = (item: Item | null, lines: WideLines): void => {
      lines.object.visible = item?.of === "edge";
      if (item?.of === "edge") {
        lines.setPositions(this.endsOf([item.index], this.positions));
        lines.setColours(new Float32Array([...colour.toArray(), ...colour.toArray()]));
      } else if (item) {
        dots.push(item.index);
      }
    };
    show(this.selection.selected, this.selectedLine);
    show(this.selection.hovered, this.hoveredLine);
    this.markDots.object.visible = dots.length > 0;
    if (dots.length > 0) this.markDots.set(this.nodePositions(dots), new Float32Array(dots.flatMap(() => colour.toArray())));
    this.request();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement!;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    this.camera.setAspect(width / height);
    this.request();
  }

  /** Places of all nodes on the canvas; points behind the camera are not excluded. */
  private projected(): Float32Array {
    this.screen ??= this.camera.project(this.positions, this.canvas.clientWidth, this.canvas.clientHeight);
    return this.screen;
  }

  private itemAt(event: PointerEvent): Item | null {
    const frame = this.canvas.getBoundingClientRect();
    const reach = event.pointerType === "touch" ? 18 : 9;
    return nearestItem(this.model, this.projected(), event.clientX - frame.left, event.clientY - frame.top, reach);
  }

  private listen(): void {
    let down: [number, number] | null = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      down = [event.clientX, event.clientY];
    });
    this.canvas.addEventListener("pointerup", (event) => {
      // A click, not the end of a drag.
      if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 5) this.selection.select(this.itemAt(event));
      down = null;
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (!down && event.pointerType !== "touch") this.selection.hover(this.itemAt(event));
    });
    this.canvas.addEventListener("pointerleave", () => this.selection.hover(null));
    this.canvas.addEventListener("keydown", (event) => {
      const step = 0.1;
      const turns: Record<string, [number, number, number?]> = {
        ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step],
        "+": [0, 0, 1.15], "=": [0, 0, 1.15], "-": [0, 0, 1 / 1.15],
      };
      const turn = turns[event.key];
      if (turn) {
        this.camera.turn(...turn);
        this.request();
      }
      else if (event.key === "Home") this.setViewpoint(this.camera.viewpoint);
      else if (event.key === "Escape") this.selection.select(null);
      else return;
      event.preventDefault();
    });
  }

  /** The camera has moved: a part of a large net now, all of it when the camera rests. */
  private move(): void {
    if (this.model.edgeCount > mostWhileMoving) {
      this.limit(mostWhileMoving);
      clearTimeout(this.resting);
      this.resting = window.setTimeout(() => {
        this.limit(Infinity);
        this.request();
      }, 250);
    }
    this.request();
  }

  /** Draws no more edges than so many, in all groups as large a part. */
  private limit(most: number): void {
    const part = Math.min(1, most / this.model.edgeCount);
    for (const { edges, lines } of this.groups) lines.setCount(Math.ceil(part * edges.length));
  }

  private request(): void {
    this.screen = null;
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => this.draw());
  }

  private draw(): void {
    this.pending = false;
    this.renderer.render(this.scene, this.camera.current);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const look = { ink: `rgb(${this.theme.ink.map((part) => Math.round(255 * part)).join(" ")})`, ground: this.theme.ground };
    const metres = this.camera.metresPerPixel(height);
    const bars = metres === null ? [] : [scaleBar(metres, width, "m")];
    const ellipses = this.ellipses();
    if (metres !== null && ellipses.length > 0) bars.push(scaleBar((1e3 * metres) / this.exaggeration, width, "mm of the 95 % ellipses"));
    this.labels.draw(this.projected(), { width, height, ratio: this.renderer.getPixelRatio() }, look, this.selection.selected,
      (context) => drawEllipses(context, ellipses, this.theme.ink), bars);
  }
}
