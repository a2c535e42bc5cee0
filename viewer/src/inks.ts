// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Hues after Okabe and Ito, distinguishable with every kind of colour vision: each
// on white, and on the dark page.
const pairs = {
  ink: ["#222222", "#dddddd"],
  grid: ["#e4e4e4", "#333333"],
  faint: ["#b9c0c7", "#4a525a"],
  grey: ["#8a949e", "#78828c"],
  dim: ["#5a6067", "#a3abb3"],
  blue: ["#0072b2", "#56b4e9"],
  deep: ["#00527f", "#8fd3ff"],
  bar: ["#7fb0d0", "#3f7ba3"],
  orange: ["#d55e00", "#f58231"],
  amber: ["#f0b93a", "#a87400"],
  brown: ["#a87400", "#f0b93a"],
  green: ["#009e73", "#2fd0a2"],
  magenta: ["#b5177a", "#ff7cc8"],
} as const satisfies Record<string, readonly [string, string]>;

export type Ink = keyof typeof pairs;

/** A colour of the charts, which follows the page's light or dark ground. */
export const ink = (name: Ink): string => `var(--ink-${name})`;

/** The colours as the page's style knows them; what is printed is on white. */
export function inkStyle(): string {
  const of = (ground: 0 | 1): string => Object.entries(pairs).map(([name, pair]) => `--ink-${name}:${pair[ground]}`).join(";");
  return `:root{${of(0)}}@media screen and (prefers-color-scheme:dark){:root{${of(1)}}}`;
}

/** A drawing's text with each ink as it is on white. */
export function onWhite(text: string): string {
  return text.replace(/var\(--ink-([a-z]+)\)/g, (_, name: Ink) => pairs[name][0]).replaceAll("currentColor", pairs.ink[0]);
}
