// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

/** Largest side of the box around places, three coordinates each. */
export function extentOf(positions: Float32Array): number {
  let extent = 0;
  for (let k = 0; k < 3; ++k) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < positions.length; i += 3) [low, high] = [Math.min(low, positions[i]!), Math.max(high, positions[i]!)];
    extent = Math.max(extent, high - low);
  }
  return extent;
}
