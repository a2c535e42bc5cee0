// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h, section } from "./dom";
import { counted, fixed, millimetres, number, percent, rootMeanSquare, short } from "./format";
import type { Model } from "./model";
import {
  type Comparison, controlOf, type FormErrorSummary, type Identification, isNotDetermined, isSlack, lengthOf, type Method, methodsOf, type Result, type Study,
} from "./result";
import type { Selection } from "./selection";
import { type Column, Table } from "./table";

export function plainTable(caption: string, head: (string | HTMLElement)[], rows: (string | number)[][], classes: string[] = []): HTMLElement {
  const cells = (row: (string | number)[]): HTMLElement[] =>
    row.map((text, i) => (i === 0 ? h("th", { scope: "row" }, text) : h("td", { class: classes[i] ?? "" }, text)));
  return h("div", { class: "scroll" }, h("table", { class: "plain" },
    h("caption", { class: "hidden" }, caption),
    h("thead", {}, h("tr", {}, ...head.map((text, i) => h("th", { scope: "col", class: classes[i] ?? "" }, text)))),
    h("tbody", {}, ...rows.map((row) => h("tr", {}, ...cells(row))))));
}

/** The paper's numbers and the ones measured here, told apart. */
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
      row("true lengths inside their 95 % interval [%]", "–", (m) => percent(m.coverage_95)),
      ...(methods.length > 1 ? [
        row("form error, mean of nodes and trials [mm]", short(paper && 1e3 * paper.form_error.identified.mean), (m) => millimetres(m.form_error?.mean)),
        row("trials without a result", "–", (m) => String(m.failed ?? "–")),
      ] : []),
    ], ["", "paper", ...methods.map(() => "here")]);
  const forms = plainTable("Form error, paper and measured here",
    ["Form error [mm]", source("nominal", "paper"), source("nominal", "here"), source("identified", "paper"), source("identified", "here"), "identified, mean of all trials"],
    keys.map(([key, label]) => [label,
      short(paper && 1e3 * paper.form_error.nominal[key]), millimetres(study.form_error.nominal[key]),
      short(paper && 1e3 * paper.form_error.identified[key]), millimetres(study.form_error.identified[key]),
      millimetres(mean?.identified[key])]), ["", "paper", "here", "paper", "here", "here"]);
  const alike = study.net.free_nodes === 300 && study.net.interior_edges === 536;
  return section("paper", "Beside the paper's numbers", lengths, forms,
    h("p", { class: "quiet" }, "Form errors are those of the first validation sample, as in the paper. ",
      alike ? "The net has the paper's counts of free nodes and interior edges, not its geometry, which was not published."
        : "The paper's net is another one: it has 300 free nodes and 536 interior edges."));
}

/** One of the things to look at: its name, what stands beside it, and what tells more of it. */
interface Entry {
  index: number;
  text?: string;
  detail?: string;
}

/** What in a survey needs a look: told by name, each a button that shows it. */
export function listsSection(result: Identification, model: Model, selection: Selection): HTMLElement {
  const most = 200;
  const list = (heading: string, of: "edge" | "node", items: Entry[], none: string, note = ""): HTMLElement => {
    const name = (index: number): string => (of === "edge" ? model.edgeId(index) : model.nodeId(index));
    const entries = items.slice(0, most).map(({ index, text, detail }) =>
      h("li", {}, h("button", { type: "button", class: "chip", title: detail, onclick: () => selection.select({ of, index }) }, name(index), text ? h("small", {}, ` ${text}`) : null)));
    return h("div", { class: "list" },
      h("h3", {}, heading, h("span", { class: "count" }, String(items.length))),
      items.length === 0 ? h("p", { class: "quiet" }, none) : h("ul", {}, ...entries),
      items.length > 0 && note ? h("p", { class: "quiet" }, note) : null,
      items.length > most ? h("p", { class: "quiet" }, `and ${items.length - most} more, in the table`) : null);
  };
  const { survey, edges } = result;
  const slack = edges.filter(isSlack).sort((a, b) => b.lower - a.lower)
    .map((e): Entry => ({ index: e.edge, text: `≥ ${millimetres(e.lower)} mm`, detail: "its length deviation is at least this" }));
  const open = edges.filter(isNotDetermined).map((e) => ({ index: e.edge }));
  const gross = survey.outliers.map(({ node, distance, statistic, swapped_with }): Entry => ({
    index: node,
    ...(distance === undefined ? {} : { text: `${millimetres(distance)} mm${swapped_with === undefined ? "" : `, swapped with ${swapped_with}`}` }),
    ...(statistic === undefined ? {} : { detail: `${number(statistic)} is its square in standard deviations${survey.outlier_threshold ? `, left out above ${number(survey.outlier_threshold)}` : ""}` }),
  }));
  const places = new Map((result.missing_places ?? []).map((place) => [place.node, place.std]));
  const knownTo = (node: number): Pick<Entry, "text" | "detail"> => {
    const std = places.get(node);
    return std ? { text: `± ${millimetres(Math.max(...std))} mm`, detail: "largest standard deviation of a coordinate, of the draws" } : {};
  };
  const unmatched = (survey.unmatched ?? []).map((u) => u.swapped_with === undefined ? u.id : `${u.id}, swapped with ${u.swapped_with}`);
  return section("lists", "To look at", h("div", { class: "lists" },
    list("Slack edges", "edge", slack, "None: every cable whose length was asked for carries tension.",
      "No more is known than that the length deviation is at least this. They are in no statistic of the deviations."),
    list("Edges not determined", "edge", open, "None: the survey tells about every cable.", "Hardly better known than before the survey."),
    list("Gross errors", "node", gross, "None: no surveyed point contradicts the net.", "Targets left out, with their distance from where all others tell."),
    list("Hidden nodes", "node", (survey.missing_nodes ?? []).map((index): Entry => ({ index, ...knownTo(index) })), survey.missing > 0 ? `${survey.missing}, which the result does not name.` : "None: every free node was surveyed."),
    h("div", { class: "list" }, h("h3", {}, "Unmatched targets", h("span", { class: "count" }, String(unmatched.length))),
      unmatched.length === 0 ? h("p", { class: "quiet" }, "None: every target fits a node.")
        : h("ul", {}, ...unmatched.slice(0, most).map((text) => h("li", { class: "chip" }, text))))));
}

/** The fit of the survey's frame to its control points; null where it was given in the net's. */
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
    h("p", {}, `A rigid motion, without scale, brings the survey into the net's frame. It was fitted to ${counted(control.length, "control point")}, which it brings to their known places within ` +
      `${millimetres(rootMeanSquare(distances))} mm (RMS), at most ${millimetres(distances[worst])} mm (${control[worst]!.id}).` +
      (frame ? ` It turns by ${fixed((180 / Math.PI) * turn, 3)}° and takes ${place(frame.from)} to ${place(frame.to)}.` : "")),
    table.element);
}

export function comparisonSection(comparison: Comparison): HTMLElement {
  const { rows } = comparison;
  type Key = "training_samples" | "hidden_fraction" | "mse" | "mrse" | "form_error" | "coverage" | "training_seconds" | "seconds" | "best_possible_mse" | "surveys" | "failed";
  const value = (key: Key, factor = 1) => (row: number): number => factor * (rows[row]![key] ?? NaN);
  const table = new Table({
    caption: "All methods, noises and training sizes", rowCount: rows.length, fileName: "comparison.csv",
    columns: [
      { label: "method", value: (row) => rows[row]!.method },
      { label: "noise", unit: "mm", value: (row) => 1e3 * rows[row]!.noise },
      { label: "training samples", decimals: 0, value: value("training_samples") },
      { label: "hidden", unit: "%", value: value("hidden_fraction", 100) },
      { label: "MSE", unit: "m²", value: value("mse") },
      { label: "best possible MSE", unit: "m²", value: value("best_possible_mse") },
      { label: "MRSE", unit: "%", value: value("mrse", 100) },
      { label: "form error", unit: "mm", value: value("form_error", 1e3) },
      { label: "coverage", unit: "%", value: value("coverage", 100) },
      { label: "training", unit: "s", value: value("training_seconds") },
      { label: "time each", unit: "ms", value: value("seconds", 1e3) },
      { label: "surveys", decimals: 0, value: value("surveys") },
      { label: "failed", decimals: 0, value: value("failed") },
      { label: "first failure", value: (row) => rows[row]!.first_failure ?? "" },
    ],
  });
  return section("tables", "All numbers", table.element);
}

/** Standard deviation of a length, as the survey shows it. */
function priorWords(prior: Identification["prior"]): string {
  if (!prior) return "";
  if (prior.exact) return `${prior.nodes[0]?.prior ?? ""}, taken as exact`;
  const found = `estimated, standard deviation ${millimetres(prior.std)} ± ${millimetres(prior.std_std)} mm`;
  const common = prior.common && prior.common.mean_std > 0 ? `; mean of all ${millimetres(prior.common.mean)} ± ${millimetres(prior.common.mean_std)} mm` : "";
  const turnbuckles = prior.common?.adjustable_std ? `; adjustable edges ${millimetres(prior.common.adjustable ?? 0)} ± ${millimetres(prior.common.adjustable_std)} mm longer in common` : "";
  const runs = prior.common && prior.common.run_probability > 0.5 ? `; runs of cable scaled by ${(100 * prior.common.run_std).toPrecision(2)} %` : "";
  return `${prior.given ?? "none given"}; ${found}${common}${turnbuckles}${runs}; uniform with a probability of ${percent(prior.uniform_probability)} %, ${counted(prior.nodes.length, "node")}`;
}

/** By what, how and in which time. */
export function settingsSection(result: Result): HTMLElement {
  const rows: [string, string][] = [];
  const add = (name: string, value: unknown): void => {
    if (value !== undefined && value !== null && value !== "") rows.push([name, String(value)]);
  };
  add("program", result.program);
  add("date", result.date);
  add("command", result.command);
  add("net", result.net.name);
  add("net fingerprint", result.net.fingerprint);
  if (result.format === "taut-study" || result.format === "taut-comparison") add("prior of the length deviations", result.prior);
  if (result.format === "taut-identification") add("most probable prior of the length deviations", result.length_prior);
  if (result.format === "taut-identification") add("prior of the length deviations", priorWords(result.prior));
  if (result.format === "taut-study" || result.format === "taut-comparison") add("seed", result.seed);
  if (result.format === "taut-study") {
    const { samples, seconds } = result;
    add("samples drawn", samples.total);
    add("of these trained on", samples.training);
    add("of these validated on", samples.validation);
    add("with slack edges", samples.with_slack);
    add("not converged", samples.not_converged);
    add("identified forms not converged", result.forms_not_converged);
    for (const stage of ["sampling", "training", "identification", "total"] as const) add(stage === "total" ? "time in all" : `time, ${stage}`, `${number(seconds[stage])} s`);
  }
  if (result.format === "taut-comparison" && result.samples) {
    add("samples drawn", result.samples.total);
    add("not converged", result.samples.not_converged);
    add("surveys of each kind", result.samples.surveyed);
    add("of these with slack edges", result.samples.surveyed_with_slack);
    add("time in all", result.seconds && `${number(result.seconds.total)} s`);
  }
  if (result.format === "taut-identification") {
    add("method", result.method);
    add("noise of a coordinate, as stated", result.noise === undefined ? "" : `${short(1e3 * result.noise)} mm`);
    add("residuals over what the noise lets expect", result.survey.noise_ratio ? number(result.survey.noise_ratio) : "");
    if (result.frame === null) add("frame of the survey", "the net's");
    add("surveyed free nodes", result.survey.used);
    add("hidden free nodes", result.survey.missing);
    for (const one of result.uncertain ?? []) {
      if (one.edge === undefined && one.node === undefined) {
        const unit = one.unit === "1" ? "%" : one.unit;
        const scale = one.unit === "1" ? 100 : 1;
        const doubt = one.observed ? "" : "; nothing that was measured shows it";
        add(`unknown: ${one.given}`, `${number(Math.abs(one.mean) > 1e-6 * one.std ? scale * one.mean : 0)} ${unit} from the design, standard deviation ${number(scale * one.std)} ${unit}${doubt}`);
      }
    }
    const single = new Map<string, number>();
    for (const one of result.uncertain ?? []) if (one.edge !== undefined || one.node !== undefined) single.set(one.given, (single.get(one.given) ?? 0) + (one.observed ? 1 : 0));
    for (const [told, observed] of single) add(`unknown: ${told}`, `${observed} of them better known than before`);
    if (result.forces && result.forces.measurements > 0) add("readings of forces", `${result.forces.measurements}, ${result.forces.outliers.length} left out`);
    if (result.draws) add("draws of the posterior", `${result.draws.count}: ${result.draws.how}`);
    if (result.draws?.reason) add("no tensions are told", result.draws.reason);
    if (result.mean_tension) {
      const { mean, lower, upper } = result.mean_tension;
      add("mean tension, with its 95 % interval", `${number(mean / 1e3)} kN, ${number(lower / 1e3)} to ${number(upper / 1e3)} kN`);
    }
  }
  if (result.format === "taut-plan") {
    const { options } = result;
    add("confidence asked for", `${percent(options.confidence)} %`);
    add("play of what is turned, standard deviation", `${short(1e3 * options.actuator)} mm`);
    add("change of length by one turn", options.pitch === null ? "not told" : `${short(1e3 * options.pitch)} mm`);
    add("smallest step", options.step ? `${short(1e3 * options.step)} mm` : "");
    add("tolerance along the normal", options.tolerance === null ? "" : `${short(1e3 * options.tolerance)} mm`);
    add("thread", options.thread === null ? "not told" : `${options.thread}-hand`);
    add("draws of the identification", result.draws);
    add("no draws, since", result.no_draws_because);
  }
  if (result.format === "taut-control") {
    const { settings } = result;
    const kN = (newton: number): string => `${short(newton / 1e3)} kN`;
    add("law of the length deviations", settings.prior);
    add("uncertain besides", settings.uncertain?.join(", ") || "nothing");
    add("noise of a coordinate", `${short(1e3 * settings.noise)} mm`);
    add("free nodes that a survey misses", `${short(100 * settings.hidden)} %`);
    add("play of what is turned, standard deviation", `${short(1e3 * settings.actuator)} mm`);
    add("stroke of a turnbuckle since installation", `±${short(1e3 * settings.stroke)} mm`);
    add("smallest step", settings.step === null ? "any" : `${short(1e3 * settings.step)} mm`);
    const most = settings.most_tension === null ? "" : `, at most ${kN(settings.most_tension)}`;
    add("limits of tension", (settings.least_tension > 0 ? `at least ${kN(settings.least_tension)}` : "no cable slack") + most);
    add("confidence of the limits, on identified lengths", `${short(100 * settings.confidence)} %`);
    add("draws of each identification", settings.draws);
    add("rounds", settings.rounds);
    add("jobs", settings.trials);
    add("seed", settings.seed);
  }
  return section("settings", "Settings", plainTable("Settings", ["what", "value"], rows, ["", "text"]));
}
