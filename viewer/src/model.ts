// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { palette, type Rgb } from "./colours";
import { type Covariances, ellipseRemarks, semiMajorAxes, uncertainNodes } from "./error_ellipses";
import { number } from "./format";
import { type Identification, isElastic, isSlack, isStrut, lengthOf, type NetFile, type Status, statusOf, type Study } from "./result";

/** A number for each edge or node, in the unit it is shown in; NaN where there is none. */
export interface Quantity {
  key: string;
  label: string;
  unit: string;
  /** A short label for table heads. */
  head?: string;
  of: "edge" | "node";
  /** Colour scale from 0, scale around 0, or names: values are then their indices. */
  kind: "sequential" | "diverging" | "names";
  values: Float64Array;
  names?: { text: string; colour: Rgb }[];
  /** Ends of the 95 % interval, where the value has one. */
  interval?: { lower: Float64Array; upper: Float64Array };
  decimals: number;
  /** Whether the colour scale begins at the lowest value, not at zero. */
  fromLowest?: boolean;
  /** Quantities with the same name share one colour scale. */
  scale?: string;
}

/** A form and the displacements to another one. */
export interface Displacement {
  label: string;
  base: Float32Array;
  vectors: Float32Array;
  /** Displacements with the same name are exaggerated alike. */
  scale?: string;
  /** Which end of the vectors is the form that the covariances are of; neither without. */
  certain?: "base" | "end";
}

/** A net with all quantities of a result, the same for every kind of result. */
export interface Model {
  nodeCount: number;
  edgeCount: number;
  ends: Uint32Array;
  isSupport: Uint8Array;
  /** Supports on the rigid frame: their places are given. Elastic ones move. */
  isFixed: Uint8Array;
  isAdjustable: Uint8Array;
  /** Edges that carry compression, too. */
  isStrut: Uint8Array;
  /** Edges in the order of the charts. */
  charted: number[];
  form: Float32Array;
  quantities: Quantity[];
  displacements: Displacement[];
  unstressed: number[];
  /** Of the nodes' places in the form; empty where the result has none. */
  covariances: Covariances;
  /** More lines of the inspector for a node: name and text. */
  remarks: Map<number, [string, string][]>;
  /** Change of length of the edges to be turned, drawn as arrows; empty without a plan [m]. */
  strokes: Map<number, number>;
  nodeId(node: number): string;
  edgeId(edge: number): string;
}

type Spec = Omit<Quantity, "values"> & { values: ArrayLike<number> };

export const quantity = (spec: Spec): Quantity => ({ ...spec, values: Float64Array.from(spec.values) });

export const flat = (points: [number, number, number][]): Float32Array => {
  const result = new Float32Array(3 * points.length);
  points.forEach((p, i) => result.set(p, 3 * i));
  return result;
};

export function difference(to: [number, number, number][], from: [number, number, number][]): Float32Array {
  const result = new Float32Array(3 * to.length);
  to.forEach((p, i) => p.forEach((x, k) => (result[3 * i + k] = x - from[i]![k]!)));
  return result;
}

/** Lengths of vectors in millimetres, at the nodes that are free. */
export function distances(vectors: Float32Array, isFixed: Uint8Array): Float64Array {
  return Float64Array.from(isFixed, (fixed, i) =>
    fixed ? NaN : 1e3 * Math.hypot(vectors[3 * i]!, vectors[3 * i + 1]!, vectors[3 * i + 2]!),
  );
}

/** Values of some edges at their places among all. */
function spread(count: number, edges: number[], values: number[], factor = 1e3): Float64Array {
  const result = new Float64Array(count).fill(NaN);
  edges.forEach((e, i) => (result[e] = factor * values[i]!));
  return result;
}

function marks(count: number, indices: number[]): Uint8Array {
  const result = new Uint8Array(count);
  for (const i of indices) result[i] = 1;
  return result;
}

export function netOf(net: NetFile, form: [number, number, number][]): Model {
  const isAdjustable = marks(net.edges.length, net.adjustable);
  const isOne = Uint8Array.from(net.edges, (_, e) => (isStrut(net, e) ? 1 : 0));
  return {
    nodeCount: net.nodes.length,
    edgeCount: net.edges.length,
    ends: Uint32Array.from(net.edges.flat()),
    isSupport: marks(net.nodes.length, net.supports),
    isFixed: marks(net.nodes.length, net.supports.filter((_, i) => !isElastic(net, i))),
    isAdjustable,
    isStrut: isOne,
    charted: net.edges.map((_, e) => e).filter((e) => !isAdjustable[e]),
    form: flat(form),
    quantities: [
      quantity({
        key: "kind", label: "kind of edge", unit: "", of: "edge", kind: "names", decimals: 0,
        values: Uint8Array.from(isAdjustable, (adjustable, e) => (adjustable ? 1 : 2 * isOne[e]!)),
        names: [{ text: "interior", colour: palette.grey }, { text: "adjustable", colour: palette.orange }, { text: "strut", colour: palette.blue }],
      }),
    ],
    displacements: [],
    unstressed: net.unstressed_lengths,
    covariances: [],
    remarks: new Map(),
    strokes: new Map(),
    nodeId: (node) => net.node_ids?.[node] ?? String(node),
    edgeId: (edge) => net.edge_ids?.[edge] ?? String(edge),
  };
}

/** Adds the covariances of the nodes' places, with what follows from them in plan. */
export function addCovariances(model: Model, covariances: Covariances | null | undefined): void {
  if (!covariances) return;
  model.covariances = covariances;
  for (const [node, covariance] of uncertainNodes(covariances)) model.remarks.set(node, [...(model.remarks.get(node) ?? []), ...ellipseRemarks(covariance)]);
  model.quantities.push(quantity({
    key: "ellipse", label: "95 % error ellipse in plan, semi-major axis", head: "95 % ellipse", unit: "mm", of: "node", kind: "sequential", decimals: 2, values: semiMajorAxes(covariances),
  }));
}

/** The edge or node of a name; -1 of none. */
export function indexOf(model: Model, of: "edge" | "node", id: string): number {
  const count = of === "edge" ? model.edgeCount : model.nodeCount;
  const name = of === "edge" ? model.edgeId : model.nodeId;
  for (let index = 0; index < count; ++index) if (name(index) === id) return index;
  return -1;
}

/** The edge's ends, first its support; where neither or both are one, in their order. */
export function endsFromOutside({ ends, isSupport }: Model, edge: number): [outer: number, inner: number] {
  const [s, t] = [ends[2 * edge]!, ends[2 * edge + 1]!];
  return isSupport[t] && !isSupport[s] ? [t, s] : [s, t];
}

function tensionAndStrain(net: NetFile, tension: number[], which: string, key: string): Quantity[] {
  const stiffness = (e: number) => (typeof net.axial_stiffness === "number" ? net.axial_stiffness : net.axial_stiffness[e]!);
  return [
    quantity({ key: `${key}tension`, label: `tension${which}`, unit: "kN", of: "edge", kind: "sequential", decimals: 3, scale: "tension", fromLowest: true, values: tension.map((t) => t / 1e3) }),
    quantity({ key: `${key}strain`, label: `strain${which}`, unit: "%", of: "edge", kind: "sequential", decimals: 3, scale: "strain", fromLowest: true, values: tension.map((t, e) => (100 * t) / stiffness(e)) }),
  ];
}

const statusNames = [
  { text: "determined", colour: palette.blue },
  { text: "weakly determined", colour: palette.green },
  { text: "not determined", colour: palette.yellow },
  { text: "slack", colour: palette.orange },
  { text: "adjustable", colour: palette.grey },
];
const statuses: Status[] = ["determined", "weakly_determined", "not_determined", "slack"];

function statusQuantity(model: Model, statusOf: (edge: number) => Status): Quantity {
  return quantity({
    key: "status", label: "status", unit: "", of: "edge", kind: "names", decimals: 0, names: statusNames,
    values: Float64Array.from(model.isAdjustable, (adjustable, e) => (adjustable ? statuses.length : statuses.indexOf(statusOf(e)))),
  });
}

export function modelOfStudy(study: Study): Model {
  const net = study.cable_net;
  const model = netOf(net, study.nominal_form);
  const { sample, errors } = study;
  const edge = (key: string, label: string, head: string, kind: "sequential" | "diverging", values: number[], scale?: string): Quantity =>
    quantity({ key, label, head, unit: "mm", of: "edge", kind, decimals: 4, values: spread(model.edgeCount, model.charted, values), ...(scale ? { scale } : {}) });
  const free = net.nodes.map((_, i) => i).filter((i) => !model.isFixed[i]);
  const node = (key: string, label: string, values: number[]): Quantity =>
    quantity({ key, label, unit: "mm", of: "node", kind: "sequential", decimals: 4, values: spread(model.nodeCount, free, values) });
  model.quantities.push(
    statusQuantity(model, (e) => (sample.identified_tension[e]! > 0 || isStrut(net, e) ? "determined" : "slack")),
    edge("true", "length deviation, true", "true", "diverging", sample.true, "deviation"),
    edge("identified", "length deviation, identified", "identified", "diverging", sample.identified, "deviation"),
    edge("error", "length deviation, error (true − identified)", "error", "diverging", sample.true.map((t, i) => t - sample.identified[i]!)),
    edge("std", "standard deviation of the identified length", "std", "sequential", sample.std),
    edge("error_mean", "mean error over the validation samples", "mean error", "diverging", errors.mean),
    edge("error_std", "std of the errors over the validation samples", "std of errors", "sequential", errors.std),
    ...tensionAndStrain(net, sample.identified_tension, ", identified", ""),
    ...tensionAndStrain(net, sample.true_tension, ", true", "true_"),
    node("form_nominal", "form deviation, true − nominal", sample.form_error.nominal),
    node("form_identified", "form deviation, true − identified", sample.form_error.identified),
  );
  model.displacements = [
    { label: "true form, from nominal", base: model.form, vectors: difference(sample.true_form, study.nominal_form) },
    { label: "identified form, from nominal", base: model.form, vectors: difference(sample.identified_form, study.nominal_form) },
    { label: "remaining: true, from identified", base: flat(sample.identified_form), vectors: difference(sample.true_form, sample.identified_form) },
  ];
  return model;
}

/** Tensions by the posterior samples; nothing without them. */
function drawnQuantities(result: Identification, model: Model): Quantity[] {
  const edges = [...result.edges, ...(result.adjustable_edges ?? [])];
  if (!edges.some((e) => typeof e.tension === "number")) return [];
  type Key = "tension" | "tension_std" | "tension_lower" | "tension_upper" | "slack_probability";
  const of = (key: Key, factor: number): Float64Array => {
    const values = new Float64Array(model.edgeCount).fill(NaN);
    for (const e of edges) values[e.edge] = factor * (e[key] ?? NaN);
    return values;
  };
  const kN = 1e-3;
  return [
    quantity({
      key: "drawn_tension", label: "tension, posterior mean", head: "tension", unit: "kN", of: "edge", kind: "sequential", decimals: 3, scale: "tension", fromLowest: true,
      values: of("tension", kN), interval: { lower: of("tension_lower", kN), upper: of("tension_upper", kN) },
    }),
    quantity({ key: "drawn_tension_std", label: "standard deviation of the tension", head: "std of tension", unit: "kN", of: "edge", kind: "sequential", decimals: 3, values: of("tension_std", kN) }),
    quantity({ key: "slack_probability", label: "probability of being slack", head: "slack", unit: "%", of: "edge", kind: "sequential", decimals: 1, values: of("slack_probability", 100) }),
  ];
}

export function modelOfIdentification(result: Identification): Model {
  const net = result.cable_net;
  const model = netOf(net, result.form);
  model.charted = result.edges.map((e) => e.edge);
  type Key = "length_deviation" | "std" | "lower" | "upper";
  const of = (key: Key, edges = result.edges): Float64Array =>
    spread(model.edgeCount, edges.map((e) => e.edge), edges.map((e) => e[key]));
  const tense = result.edges.filter((e) => !isSlack(e));
  const slack = result.edges.filter(isSlack);
  const statusByEdge = new Map(result.edges.map((e) => [e.edge, statusOf(e)]));
  const fromNominal = difference(result.form, net.nodes);
  model.quantities.push(
    statusQuantity(model, (e) => statusByEdge.get(e) ?? "not_determined"),
    quantity({
      key: "identified", label: "length deviation, identified", head: "deviation", unit: "mm", of: "edge", kind: "diverging", decimals: 3, scale: "deviation",
      values: of("length_deviation", tense), interval: { lower: of("lower", tense), upper: of("upper", tense) },
    }),
    ...(slack.length > 0 ? [quantity({
      key: "bound", label: "length deviation of a slack edge, lower bound", head: "slack: lower bound", unit: "mm", of: "edge", kind: "diverging", decimals: 3, scale: "deviation",
      values: of("lower", slack),
    })] : []),
    quantity({ key: "std", label: "standard deviation of the identified length", head: "std", unit: "mm", of: "edge", kind: "sequential", decimals: 3, values: of("std") }),
    ...drawnQuantities(result, model),
    ...(result.tension ? tensionAndStrain(net, result.tension, ", predicted", "") : []),
    quantity({ key: "form_predicted", label: "form deviation, predicted − nominal", unit: "mm", of: "node", kind: "sequential", decimals: 3, values: distances(fromNominal, model.isFixed) }),
  );
  model.displacements = [{ label: "predicted form, from nominal", base: flat(net.nodes), vectors: fromNominal, certain: "end" }];

  const { residuals = [], outliers, outlier_threshold } = result.survey;
  if (outliers.length > 0) {
    const distance = outliers.map((o) => o.distance ?? NaN);
    model.quantities.push(quantity({
      key: "outlier", label: "gross error, from the place predicted by all others", head: "gross error", unit: "mm", of: "node", kind: "sequential", decimals: 3,
      values: spread(model.nodeCount, outliers.map((o) => o.node), distance),
    }));
  }
  for (const { node, statistic } of outliers) {
    if (statistic === undefined) continue;
    const threshold = outlier_threshold ? ` (excluded above ${number(outlier_threshold)})` : "";
    model.remarks.set(node, [["test statistic of the gross error", `${number(statistic)}${threshold}`]]);
  }
  if (residuals.length > 0) {
    const vectors = new Float32Array(3 * model.nodeCount);
    const values = new Float64Array(model.nodeCount).fill(NaN);
    for (const residual of residuals) {
      vectors.set([residual.dx, residual.dy, residual.dz], 3 * residual.node);
      if (!outliers.some((o) => o.node === residual.node)) values[residual.node] = 1e3 * lengthOf(residual);
    }
    model.quantities.push(quantity({ key: "residual", label: `surveyed − predicted${outliers.length > 0 ? ", targets in use" : ""}`, unit: "mm", of: "node", kind: "sequential", decimals: 3, values }));
    model.displacements.push({ label: "surveyed form, from predicted", base: model.form, vectors, certain: "base" });
  }
  addCovariances(model, result.form_covariance);
  return model;
}

/** The ends of a quantity's colour scale, over all quantities that share it. */
export function rangeOf(model: Model, quantity: Quantity): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (const other of model.quantities) {
    if (other !== quantity && !(quantity.scale && other.scale === quantity.scale)) continue;
    for (const value of other.values) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  if (low > high) return [0, 1];
  const reach = Math.max(Math.abs(low), Math.abs(high)) || 1;
  if (quantity.kind === "diverging") return [-reach, reach];
  return quantity.fromLowest && high > low ? [low, high] : [0, reach];
}
