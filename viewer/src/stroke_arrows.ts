// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { Vector3 } from "three";
import { linear, palette } from "./colours";
import { extentOf } from "./extent";
import { endsFromOutside, type Model } from "./model";

// Arrows outside the support of each edge to be turned, in line with it, where nothing else is drawn:
// out of the net to shorten the edge, towards it to lengthen the edge.

/** Of the net's extent: the longest arrow, the shortest, and an arrow's distance from its support. */
const longest = 0.09;
const shortest = 0.015;
const gap = 0.008;
/** Lines of an arrow: its shaft, and two pairs of barbs, one of which is seen from any side. */
const linesEach = 5;

/** The edge's support and the direction out of the net there; where neither end is one, its first node. */
function outwards(model: Model, positions: Float32Array, edge: number): [Vector3, Vector3] {
  const [outer, inner] = endsFromOutside(model, edge);
  const at = new Vector3().fromArray(positions, 3 * outer);
  return [at, at.clone().sub(new Vector3().fromArray(positions, 3 * inner)).normalize()];
}

/** The lines of all arrows, six coordinates each. */
export function arrowLines(model: Model, positions: Float32Array): Float32Array {
  const extent = extentOf(model.form);
  const most = Math.max(...[...model.strokes.values()].map(Math.abs));
  const result: number[] = [];
  for (const [edge, stroke] of model.strokes) {
    const [support, out] = outwards(model, positions, edge);
    const length = extent * Math.max((longest * Math.abs(stroke)) / most, shortest);
    const near = support.clone().addScaledVector(out, gap * extent);
    const far = near.clone().addScaledVector(out, length);
    const [tail, tip, along] = stroke < 0 ? [near, far, out] : [far, near, out.clone().negate()];
    const barb = Math.min(0.4 * length, 0.018 * extent);
    const across = new Vector3(0, 0, 1).cross(along);
    if (across.lengthSq() < 1e-6) across.set(1, 0, 0);
    across.normalize();
    result.push(...tail.toArray(), ...tip.toArray());
    for (const side of [across, along.clone().cross(across)]) {
      for (const sign of [1, -1]) {
        const end = tip.clone().addScaledVector(along, -barb).addScaledVector(side, 0.55 * sign * barb);
        result.push(...tip.toArray(), ...end.toArray());
      }
    }
  }
  return new Float32Array(result);
}

/** Blue shortens, orange lengthens, as on the colour scale of strokes. */
export function strokeColours(model: Model): Float32Array {
  const [shorten, lengthen] = [linear(palette.blue), linear(palette.orange)];
  return Float32Array.from([...model.strokes.values()].flatMap((stroke) => Array(2 * linesEach).fill(stroke < 0 ? shorten : lengthen).flat() as number[]));
}
