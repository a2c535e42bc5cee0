// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import type { ControlResidual, Identification, IdentifiedEdge, Method, NetFile, Result, Study } from "./result_schema";

// The results as taut writes them (docs/files.md), in SI units. taut has checked them before it
// made the page.
export type {
  Assumption, Comparison, ComparisonRow, Control, ControlResidual, ControlRound, ControlStrategy, Counts, Detectable, Finding, FormDeviation, FormErrorSummary,
  Identification, IdentifiedEdge, LimitBreach, Method, NetFile, Outlier, Plan, PlannedTension, Result, Study, TargetTension, Turn,
} from "./result_schema";

/** The methods of a study, first the one that gave its lengths and forms. */
export function methodsOf(study: Study): [string, Method][] {
  const first = "gp_as_in_paper";
  return Object.entries(study.methods).sort(([a], [b]) => Number(b === first) - Number(a === first));
}

/** Whether the survey gives only a lower bound of the edge's length. */
export const isSlack = (edge: IdentifiedEdge): boolean => edge.status === "slack";

/** How well the survey determines an edge's length. */
export type Status = "determined" | "weakly_determined" | "not_determined" | "slack";

/** Version 0.2.0 called edges identified or unobserved. */
export function statusOf({ status }: IdentifiedEdge): Status {
  if (status === "identified") return "determined";
  return status === "unobserved" ? "not_determined" : status;
}

export const isNotDetermined = (edge: IdentifiedEdge): boolean => statusOf(edge) === "not_determined";

/** The control points that the survey's frame was fitted to; older results have no `frame`. */
export const controlOf = (result: Identification): ControlResidual[] => result.frame?.control ?? result.survey.control ?? [];

/** Length of a residual [m]. */
export const lengthOf = ({ dx, dy, dz }: { dx: number; dy: number; dz: number }): number => Math.hypot(dx, dy, dz);

/** The result inside the page. Throws a message for the reader where it is not one. */
export function readResult(text: string): Result {
  const result = JSON.parse(text) as Result;
  const known = ["taut-study", "taut-identification", "taut-comparison", "taut-plan", "taut-control"];
  if (!known.includes(result?.format)) throw new Error(`its format is ${String(result?.format)}, expected one of ${known.join(", ")}`);
  if (result.version !== 2) throw new Error(`its version is ${String((result as Result).version)}, expected 2`);
  return result;
}

/** Whether an edge carries compression, too. Its kind is a key of a net that the schema of results does not describe. */
export function isStrut(net: NetFile, edge: number): boolean {
  return (net as { kind?: string[] }).kind?.[edge] === "strut";
}

/** Whether the i-th support gives way. Its stiffness is a key of a net that the schema of results does not describe. */
export function isElastic(net: NetFile, i: number): boolean {
  return ((net as { support_stiffness?: unknown[] }).support_stiffness?.[i] ?? null) !== null;
}

/** How many force measurements all but unlikely priors left out. */
export function leftOut(outliers: readonly { probability?: number }[]): number {
  return outliers.filter(({ probability }) => (probability ?? 1) > 0.95).length;
}
