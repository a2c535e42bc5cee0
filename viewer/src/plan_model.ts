// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { addCovariances, difference, distances, flat, type Model, netOf, type Quantity, quantity } from "./model";
import type { Plan, PlannedTension } from "./result";

const kN = 1e-3;

/** Change of each edge's length by all turns [m]. */
export function strokesOf(plan: Plan): Map<number, number> {
  const strokes = new Map<number, number>();
  for (const { edge, stroke } of plan.turns) strokes.set(edge, (strokes.get(edge) ?? 0) + stroke);
  return strokes;
}

/** Whether an edge has a limit besides that it may not go slack. */
export const hasLimit = (t: PlannedTension): boolean => Boolean(t.limit_lower) || t.limit_upper !== null;

/** Margin of an edge's planned tension to the nearest of its limits; negative where exceeded [N]. */
export const marginOf = (t: PlannedTension): number => Math.min(t.planned - (t.limit_lower ?? -Infinity), (t.limit_upper ?? Infinity) - t.planned);

function tensions(plan: Plan): Quantity[] {
  const { edges } = plan.tension;
  const of = (value: (t: PlannedTension) => number | null): number[] => edges.map((t) => kN * (value(t) ?? NaN));
  const tension = { unit: "kN", of: "edge", kind: "sequential", decimals: 3, scale: "tension", fromLowest: true } as const;
  const interval = plan.draws > 0 ? { interval: { lower: Float64Array.from(of((t) => t.lower)), upper: Float64Array.from(of((t) => t.upper)) } } : {};
  const limits = edges.some(hasLimit);
  return [
    quantity({ ...tension, key: "tension_built", label: "tension, as built", head: "tension, built", values: of((t) => t.as_built) }),
    quantity({ ...tension, key: "tension_planned", label: "tension, as planned", head: "tension, planned", values: of((t) => t.planned), ...interval }),
    ...(edges.some((t) => t.limit_upper !== null) ? [
      quantity({ key: "utilisation", label: "utilisation: planned tension over its upper limit", head: "utilisation", unit: "%", of: "edge", kind: "sequential", decimals: 1, values: edges.map((t) => (t.limit_upper ? (100 * t.planned) / t.limit_upper : NaN)) }),
    ] : []),
    ...(limits ? [
      quantity({ key: "margin", label: "margin of the planned tension to the nearest limit", head: "margin to limit", unit: "kN", of: "edge", kind: "diverging", decimals: 3, values: of(marginOf) }),
    ] : []),
  ];
}

/** Force of the cables on each support [kN]. */
function reactions(plan: Plan, model: Model, form: Plan["planned_form"], tensionOf: (t: PlannedTension) => number): number[] {
  const sums = form.map(() => [0, 0, 0]);
  plan.tension.edges.forEach((t, e) => {
    const [a, b] = [model.ends[2 * e]!, model.ends[2 * e + 1]!];
    const along = form[b]!.map((x, k) => x - form[a]![k]!);
    const length = Math.hypot(...along);
    along.forEach((x, k) => {
      const force = length > 0 ? (kN * tensionOf(t) * x) / length : 0;
      sums[a]![k]! += force;
      sums[b]![k]! -= force;
    });
  });
  return sums.map((force, node) => (model.isSupport[node] ? Math.hypot(...force) : NaN));
}

/** Along the target's normal, at the free nodes that have one, in millimetres. */
function alongNormal(plan: Plan, vectors: Float32Array, isFixed: Uint8Array): number[] {
  return plan.target_normals.map((n, i) =>
    isFixed[i] || n.every((x) => x === 0) ? NaN : 1e3 * n.reduce((sum, x, k) => sum + x * vectors[3 * i + k]!, 0));
}

export function modelOfPlan(plan: Plan): Model {
  const net = plan.cable_net;
  const model = netOf(net, plan.planned_form);
  model.charted = net.edges.map((_, e) => e);
  const strokes = strokesOf(plan);
  const stroke = new Float64Array(model.edgeCount).fill(NaN);
  for (const [edge, metres] of strokes) stroke[edge] = 1e3 * metres;
  const built = difference(plan.built_form, plan.target_form);
  const planned = difference(plan.planned_form, plan.target_form);
  const base = flat(plan.target_form);
  const node = (key: string, label: string, head: string, kind: "sequential" | "diverging", scale: string, values: ArrayLike<number>): Quantity =>
    quantity({ key, label, head, unit: "mm", of: "node", kind, decimals: 2, scale, values });
  if (strokes.size > 0) {
    model.quantities.unshift(quantity({ key: "stroke", label: "stroke, + lengthens", head: "stroke", unit: "mm", of: "edge", kind: "diverging", decimals: 2, values: stroke }));
  }
  model.quantities.push(
    ...tensions(plan),
    node("normal_built", "normal deviation from the target, as built", "normal, built", "diverging", "normal", alongNormal(plan, built, model.isFixed)),
    node("normal_planned", "normal deviation from the target, as planned", "normal, planned", "diverging", "normal", alongNormal(plan, planned, model.isFixed)),
    node("distance_built", "3D deviation from the target, as built", "3D, built", "sequential", "distance", distances(built, model.isFixed)),
    node("distance_planned", "3D deviation from the target, as planned", "3D, planned", "sequential", "distance", distances(planned, model.isFixed)),
  );
  const reaction = (key: string, label: string, head: string, values: number[]): Quantity =>
    quantity({ key, label, head, unit: "kN", of: "node", kind: "sequential", decimals: 3, scale: "reaction", values });
  model.quantities.push(
    reaction("reaction_built", "reaction: force of the cables on the support, as built", "reaction, built", reactions(plan, model, plan.built_form, (t) => t.as_built)),
    reaction("reaction_planned", "reaction: force of the cables on the support, as planned", "reaction, planned", reactions(plan, model, plan.planned_form, (t) => t.planned)));
  if (plan.draws > 0) {
    const std = plan.planned_form_std.map((s, i) => (model.isFixed[i] ? NaN : 1e3 * Math.max(...s)));
    model.quantities.push(quantity({ key: "std", label: "standard deviation of the planned position, worst axis", head: "std", unit: "mm", of: "node", kind: "sequential", decimals: 2, values: std }));
  }
  addCovariances(model, plan.planned_form_covariance);
  // One scale, so that before and after can be compared by eye.
  model.displacements = [
    { label: "as built, from the target", base, vectors: built, scale: "target" },
    { label: "as planned, from the target", base, vectors: planned, scale: "target", certain: "end" },
    { label: "effect of turning: as planned, from as built", base: flat(plan.built_form), vectors: difference(plan.planned_form, plan.built_form), scale: "target", certain: "end" },
  ];
  model.strokes = strokes;
  return model;
}
