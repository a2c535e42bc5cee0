// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { svg } from "./dom";
import { nice } from "./format";
import { endsFromOutside, type Model } from "./model";
import { axisNames, placeIn, type Side } from "./net_map";
import { mostInPlan, thinned } from "./thinning";

type Point = [number, number];
interface Box { left: number; right: number; top: number; bottom: number }

// All sizes are millimetres on an A4 sheet.
const widest = 150;
const highest = 72;
const radius = 2.5;
const textHeight = 2.4;
const letterWidth = 0.56 * textHeight;
const longestName = 10;
/** From a name to what belongs to another number: it is read with the nearest. */
const apart = 3.5;

const overlap = (a: Box, b: Box): boolean => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** A number in a ring and the support's name beside it, at a place from which the cable comes. */
interface Label { number: string; name: string; at: Point; middle: Point }

const cut = (name: string): string => (name.length > longestName ? `${name.slice(0, longestName - 1)}…` : name);

/** Half the width of the ring. */
const halfWidth = (number: string): number => Math.max(radius, 0.6 * letterWidth * number.length + 0.8);

/** Boxes of the ring, and of the name on the side away from the net with its distance from others. */
function boxesOf({ number, name, at, middle: [x, y] }: Label): Box[] {
  const half = halfWidth(number);
  const ring = { left: x - half, right: x + half, top: y - radius, bottom: y + radius };
  const width = letterWidth * cut(name).length + apart;
  const left = x >= at[0] ? x + half : x - half - width;
  return name ? [ring, { left, right: left + width, top: y - textHeight / 2, bottom: y + textHeight / 2 }] : [ring];
}

/** Where labels are tried: as near as can be, rather outwards than aside. */
const places = [1.3, 1.8, 2.4, 3, 4, 5, 6, 7, 8, 10, 12, 14].flatMap((distance) =>
  [0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2, 1.6, -1.6, 2.1, -2.1, 2.6, -2.6].map((angle) => ({ distance: radius * distance, angle })))
  .sort((a, b) => a.distance + radius * Math.abs(a.angle) - b.distance - radius * Math.abs(b.angle));

/** Puts the label where it meets no other, and hides no cable. */
function placed(number: string, name: string, at: Point, out: Point, labels: Box[], cables: Box[]): Label {
  const all = places.map(({ distance, angle }): Label => {
    const direction: Point = [out[0] * Math.cos(angle) - out[1] * Math.sin(angle), out[0] * Math.sin(angle) + out[1] * Math.cos(angle)];
    return { number, name, at, middle: [at[0] + distance * direction[0], at[1] + distance * direction[1]] };
  });
  const meets = (box: Box, others: Box[]): boolean => others.some((other) => overlap(box, other));
  return all.find((label) => {
    const boxes = boxesOf(label);
    return !boxes.some((box) => meets(box, labels) || meets(box, cables));
  }) ?? all[0]!;
}

/** The box around some nodes. */
function boxOf(nodes: Iterable<number>, place: (node: number) => Point): Box {
  const box: Box = { left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity };
  for (const node of nodes) {
    const [x, y] = place(node);
    Object.assign(box, { left: Math.min(box.left, x), right: Math.max(box.right, x), top: Math.min(box.top, y), bottom: Math.max(box.bottom, y) });
  }
  return box;
}

/** The part of the net that a sheet shows: around its cables, and no smaller than a third of the net. */
function windowOf(all: Box, some: Box): Box {
  const span = (low: number, high: number, least: number, greatest: number): Point => {
    const size = Math.max(1.3 * (high - low), (greatest - least) / 3, 1e-9);
    const middle = (low + high) / 2;
    return [Math.max(middle - size / 2, least), Math.min(middle + size / 2, greatest)];
  };
  const [left, right] = span(some.left, some.right, all.left, all.right);
  const [top, bottom] = span(some.top, some.bottom, all.top, all.bottom);
  return { left, right, top, bottom };
}

/** What stands in the way of labels along a line. */
const alongLine = ([a, b]: Point, [c, d]: Point): Box[] => [0.15, 0.35, 0.55, 0.75, 0.95].map((part) => {
  const [x, y] = [a + part * (c - a), b + part * (d - b)];
  return { left: x - 0.5, right: x + 0.5, top: y - 0.5, bottom: y + 0.5 };
});

function text(x: number, y: number, content: string, attributes: Record<string, string> = {}): SVGElement {
  const element = svg("text", { x, y, ...attributes });
  element.textContent = content;
  return element;
}

const lineOf = (a: Point, b: Point): string => `M${a[0].toFixed(2)},${a[1].toFixed(2)}L${b[0].toFixed(2)},${b[1].toFixed(2)}`;

let drawings = 0;

/**
 * The part of the net in which a sheet's cables are, with their numbers and supports, and where that part lies.
 * @param numbers of the edges that the sheet lists; @param turned all edges of the crew
 */
export function crewDrawing(model: Model, side: Side, numbers: Map<number, string>, turned: number[]): SVGElement {
  const place = placeIn(model.form, side);
  // Down the sheet is down the net.
  const downwards = (node: number): Point => { const [x, y] = place(node); return [x, -y]; };
  const endsOf = (edge: number): [number, number] => [model.ends[2 * edge]!, model.ends[2 * edge + 1]!];
  const onSheet = [...numbers.keys()];
  const all = boxOf(Array(model.nodeCount).keys(), downwards);
  const seen = windowOf(all, boxOf(onSheet.flatMap(endsOf), downwards));
  const scale = Math.min(widest / (seen.right - seen.left || 1), highest / (seen.bottom - seen.top || 1));
  const on = (node: number): Point => { const [x, y] = downwards(node); return [scale * (x - seen.left), scale * (y - seen.top)]; };
  const size: Point = [scale * (seen.right - seen.left), scale * (seen.bottom - seen.top)];
  const edgePath = (edges: readonly number[], at = on): string => edges.map((edge) => { const [s, t] = endsOf(edge); return lineOf(at(s), at(t)); }).join("");

  const taken: Box[] = [];
  const cables = onSheet.flatMap((edge) => { const [s, t] = endsOf(edge); return alongLine(on(s), on(t)); });
  const labels = onSheet.map((edge) => {
    const [support, inner] = endsFromOutside(model, edge);
    const isHeld = model.isSupport[support] === 1;
    const [outer, free] = [on(support), on(inner)];
    const at: Point = isHeld ? outer : [(outer[0] + free[0]) / 2, (outer[1] + free[1]) / 2];
    const along: Point = isHeld ? [outer[0] - free[0], outer[1] - free[1]] : [at[0] - size[0] / 2, at[1] - size[1] / 2];
    const length = Math.hypot(...along);
    const label = placed(numbers.get(edge)!, isHeld ? model.nodeId(support) : "", at, length > 1e-6 ? [along[0] / length, along[1] / length] : [0, -1], taken, cables);
    taken.push(...boxesOf(label));
    return label;
  });

  const boxes = [{ left: 0, right: size[0], top: 0, bottom: size[1] }, ...labels.flatMap(boxesOf)];
  const left = Math.min(...boxes.map((box) => box.left));
  const top = Math.min(...boxes.map((box) => box.top));
  const right = Math.max(...boxes.map((box) => box.right), left + 110);
  // The whole net below, in which the part is framed; at its left the axes and the scale.
  const keyScale = Math.min(34 / (all.right - all.left || 1), 15 / (all.bottom - all.top || 1));
  const bottom = Math.max(...boxes.map((box) => box.bottom)) + 3;
  const inKey = ([x, y]: Point): Point => [right - keyScale * (all.right - x) - 1, bottom + keyScale * (y - all.top)];
  const below = bottom + 14;
  const corners = [inKey([seen.left, seen.top]), inKey([seen.right, seen.bottom])] as const;
  const border = 1.5;
  const drawing = svg("svg", { class: "crew-drawing", viewBox: `${left - border} ${top - border} ${right - left + 2 * border} ${below - top + 2 * border}`, role: "img" });
  drawing.style.maxWidth = `${right - left + 2 * border}mm`;
  drawing.setAttribute("aria-label", `The net seen ${side.seen}, with the numbers of the cables to turn`);
  const name = `crew-drawing-${++drawings}`;
  const clip = svg("clipPath", { id: name });
  clip.append(svg("rect", { x: -1, y: -1, width: size[0] + 2, height: size[1] + 2 }));
  const arrow = svg("marker", { id: `${name}-arrow`, viewBox: "0 0 6 6", refX: 5, refY: 3, markerWidth: 5, markerHeight: 5, orient: "auto" });
  arrow.append(svg("path", { d: "M0,0L6,3L0,6Z" }));
  const axis = (x: number, y: number): SVGElement => svg("path", { class: "axis", d: `M${left + 1},${below}L${x},${y}`, "marker-end": `url(#${name}-arrow)` });
  const bar = nice((0.3 * size[0]) / scale);
  const everyEdge = Array.from({ length: model.edgeCount }, (_, edge) => edge);
  const inSight = (edge: number): boolean => {
    const box = boxOf(endsOf(edge), downwards);
    return box.right >= seen.left && box.left <= seen.right && box.bottom >= seen.top && box.top <= seen.bottom;
  };
  drawing.append(clip, arrow,
    svg("path", { class: "net-line", d: edgePath(thinned(everyEdge.filter(inSight), mostInPlan)), "clip-path": `url(#${name})` }),
    svg("path", { class: "turned-line", d: edgePath(turned.filter(inSight)), "clip-path": `url(#${name})` }),
    svg("path", { class: "sheet-line", d: edgePath(onSheet) }),
    svg("path", { class: "leader", d: labels.map(({ at, middle }) => lineOf(at, middle)).join("") }),
    ...labels.flatMap((label) => {
      const [cx, cy] = label.middle;
      const half = halfWidth(label.number);
      const isRight = cx >= label.at[0];
      return [svg("rect", { class: "ring", x: cx - half, y: cy - radius, width: 2 * half, height: 2 * radius, rx: radius }),
        text(cx, cy + 0.36 * textHeight, label.number, { class: "number", "text-anchor": "middle" }),
        text(cx + (isRight ? 1 : -1) * (half + 0.5), cy + 0.36 * textHeight, cut(label.name), { "text-anchor": isRight ? "start" : "end" })];
    }),
    axis(left + 9, below), axis(left + 1, below - 8),
    text(left + 10.5, below + 0.9, axisNames[side.right]), text(left + 0.3, below - 9.5, axisNames[side.up]), text(left + 14, below + 0.9, `seen ${side.seen}`),
    svg("path", { class: "axis", d: `M${left + 14},${below - 6}v2M${left + 14},${below - 5}h${scale * bar}m0,-1v2` }), text(left + 15.5 + scale * bar, below - 4.1, `${bar} m`),
    svg("path", { class: "net-line", d: edgePath(thinned(everyEdge, 1500), (node) => inKey(downwards(node))) }),
    svg("rect", { class: "window", x: corners[0][0], y: corners[0][1], width: corners[1][0] - corners[0][0], height: corners[1][1] - corners[0][1] }));
  return drawing;
}
