// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

export type Rgb = readonly [number, number, number];

const hex = (text: string): Rgb => [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16) / 255) as unknown as Rgb;

// Both maps work with every kind of colour vision. Viridis grows evenly brighter; the
// other parts blue from orange, with a grey between them that stands out from light and dark.
const viridis = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"].map(hex);
const diverging = ["#0b4f9e", "#2f7fc4", "#79b0dc", "#b9bfc4", "#e9a95c", "#d8731b", "#9a4300"].map(hex);

/** After Okabe and Ito, distinguishable with every kind of colour vision. */
export const palette = {
  grey: hex("#8a949e"),
  orange: hex("#d55e00"),
  blue: hex("#0072b2"),
  green: hex("#009e73"),
  yellow: hex("#e0a800"),
} as const;

function along(map: readonly Rgb[], position: number): Rgb {
  const place = Math.min(Math.max(position, 0), 1) * (map.length - 1);
  const below = Math.min(Math.floor(place), map.length - 2);
  const part = place - below;
  const [a, b] = [map[below]!, map[below + 1]!];
  return [0, 1, 2].map((i) => (1 - part) * a[i]! + part * b[i]!) as unknown as Rgb;
}

/** As the renderer mixes colours: linear in light, turned back on the screen. */
export function linear(colour: Rgb): Rgb {
  return colour.map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)) as unknown as Rgb;
}

/** The colour at a position in [0, 1] of one of the two maps. */
export function colourAt(kind: "sequential" | "diverging", position: number): Rgb {
  return along(kind === "sequential" ? viridis : diverging, position);
}

export function css([r, g, b]: Rgb): string {
  return `rgb(${[r, g, b].map((c) => Math.round(255 * c)).join(" ")})`;
}
