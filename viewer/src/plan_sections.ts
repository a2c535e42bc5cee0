// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { plainTable } from "./details";
import { h, section } from "./dom";
import { counted, fixed, millimetres, number, percent } from "./format";
import type { FormDeviation, Plan, Turn } from "./result";

/** As built, planned, and what no stroke removes; then the limits that are not kept. */
export function planSection(plan: Plan): HTMLElement {
  const { as_built, planned, unconstrained, normal_std } = plan.form;
  const rows: [string, keyof FormDeviation][] = [
    ["along the normal, RMS", "normal_rmse"], ["along the normal, mean", "normal_mean"], ["along the normal, at most", "normal_max"],
    ["in all directions, RMS", "rmse"], ["in all directions, mean", "mean"], ["in all directions, at most", "max"],
  ];
  const unknown = plan.draws > 0
    ? `Of the planned form, ${millimetres(normal_std)} mm along the normal (RMS) are not known yet: another survey can tell them, turning cannot.`
    : "How well the planned form is known is not told: the plan was made without draws.";
  const most = 40;
  const violations = plan.violations.slice(0, most);
  return section("plan", "Distance from the target, and limits",
    plainTable("Distance from the target", ["Distance from the target [mm]", "as built", "as planned", "no stroke removes"],
      rows.map(([label, key]) => [label, millimetres(as_built[key]), millimetres(planned[key]), millimetres(unconstrained[key])]), ["", "", "here", ""]),
    h("p", { class: "quiet" }, unknown, " The last column is what the best strokes without limits leave; as they make the weighted RMS small, single numbers may be above those planned."),
    plan.violations.length === 0 ? h("p", { class: "quiet" }, `${plan.limits_given === false ? "No limits of tension or reaction were given; no cable goes slack, which is kept" : "Every limit is kept"}${plan.draws > 0 ? " as surely as was asked for" : " by the estimate"}.`)
      : plainTable("Limits that are not kept, or not surely", [plan.feasible ? "Least sure limits" : "Limits in the way", "under the loads", "as planned [kN]", "limit [kN]", "kept with [%]"],
        violations.map((b) => [`${b.kind === "tension" ? "tension of edge" : "reaction of support"} ${b.id}`, b.load_case ?? "of the net", number(b.value / 1e3), number(b.limit / 1e3), plan.draws > 0 ? percent(b.probability) : "–"]), ["", "text", "", "", ""]),
    plan.violations.length > most ? h("p", { class: "quiet" }, `and ${plan.violations.length - most} more, all of them in the plan's file`) : null);
}

const vulgar: Record<string, string> = { "1/2": "½", "1/4": "¼", "3/4": "¾", "1/3": "⅓", "2/3": "⅔", "1/8": "⅛", "3/8": "⅜", "5/8": "⅝", "7/8": "⅞" };
const divisor = (a: number, b: number): number => (b === 0 ? a : divisor(b, a % b));

/** Turns as they are counted by hand: "1 ¾" where the step is a part of a turn, else "1.72". */
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

/** Whether the thread of any turnbuckle is known, and so which way it is to be turned. */
const tellsRotation = (plan: Plan): boolean => plan.turns.some((turn) => turn.rotation !== null);

function rotationText(turn: Turn): string {
  if (turn.rotation === null) return "–";
  return turn.rotation === "clockwise" ? "↻ clockwise" : "↺ counterclockwise";
}

/** What one crew does in one pass. */
function rowsOf(plan: Plan, turns: Turn[]): HTMLElement[] {
  const { pitch } = plan.options;
  const withRotation = tellsRotation(plan);
  return turns.map((turn) => h("tr", {},
    h("td", {}, h("span", { class: "tick", role: "img", "aria-label": "to tick" })),
    h("td", {}, turn.step + 1),
    h("th", { scope: "row", class: "text" }, turn.edge_id),
    h("td", { class: `text ${turn.action}` }, turn.action === "shorten" ? "→← shorten" : "←→ lengthen"),
    withRotation ? h("td", { class: "text" }, rotationText(turn)) : null,
    pitch === null ? null : h("td", { class: "turns" }, turn.turns === null ? "–" : turnsText(turn.turns, plan.options)),
    h("td", {}, fixed(Math.abs(1e3 * turn.stroke), 2)),
    h("td", {}, signed(1e3 * turn.reading_after, 2)),
    h("td", {}, plan.draws > 0 ? fixed(turn.tension_after / 1e3, 2) : "–")));
}

/** What must be known before the first turn, on the sheets of each crew. */
function warningsOf(plan: Plan): string[] {
  if (plan.warnings && plan.warnings.length > 0) return plan.warnings;
  return [
    ...(plan.identification.verdict === "failed" ? ["The identification that this plan stands on failed its tests: do not work from it before what the report names is mended."] : []),
    ...(plan.feasible ? [] : ["This plan does not keep all limits: do not work from it before they are cleared."]),
    ...(plan.order.safe ? [] : ["No safe order was found: somebody must watch what the head of the report names."]),
  ];
}

function crewList(plan: Plan, crew: number, how: string): HTMLElement {
  const own = plan.turns.filter((t) => t.crew === crew);
  const passes = [...new Set(own.map((t) => t.pass))];
  const head = ["", "step", "cable", "do", ...(tellsRotation(plan) ? ["turn"] : []), ...(plan.options.pitch === null ? [] : ["turns"]), "by [mm]", "reading afterwards [mm]", "tension at the end [kN]"];
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
      h("caption", { class: "hidden" }, `What crew ${crew} turns, in the order of the work`),
      // Each sheet of paper tells whose it is, and of which plan.
      h("thead", {}, h("tr", { class: "whose" }, h("th", { colspan: head.length }, title, h("small", {}, of))), h("tr", {}, ...head.map((text) => h("th", { scope: "col", class: ["cable", "do", "turn"].includes(text) ? "text" : "" }, text)))), ...bodies)),
    h("p", { class: "sign print-only" }, "done by ____________________   date ____________   checked by ____________________"));
}

/** Paper gets the lists alone. */
function printLists(): void {
  document.body.classList.add("crews-only");
  addEventListener("afterprint", () => document.body.classList.remove("crews-only"), { once: true });
  print();
}

/** The lists to work from, each crew its own, in the order of the work. */
export function crewsSection(plan: Plan): HTMLElement {
  const heading = "Lists for the crews";
  if (plan.turns.length === 0) return section("crews", heading, h("p", { class: "quiet" }, "Nothing is to be turned: there is no list."));
  const { thread } = plan.options;
  const { crews, passes } = plan.order;
  const together = crews > 1 ? " What has the same step is turned at once; nobody begins a step before all crews have ended the one before." : " Keep to the order: it was checked step by step.";
  const again = passes > 1 ? ` A cable may come again in a later pass: its reading is that after the pass, its tension that after all.` : "";
  const threads = thread === null ? "Right-hand and left-hand threads are as the net tells." : `The turnbuckles have a ${thread}-hand thread.`;
  const turning = tellsRotation(plan) ? `${threads} Clockwise is as seen from the support along the cable.` : "Which way to turn is not told, as the thread is not known.";
  const how = `${turning} The reading is how far the turnbuckle then stands from its designed length, + for longer; the tension is the cable's when all is done.${together}${again}`;
  const present = [...new Set(plan.turns.map((t) => t.crew))].sort((a, b) => a - b);
  const idle = crews - present.length;
  return section("crews", heading,
    h("div", { class: "no-print tools" }, h("button", { type: "button", class: "print", onclick: printLists }, "Print the lists")),
    h("p", { class: "how no-print" }, how),
    ...warningsOf(plan).map((text) => h("p", { class: "how no-print" }, h("strong", {}, text))),
    idle > 0 ? h("p", { class: "quiet" }, `${counted(idle, "crew")} ${idle === 1 ? "has" : "have"} nothing to do.`) : null,
    ...present.map((crew) => crewList(plan, crew, how)));
}
