// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

/** More edges than this would stand closer in a chart than its dots are wide. */
export const mostAlong = 1000;
/** More nodes or edges than this say no more in a plan of the net, and make it slow. */
export const mostInPlan = 4000;

/**
 * About `limit` of some things, in their order and evenly spread; all of them where they are no
 * more. Not every n-th: in the order of a regular net that could be all edges of one direction.
 */
export function thinned<T>(all: readonly T[], limit: number): readonly T[] {
  if (all.length <= limit) return all;
  const part = limit / all.length;
  // The multiples of the golden ratio, less their whole part, fill [0, 1) more evenly than those of
  // any other number, and keep no step with the order of a net.
  const golden = (1 + Math.sqrt(5)) / 2;
  return all.filter((_, i) => (golden * i) % 1 < part);
}

/** Caption text for a chart that draws only part of its items. */
export function thinningWords(parts: [count: number, limit: number, noun: string][]): string {
  const some = parts.filter(([count, limit]) => count > limit)
    .map(([count, limit, noun]) => `about ${limit} of ${count} ${noun}s`);
  return some.length === 0 ? "" : ` The chart shows ${some.join(" and ")}; zoom in to see all.`;
}
