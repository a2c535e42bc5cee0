// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { madeBar, madeCell, turnsText } from "./as_made";
import { crewDrawing } from "./crew_drawing";
import { h, section } from "./dom";
import { counted, fixed, number } from "./format";
import type { Model } from "./model";
import { type Side, sideOf } from "./net_map";
import type { Notebook } from "./notes";
import type { Plan, Turn } from "./result";

/** With a drawing above them so many fill a sheet of A4, without warnings and with them. */
const rowsOnSheet = { plain: 17, warned: 14 };

const signed = (value: number, decimals: number): string => (value > 0 ? "+" : "") + fixed(value, decimals);

/** Whether the thread of any turnbuckle is known, and with it the direction of rotation. */
const hasRotation = (plan: Plan): boolean => plan.turns.some((turn) => turn.rotation !== null);
/** Whether a crew can check by the frequencies of cables. */
const hasFrequencies = ({ draws, turns }: Plan): boolean => draws > 0 && turns.some((turn) => (turn.frequency_after_step ?? null) !== null);
/** Whether the order is more than that of the lines. */
const hasSteps = ({ order }: Plan): boolean => order.crews > 1 || order.passes > 1;

function rotationText(turn: Turn): string {
  if (turn.rotation === null) return "–";
  return turn.rotation === "clockwise" ? "↻ clockwise" : "↺ counterclockwise";
}

/** A column of the list: its heading, and what stands in it for a turn. */
interface Column {
  head: string;
  isText?: boolean;
  cells(turn: Turn, index: number): (HTMLElement | string | number)[];
}

/** What all sheets of a plan have in common. */
interface Sheets {
  plan: Plan;
  model: Model;
  notebook: Notebook;
  side: Side;
  columns: Column[];
  how: string;
}

/** Numbers of the turns of each edge: those of the lists, here and in turns.csv. */
function numbersOf(plan: Plan, turns: number[]): Map<number, string> {
  const numbers = new Map<number, string>();
  for (const i of turns) {
    const { edge } = plan.turns[i]!;
    numbers.set(edge, numbers.has(edge) ? `${numbers.get(edge)}, ${i + 1}` : String(i + 1));
  }
  return numbers;
}

/** Which stage a pass belongs to, where there are stages. */
function stageText(plan: Plan, pass: number): string {
  const step = plan.turns.find((turn) => turn.pass === pass)?.step ?? -1;
  const stage = (plan.order.stages ?? []).find((one) => step <= (one.step ?? -1));
  return stage ? `, stage ${stage.name} to ${number(100 * stage.part)} %` : "";
}

function columnsOf({ plan, model, notebook }: Omit<Sheets, "columns">): Column[] {
  const { options } = plan;
  const some = (is: boolean, column: Column): Column[] => (is ? [column] : []);
  const ends = (edge: number): string => [0, 1].map((end) => model.nodeId(model.ends[2 * edge + end]!)).join(" – ");
  return [
    { head: "no.", cells: (_, index) => [index + 1] },
    ...some(hasSteps(plan), { head: "step", cells: ({ step }) => [step + 1] }),
    { head: "cable", isText: true, cells: ({ edge, edge_id }) => [edge_id, h("small", {}, ` (${ends(edge)})`)] },
    { head: "action", isText: true, cells: ({ action }) => [action === "shorten" ? "→← shorten" : "←→ lengthen"] },
    ...some(hasRotation(plan), { head: "rotation", isText: true, cells: (turn) => [rotationText(turn)] }),
    ...some(options.pitch !== null, { head: "turns", cells: ({ turns }) => [h("strong", {}, turns === null ? "–" : turnsText(turns, options))] }),
    { head: "stroke [mm]", cells: ({ stroke }) => [fixed(Math.abs(1e3 * stroke), 2)] },
    { head: "scale reading after [mm]", cells: ({ reading_after }) => [signed(1e3 * reading_after, 2)] },
    { head: "final tension [kN]", cells: ({ tension_after }) => [plan.draws > 0 ? fixed(tension_after / 1e3, 2) : "–"] },
    ...some(hasFrequencies(plan), {
      head: "frequency after [Hz]", cells: ({ frequency_after_step: f }) => [f == null ? "–" : f.toPrecision(4)] }),
    { head: options.pitch === null ? "done, made [mm]" : "done, turns made", cells: (_, index) => madeCell(plan, index, notebook) },
  ];
}

/** Warnings before the first turn, on each sheet. */
function warningsOf(plan: Plan): string[] {
  if (plan.warnings && plan.warnings.length > 0) return plan.warnings;
  return [
    ...(plan.identification.verdict === "failed" ? ["The identification of this plan failed its checks. Do not turn by this list; resolve the findings of the report first."] : []),
    ...(plan.feasible ? [] : ["This plan does not keep all limits. Do not turn by this list before they are cleared."]),
    ...(plan.order.safe ? [] : ["No safe order was found. Watch the limits that the top of the report names."]),
  ];
}

/** One sheet: the drawing, and the turns of a crew, which are `turns` of the plan. */
function sheet({ plan, model, notebook, side, columns, how }: Sheets, crew: number, turns: number[], place: string): HTMLElement {
  const passes = [...new Set(turns.map((i) => plan.turns[i]!.pass))];
  const title = `Crew ${crew} of ${plan.order.crews}`;
  const of = ` ${plan.net.name || "net"} ${plan.net_fingerprint}${plan.date ? ` · ${plan.date}` : ""} · ${place}`;
  const record = h("small", { class: "print-only" });
  notebook.subscribe(() => {
    const { project, engineer } = notebook.notes;
    record.textContent = [project && `Project: ${project}`, engineer && `Engineer: ${engineer}`].filter(Boolean).join(" · ");
  });
  const row = (index: number): HTMLElement => h("tr", {}, ...columns.map(({ head, isText, cells }) =>
    h(head === "cable" ? "th" : "td", { class: isText ? "text" : "", "data-label": head, ...(head === "cable" ? { scope: "row" } : {}) }, ...cells(plan.turns[index]!, index))));
  const bodies = passes.map((pass) => h("tbody", {},
    plan.order.passes > 1 ? h("tr", { class: "pass" }, h("th", { colspan: columns.length, scope: "rowgroup" }, `Pass ${pass} of ${plan.order.passes}${stageText(plan, pass)}`)) : null,
    ...turns.filter((i) => plan.turns[i]!.pass === pass).map(row)));
  const drawing = h("div", { class: "scroll" });
  drawing.append(crewDrawing(model, side, numbersOf(plan, turns), plan.turns.filter((turn) => turn.crew === crew).map(({ edge }) => edge)));
  return h("article", { class: "crew", "data-crew": crew },
    h("h3", {}, title, h("small", {}, of)),
    ...warningsOf(plan).map((text) => h("p", { class: "how print-only" }, h("strong", {}, text))),
    drawing,
    h("div", { class: "scroll list-rows" }, h("table", { class: "plain" },
      h("caption", { class: "hidden" }, `Turns of crew ${crew}, in the order of work, ${place}`),
      // Each printed sheet names its crew and plan.
      h("thead", {}, h("tr", { class: "whose" }, h("th", { colspan: columns.length }, title, h("small", {}, of), h("br"), record)),
        h("tr", {}, ...columns.map(({ head, isText }) => h("th", { scope: "col", class: isText ? "text" : "" }, head)))), ...bodies)),
    h("p", { class: "how print-only" }, how),
    h("p", { class: "sign print-only" }, "done by ____________________   date ____________   checked by ____________________"));
}

function sheetsOf(sheets: Sheets, crew: number): HTMLElement[] {
  const rows = warningsOf(sheets.plan).length > 0 ? rowsOnSheet.warned : rowsOnSheet.plain;
  const own = sheets.plan.turns.map((_, i) => i).filter((i) => sheets.plan.turns[i]!.crew === crew);
  const count = Math.ceil(own.length / rows);
  return Array.from({ length: count }, (_, k) =>
    sheet(sheets, crew, own.slice(k * rows, (k + 1) * rows), `${counted(own.length, "line")} · sheet ${k + 1} of ${count}`));
}

/** Prints the lists only. */
function printLists(): void {
  document.body.classList.add("crews-only");
  addEventListener("afterprint", () => document.body.classList.remove("crews-only"), { once: true });
  print();
}

/** The work lists, one per crew, in the order of work. */
export function crewsSection(plan: Plan, model: Model, notebook: Notebook): HTMLElement {
  const heading = "Lists for the crews";
  if (plan.turns.length === 0) return section("crews", heading, h("p", { class: "quiet" }, "Nothing to turn: there is no list."));
  const { thread } = plan.options;
  const { crews, passes } = plan.order;
  const together = crews > 1 ? " Turns of the same step are made together. Begin a step only when all crews have finished the one before." : plan.order.safe ? " Keep to the order: it was checked step by step." : "";
  const again = passes > 1 ? " A cable may come again in a later pass: its scale reading is after that pass, its tension after all passes." : "";
  const threads = thread === null ? "Threads are right-hand or left-hand as given in the net." : `The turnbuckles have a ${thread}-hand thread.`;
  const turning = hasRotation(plan) ? `${threads} Clockwise is seen from the support along the cable.` : "The direction of rotation is not given, because the thread is not known.";
  const how = `Numbers are those of the drawing, names beside them those of the supports; nodes at both ends of a cable stand in brackets. ${turning} The scale reading is the turnbuckle's length after the turn less its design length; + is longer. The tension is the cable's after all turns.${hasFrequencies(plan) ? " The frequency is what the cable should have right after its own turn, as uncertain as half of what its tension is, and of its mass." : ""}${together}${again}`;
  const made = "Tick off what is turned. Where something else was turned, enter it; a minus is the other way round.";
  const present = [...new Set(plan.turns.map((t) => t.crew))].sort((a, b) => a - b);
  const idle = crews - present.length;
  const common = { plan, model, notebook, side: sideOf(model.form), how };
  const sheets = { ...common, columns: columnsOf(common) };
  addEventListener("message", ({ source, data }: MessageEvent<{ taut?: unknown } | null>) => {
    if (source === parent && parent !== window && data?.taut === "print") printLists();
  });
  return section("crews", heading,
    h("div", { class: "no-print tools" }, h("button", { type: "button", class: "print", onclick: printLists }, "Print the lists"), madeBar(plan, notebook)),
    h("p", { class: "how no-print" }, `${how} ${made}`),
    ...warningsOf(plan).map((text) => h("p", { class: "how no-print" }, h("strong", {}, text))),
    idle > 0 ? h("p", { class: "quiet" }, `${counted(idle, "crew")} ${idle === 1 ? "has" : "have"} no work.`) : null,
    ...present.flatMap((crew) => sheetsOf(sheets, crew)));
}
