// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import type { Model } from "./model";
import type { Item } from "./selection";

/** The distance between a place and a line on the screen. */
function distanceToLine(x: number, y: number, ax: number, ay: number, bx: number, by: number): number {
  const [dx, dy] = [bx - ax, by - ay];
  const along = Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1), 0), 1);
  return Math.hypot(x - ax - along * dx, y - ay - along * dy);
}

/**
 * The node or edge nearest to a place, within a reach; nodes first, where the place is nearer to
 * them than two thirds of it. A plain loop: a million edges take some milliseconds.
 * @param screen places of all nodes
 */
export function nearestItem(model: Model, screen: Float32Array, x: number, y: number, reach: number): Item | null {
  let best: Item | null = null;
  let least = 0.66 * reach;
  for (let i = 0; i < model.nodeCount; ++i) {
    const distance = Math.hypot(screen[2 * i]! - x, screen[2 * i + 1]! - y);
    if (distance < least) [best, least] = [{ of: "node", index: i }, distance];
  }
  if (best) return best;
  least = reach;
  for (let e = 0; e < model.edgeCount; ++e) {
    const [s, t] = [2 * model.ends[2 * e]!, 2 * model.ends[2 * e + 1]!];
    const distance = distanceToLine(x, y, screen[s]!, screen[s + 1]!, screen[t]!, screen[t + 1]!);
    if (distance < least) [best, least] = [{ of: "edge", index: e }, distance];
  }
  return best;
}
