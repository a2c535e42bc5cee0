// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { type Covariances, largestWords } from "./error_ellipses";
import { counted } from "./format";
import type { Counts, NetFile } from "./result";

/** The top of the page: a title, what was done, three sentences, some numbers. */
export interface Summary {
  title: string;
  done: string;
  sentences: string[];
  figures: { value: string; unit: string; label: string }[];
}

export const nameOf = (net: Counts): string => (net.name ? `“${net.name}”` : "the net");

export function netWords(net: Counts): string {
  return [
    [net.free_nodes, "free node"], [net.supports, "support"],
    [net.interior_edges, "interior edge"], [net.adjustable_edges, "adjustable edge"],
  ].filter(([count]) => typeof count === "number")
    .map(([count, noun]) => counted(count as number, noun as string)).join(", ");
}

/** How lengths deviate by a prior, as it follows "lengths deviate": "uniform:5mm" is "uniformly within ±5 mm". */
export function priorWords(prior = ""): string {
  const [kind, size = ""] = prior.split(":");
  const scale = size.replace(/([\d.])([a-z])/, "$1 $2");
  if (kind === "uniform") return `uniformly within ±${scale}`;
  if (kind === "normal") return `normally with a standard deviation of ${scale}`;
  if (kind === "bimodal") return `by about −${scale} or +${scale}`;
  return prior ? `by the prior ${prior}` : "at random";
}

/** How well the least known place of a form is known; nothing without covariances. */
export function ellipseWords(net: NetFile, covariances: Covariances | null | undefined, which: string): string {
  const largest = largestWords(covariances ?? [], (node) => net.node_ids?.[node] ?? String(node));
  return largest ? ` The largest 95 % error ellipse of the ${which} form in plan has ${largest}.` : "";
}
