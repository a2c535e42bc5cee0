// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { css, type Rgb } from "./colours";
import { fixed, millimetres } from "./format";

// The places of the nodes as random: of two coordinates that are normally distributed, 95 % lie in the
// ellipse whose semi-axes are this many standard deviations long.
const standardDeviations = Math.sqrt(-2 * Math.log(0.05));

type Vector = readonly [number, number, number];
/** Of the nodes' places, xx, xy, xz, yy, yz, zz each [m²]. */
export type Covariances = readonly (readonly number[])[];

/** Semi-axes, and the angle of the larger one from the first axis of the picture towards the second. */
export interface Ellipse {
  major: number;
  minor: number;
  angle: number;
}

/**
 * The 95 % ellipse of a place in a picture: the outline of what its covariance looks like from there.
 * @param covariance xx, xy, xz, yy, yz, zz; @param across, along how the picture's coordinates change with x, y and z
 */
export function ellipseOf(covariance: ArrayLike<number>, across: Vector, along: Vector): Ellipse {
  const [xx, xy, xz, yy, yz, zz] = Array.from(covariance) as [number, number, number, number, number, number];
  const times = ([x, y, z]: Vector): Vector => [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z];
  const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const [uu, uv, vv] = [dot(across, times(across)), dot(across, times(along)), dot(along, times(along))];
  const [mean, half] = [(uu + vv) / 2, Math.hypot((uu - vv) / 2, uv)];
  return {
    major: standardDeviations * Math.sqrt(Math.max(mean + half, 0)),
    minor: standardDeviations * Math.sqrt(Math.max(mean - half, 0)),
    angle: Math.atan2(2 * uv, uu - vv) / 2,
  };
}

/** In plan: seen from above, x to the right and y up [m]. */
const inPlan = (covariance: ArrayLike<number>): Ellipse => ellipseOf(covariance, [1, 0, 0], [0, 1, 0]);

/** Nodes whose place is uncertain, each with its covariance. */
export function uncertainNodes(covariances: Covariances): [node: number, covariance: readonly number[]][] {
  return covariances.map((covariance, node): [number, readonly number[]] => [node, covariance]).filter(([, c]) => c[0]! + c[3]! + c[5]! > 0);
}

/** Semi-major axes in plan, in millimetres; NaN where a node's place is known. */
export function semiMajorAxes(covariances: Covariances): Float64Array {
  const result = new Float64Array(covariances.length).fill(NaN);
  for (const [node, covariance] of uncertainNodes(covariances)) result[node] = 1e3 * inPlan(covariance).major;
  return result;
}

/** Of a node, for the inspector, besides its semi-major axis. */
export function ellipseRemarks(covariance: readonly number[]): [string, string][] {
  const { minor, angle } = inPlan(covariance);
  return [
    ["its semi-minor axis", `${fixed(1e3 * minor, 2)} mm`],
    ["direction of the major axis, from x to y", `${fixed((180 / Math.PI) * angle, 0)}°`],
    ["95 % interval of z", `±${fixed(1.96e3 * Math.sqrt(covariance[5]!), 2)} mm`],
  ];
}

/** "semi-axes of 3.10 × 1.20 mm at node 45": the largest ellipse in plan; nothing where no place is uncertain. */
export function largestWords(covariances: Covariances, nodeId: (node: number) => string): string {
  const all = uncertainNodes(covariances).map(([node, covariance]) => ({ node, ellipse: inPlan(covariance) }));
  if (all.length === 0) return "";
  const { node, ellipse } = all.reduce((a, b) => (b.ellipse.major > a.ellipse.major ? b : a));
  return `semi-axes of ${millimetres(ellipse.major)} × ${millimetres(ellipse.minor)} mm at node ${nodeId(node)}`;
}

/**
 * The exaggeration at which the median ellipse hardly meets its neighbours; 1 where no place is uncertain.
 * @param spacing mean distance of neighbours
 */
export function clearExaggeration(covariances: Covariances, spacing: number): number {
  const sizes = uncertainNodes(covariances).map(([, c]) => standardDeviations * Math.sqrt(c[0]! + c[3]! + c[5]!)).sort((a, b) => a - b);
  const median = sizes[Math.floor(sizes.length / 2)];
  return median ? (0.5 * spacing) / median : 1;
}

/** Draws ellipses, their sizes in CSS pixels, around places of the picture. */
export function drawEllipses(context: CanvasRenderingContext2D, ellipses: { at: readonly [number, number]; ellipse: Ellipse }[], ink: Rgb): void {
  context.beginPath();
  for (const { at: [x, y], ellipse: { major, minor, angle } } of ellipses) {
    context.moveTo(x + major * Math.cos(angle), y + major * Math.sin(angle));
    context.ellipse(x, y, major, minor, angle, 0, 2 * Math.PI);
  }
  Object.assign(context, { strokeStyle: css(ink), lineWidth: 1, fillStyle: css(ink), globalAlpha: 0.1 });
  context.fill();
  context.globalAlpha = 1;
  context.stroke();
}
