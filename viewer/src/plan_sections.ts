// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h, section } from "./dom";
import { counted, fixed, millimetres, number, percent } from "./format";
import { plainTable } from "./plain_table";
import type { FormDeviation, Plan, Turn } from "./result";

/** Deviation from the target as built, as planned and without limits; then the limits that are not kept. */
export function planSection(plan: Plan): HTMLElement {
  const { as_built, planned, unconstrained, normal_std } = plan.form;
  const rows: [string, keyof FormDeviation][] = [
    ["normal, RMS", "normal_rmse"], ["normal, mean", "normal_mean"], ["normal, max", "normal_max"],
    ["3D, RMS", "rmse"], ["3D, mean", "mean"], ["3D, max", "max"],
  ];
  const std = plan.draws > 0
    ? `The planned form has a std along the normal of ${millimetres(normal_std)} mm (RMS). Another survey reduces it; turning does not.`
    : "The uncertainty of the planned form is not known: the plan has no posterior samples.";
  const most = 40;
  const violations = plan.violations.slice(0, most);
  return section("plan", "Deviation from the target, and limits",
    plainTable("Deviation from the target", ["Deviation from the target [mm]", "as built", "as planned", "unconstrained optimum"],
      rows.map(([label, key]) => [label, millimetres(as_built[key]), millimetres(planned[key]), millimetres(unconstrained[key])]), ["", "", "here", ""]),
    h("p", { class: "quiet" }, std, " The unconstrained optimum minimises the weighted RMS with unlimited strokes; its other numbers may be larger than the planned ones."),
    plan.violations.length === 0 ? h("p", { class: "quiet" }, `${plan.limits_given === false ? "No limits of tension or reaction were given; no cable goes slack" : "Every limit is kept"}${plan.draws > 0 ? " with the required probability" : " by the estimate"}.`)
      : plainTable("Limits that are not kept with the required probability", [plan.feasible ? "Least probable limits" : "Limits not kept", "load case", "as planned [kN]", "limit [kN]", "probability [%]"],
        violations.map((b) => [`${b.kind === "tension" ? "tension of edge" : "reaction of support"} ${b.id}`, b.load_case ?? "loads of the net", number(b.value / 1e3), number(b.limit / 1e3), plan.draws > 0 ? percent(b.probability) : "–"]), ["", "text", "", "", ""]),
    plan.violations.length > most ? h("p", { class: "quiet" }, `${plan.violations.length - most} more are in the plan's file`) : null);
}

const vulgar: Record<string, string> = { "1/2": "½", "1/4": "¼", "3/4": "¾", "1/3": "⅓", "2/3": "⅔", "1/8": "⅛", "3/8": "⅜", "5/8": "⅝", "7/8": "⅞" };
const divisor = (a: number, b: number): number => (b === 0 ? a : divisor(b, a % b));

/** Turns as counted by hand: "1 ¾" where the step is a fraction of a turn, else "1.72". */
export function turnsText(turns: number, { pitch, step }: Plan["options"]): string {
  const parts = pitch && step ? Math.round(pitch / step) : 0;
  const count = Math.round(turns * parts);
  if (!(parts >= 1) || parts > 64 || Math.abs(parts * step! - pitch!) > 1e-6 * pitch! || Math.abs(count - turns * parts) > 1e-3) return fixed(turns, 2);
  const [whole, rest] = [Math.floor(count / parts), count % parts];
  if (rest === 0) return String(whole);
  const common = divisor(rest, parts);
  const fraction = `${rest / common}/${parts / common}`;
  return `${whole > 0 ? `${whole} ` : ""}${vulgar[fraction] ?? fraction}`;
}

const signed = (value: number, decimals: number): string => (value > 0 ? "+" : "") + fixed(value, decimals);

/** Whether the thread of any turnbuckle is known, and with it the direction of rotation. */
const hasRotation = (plan: Plan): boolean => plan.turns.some((turn) => turn.rotation !== null);

function rotationText(turn: Turn): string {
  if (turn.rotation === null) return "–";
  return turn.rotation === "clockwise" ? "↻ clockwise" : "↺ counterclockwise";
}

/** The turns of one crew in one pass. */
function rowsOf(plan: Plan, turns: Turn[]): HTMLElement[] {
  const { pitch } = plan.options;
  const withRotation = hasRotation(plan);
  return turns.map((turn) => h("tr", {},
    h("td", {}, h("span", { class: "tick", role: "img", "aria-label": "done" })),
    h("td", {}, turn.step + 1),
    h("th", { scope: "row", class: "text" }, turn.edge_id),
    h("td", { class: `text ${turn.action}` }, turn.action === "shorten" ? "→← shorten" : "←→ lengthen"),
    withRotation ? h("td", { class: "text" }, rotationText(turn)) : null,
    pitch === null ? null : h("td", { class: "turns" }, turn.turns === null ? "–" : turnsText(turn.turns, plan.options)),
    h("td", {}, fixed(Math.abs(1e3 * turn.stroke), 2)),
    h("td", {}, signed(1e3 * turn.reading_after, 2)),
    h("td", {}, plan.draws > 0 ? fixed(turn.tension_after / 1e3, 2) : "–")));
}

/** Warnings before the first turn, on the sheets of each crew. */
function warningsOf(plan: Plan): string[] {
  if (plan.warnings && plan.warnings.length > 0) return plan.warnings;
  return [
    ...(plan.identification.verdict === "failed" ? ["The identification of this plan failed its checks. Do not turn by this list; resolve the findings of the report first."] : []),
    ...(plan.feasible ? [] : ["This plan does not keep all limits. Do not turn by this list before they are cleared."]),
    ...(plan.order.safe ? [] : ["No safe order was found. Watch the limits that the top of the report names."]),
  ];
}

function crewList(plan: Plan, crew: number, how: string): HTMLElement {
  const own = plan.turns.filter((t) => t.crew === crew);
  const passes = [...new Set(own.map((t) => t.pass))];
  const head = ["", "step", "cable", "action", ...(hasRotation(plan) ? ["rotation"] : []), ...(plan.options.pitch === null ? [] : ["turns"]), "stroke [mm]", "scale reading after [mm]", "final tension [kN]"];
  const bodies = passes.map((pass) => h("tbody", {},
    h("tr", { class: "pass" }, h("th", { colspan: head.length, scope: "rowgroup" }, `Pass ${pass} of ${plan.order.passes}`)),
    ...rowsOf(plan, own.filter((t) => t.pass === pass))));
  const title = `Crew ${crew} of ${plan.order.crews}`;
  const of = ` ${plan.net.name || "net"} ${plan.net_fingerprint}${plan.date ? ` · ${plan.date}` : ""} · ${counted(own.length, "line")}`;
  return h("article", { class: "crew", "data-crew": crew },
    h("h3", {}, title, h("small", {}, of)),
    h("p", { class: "how print-only" }, how),
    ...warningsOf(plan).map((text) => h("p", { class: "how print-only" }, h("strong", {}, text))),
    h("div", { class: "scroll" }, h("table", { class: "plain" },
      h("caption", { class: "hidden" }, `Turns of crew ${crew}, in the order of work`),
      // Each printed sheet names its crew and plan.
      h("thead", {}, h("tr", { class: "whose" }, h("th", { colspan: head.length }, title, h("small", {}, of))), h("tr", {}, ...head.map((text) => h("th", { scope: "col", class: ["cable", "action", "rotation"].includes(text) ? "text" : "" }, text)))), ...bodies)),
    h("p", { class: "sign print-only" }, "done by ____________________   date ____________   checked by ____________________"));
}

/** Prints the lists only. */
function printLists(): void {
  document.body.classList.add("crews-only");
  addEventListener("afterprint", () => document.body.classList.remove("crews-only"), { once: true });
  print();
}

/** The work lists, one per crew, in the order of work. */
export function crewsSection(plan: Plan): HTMLElement {
  const heading = "Lists for the crews";
  if (plan.turns.length === 0) return section("crews", heading, h("p", { class: "quiet" }, "Nothing to turn: there is no list."));
  const { thread } = plan.options;
  const { crews, passes } = plan.order;
  const together = crews > 1 ? " Turns of the same step are made together. Begin a step only when all crews have finished the one before." : " Keep to the order: it was checked step by step.";
  const again = passes > 1 ? " A cable may come again in a later pass: its scale reading is after that pass, its tension after all passes." : "";
  const threads = thread === null ? "Threads are right-hand or left-hand as given in the net." : `The turnbuckles have a ${thread}-hand thread.`;
  const turning = hasRotation(plan) ? `${threads} Clockwise is seen from the support along the cable.` : "The direction of rotation is not given, because the thread is not known.";
  const how = `${turning} The scale reading is the turnbuckle's length after the turn less its design length; + is longer. The tension is the cable's after all turns.${together}${again}`;
  const present = [...new Set(plan.turns.map((t) => t.crew))].sort((a, b) => a - b);
  const idle = crews - present.length;
  return section("crews", heading,
    h("div", { class: "no-print tools" }, h("button", { type: "button", class: "print", onclick: printLists }, "Print the lists")),
    h("p", { class: "how no-print" }, how),
    ...warningsOf(plan).map((text) => h("p", { class: "how no-print" }, h("strong", {}, text))),
    idle > 0 ? h("p", { class: "quiet" }, `${counted(idle, "crew")} ${idle === 1 ? "has" : "have"} no work.`) : null,
    ...present.map((crew) => crewList(plan, crew, how)));
}
