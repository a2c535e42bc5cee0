// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h, section } from "./dom";
import { counted, fixed, millimetres, number, percent, rootMeanSquare, short } from "./format";
import type { Model } from "./model";
import {
  type Comparison, controlOf, type FormErrorSummary, type Identification, isNotDetermined, isSlack, lengthOf, type Method, methodsOf, type Study,
} from "./result";
import type { Selection } from "./selection";
import { plainTable } from "./plain_table";
import { type Column, Table } from "./table";

/** The paper's numbers beside the ones measured here. */
export function paperSection(study: Study): HTMLElement {
  const { paper } = study;
  const methods = methodsOf(study);
  const source = (text: string, kind: "paper" | "here"): HTMLElement => h("span", {}, text, " ", h("span", { class: `tag ${kind}` }, kind === "paper" ? "paper" : "measured here"));
  const mean = study.form_error_mean_over_validation;
  const keys: [keyof FormErrorSummary, string][] = [["max", "max"], ["min", "min"], ["mean", "mean"], ["rmse", "RMSE"]];
  const row = (label: string, ofPaper: string, own: (method: Method) => string): string[] => [label, ofPaper, ...methods.map(([, m]) => own(m))];
  const lengths = plainTable("Error of the identified lengths, paper and measured here",
    ["Error of the identified lengths", source("", "paper"), ...methods.map(([name]) => source(methods.length > 1 ? name : "", "here"))],
    [
      row("mean squared error, MSE [m²]", short(paper?.mse), (m) => number(m.mse)),
      row("mean relative squared error, MRSE [%]", short(paper && 100 * paper.mrse), (m) => percent(m.mrse)),
      row("largest mean error of an edge [mm]", "–", (m) => millimetres(m.error_mean_max_abs)),
      row("standard deviation, mean of the edges [mm]", "–", (m) => millimetres(m.error_std_mean)),
      row("true lengths in their 95 % interval [%]", "–", (m) => percent(m.coverage_95)),
      ...(methods.length > 1 ? [
        row("form error, mean of nodes and samples [mm]", short(paper && 1e3 * paper.form_error.identified.mean), (m) => millimetres(m.form_error?.mean)),
        row("samples without a result", "–", (m) => String(m.failed ?? "–")),
      ] : []),
    ], ["", "paper", ...methods.map(() => "here")]);
  const forms = plainTable("Form error, paper and measured here",
    ["Form error [mm]", source("nominal", "paper"), source("nominal", "here"), source("identified", "paper"), source("identified", "here"), "identified, mean of all samples"],
    keys.map(([key, label]) => [label,
      short(paper && 1e3 * paper.form_error.nominal[key]), millimetres(study.form_error.nominal[key]),
      short(paper && 1e3 * paper.form_error.identified[key]), millimetres(study.form_error.identified[key]),
      millimetres(mean?.identified[key])]), ["", "paper", "here", "paper", "here", "here"]);
  const alike = study.net.free_nodes === 300 && study.net.interior_edges === 536;
  return section("paper", "Comparison with the paper", lengths, forms,
    h("p", { class: "quiet" }, "Form errors are those of the first validation sample, as in the paper. ",
      alike ? "The net has the paper's counts of free nodes and interior edges, not its geometry, which was not published."
        : "The paper's net is a different one: it has 300 free nodes and 536 interior edges."));
}

/** An edge or node to look at, with a text beside its name, and more in the tooltip. */
interface Entry {
  index: number;
  text?: string;
  detail?: string;
}

/** What needs attention in a survey, by name; each is a button that selects it. */
export function listsSection(result: Identification, model: Model, selection: Selection): HTMLElement {
  const most = 200;
  const list = (heading: string, of: "edge" | "node", items: Entry[], none: string, note = ""): HTMLElement => {
    const name = (index: number): string => (of === "edge" ? model.edgeId(index) : model.nodeId(index));
    const entries = items.slice(0, most).map(({ index, text, detail }) =>
      h("li", {}, h("button", { type: "button", class: "chip", title: detail, onclick: () => selection.show({ of, index }) }, name(index), text ? h("small", {}, ` ${text}`) : null)));
    return h("div", { class: "list" },
      h("h3", {}, heading, h("span", { class: "count" }, String(items.length))),
      items.length === 0 ? h("p", { class: "quiet" }, none) : h("ul", {}, ...entries),
      items.length > 0 && note ? h("p", { class: "quiet" }, note) : null,
      items.length > most ? h("p", { class: "quiet" }, `${items.length - most} more are in the table`) : null);
  };
  const { survey, edges } = result;
  const slack = edges.filter(isSlack).sort((a, b) => b.lower - a.lower)
    .map((e): Entry => ({ index: e.edge, text: `≥ ${millimetres(e.lower)} mm`, detail: "lower bound of its length deviation" }));
  const open = edges.filter(isNotDetermined).map((e) => ({ index: e.edge }));
  const gross = survey.outliers.map(({ node, distance, statistic, swapped_with }): Entry => ({
    index: node,
    ...(distance === undefined ? {} : { text: `${millimetres(distance)} mm${swapped_with === undefined ? "" : `, swapped with ${swapped_with}`}` }),
    ...(statistic === undefined ? {} : { detail: `test statistic ${number(statistic)}${survey.outlier_threshold ? ` (excluded above ${number(survey.outlier_threshold)})` : ""}` }),
  }));
  const places = new Map((result.missing_places ?? []).map((place) => [place.node, place.std]));
  const uncertaintyOf = (node: number): Pick<Entry, "text" | "detail"> => {
    const std = places.get(node);
    return std ? { text: `± ${millimetres(Math.max(...std))} mm`, detail: "largest posterior standard deviation of a coordinate" } : {};
  };
  const unmatched = (survey.unmatched ?? []).map((u) => u.swapped_with === undefined ? u.id : `${u.id}, swapped with ${u.swapped_with}`);
  const warnings = survey.warnings ?? [];
  return section("lists", "Needs attention", h("div", { class: "lists" },
    list("Slack edges", "edge", slack, "None: every cable is in tension.",
      "Lower bound of the length deviation. No statistic of the deviations includes them."),
    list("Edges not determined", "edge", open, "None: the survey determines every cable.", "Their std is more than nine tenths of the prior's."),
    list("Gross errors", "node", gross, "None: every target fits the others.", "Excluded targets, with their distance from the place predicted by all others."),
    list("Nodes not surveyed", "node", (survey.missing_nodes ?? []).map((index): Entry => ({ index, ...uncertaintyOf(index) })), survey.missing > 0 ? `${survey.missing}; the result does not name them.` : "None: every free node was surveyed."),
    h("div", { class: "list" }, h("h3", {}, "Targets without a node", h("span", { class: "count" }, String(unmatched.length))),
      unmatched.length === 0 ? h("p", { class: "quiet" }, "None: every target belongs to a node.")
        : h("ul", {}, ...unmatched.slice(0, most).map((text) => h("li", { class: "chip" }, text))))),
    warnings.length > 0 ? h("h3", {}, "Warnings from reading the survey") : null,
    ...warnings.map((text) => h("p", {}, text)));
}

/** The fit of the survey's frame to the control points; null for a survey in the net's frame. */
export function frameSection(result: Identification): HTMLElement | null {
  const control = controlOf(result);
  if (control.length === 0) return null;
  const distances = control.map(lengthOf);
  const worst = distances.indexOf(Math.max(...distances));
  const { frame } = result;
  const turn = frame ? Math.acos(Math.min(1, Math.max(-1, (frame.rotation[0][0] + frame.rotation[1][1] + frame.rotation[2][2] - 1) / 2))) : NaN;
  const place = (point: number[]): string => `(${point.map((x) => fixed(x, 3)).join(", ")}) m`;
  const table = new Table({
    caption: "Residuals of the control points", rowCount: control.length, fileName: "control.csv", firstColumn: 4,
    columns: [
      { label: "control point", value: (row) => control[row]!.id },
      ...(["dx", "dy", "dz"] as const).map((key): Column => ({ label: key, unit: "mm", decimals: 3, value: (row) => 1e3 * control[row]![key] })),
      { label: "distance", unit: "mm", decimals: 3, value: (row) => 1e3 * distances[row]! },
    ],
  });
  return section("frame", "Frame of the survey",
    h("p", {}, `A rigid motion without scale transforms the survey into the net's frame. It was fitted to ${counted(control.length, "control point")}; their residuals are ` +
      `${millimetres(rootMeanSquare(distances))} mm (RMS), max ${millimetres(distances[worst])} mm (${control[worst]!.id}).` +
      (frame ? ` It rotates by ${fixed((180 / Math.PI) * turn, 3)}° and moves ${place(frame.from)} to ${place(frame.to)}.` : "")),
    table.element);
}

export function comparisonSection(comparison: Comparison): HTMLElement {
  const { rows } = comparison;
  type Key = "training_samples" | "hidden_fraction" | "mse" | "mrse" | "form_error" | "coverage" | "training_seconds" | "seconds" | "cramer_rao_mse" | "surveys" | "failed";
  const value = (key: Key, factor = 1) => (row: number): number => factor * (rows[row]![key] ?? NaN);
  const table = new Table({
    caption: "All methods, standard deviations and training sizes", rowCount: rows.length, fileName: "comparison.csv",
    columns: [
      { label: "method", value: (row) => rows[row]!.method },
      { label: "survey std", unit: "mm", value: (row) => 1e3 * rows[row]!.noise },
      { label: "training samples", decimals: 0, value: value("training_samples") },
      { label: "not surveyed", unit: "%", value: value("hidden_fraction", 100) },
      { label: "MSE", unit: "m²", value: value("mse") },
      { label: "Cramér-Rao bound", unit: "m²", value: value("cramer_rao_mse") },
      { label: "MRSE", unit: "%", value: value("mrse", 100) },
      { label: "form error", unit: "mm", value: value("form_error", 1e3) },
      { label: "coverage", unit: "%", value: value("coverage", 100) },
      { label: "training", unit: "s", value: value("training_seconds") },
      { label: "time per survey", unit: "ms", value: value("seconds", 1e3) },
      { label: "surveys", decimals: 0, value: value("surveys") },
      { label: "failed", decimals: 0, value: value("failed") },
      { label: "first failure", value: (row) => rows[row]!.first_failure ?? "" },
    ],
  });
  return section("tables", "All numbers", table.element);
}
