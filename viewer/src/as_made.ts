// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { csvOf, download } from "./csv";
import { h } from "./dom";
import { fixed } from "./format";
import type { Notebook } from "./notes";
import type { Plan, Turn } from "./result";

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

/** The number in "1 ¾", "1 3/4", "1.75", "1,75" or "-0.5"; NaN of anything else. */
export function numberOf(text: string): number {
  const plain = Object.entries(vulgar).reduce((all, [fraction, sign]) => all.replace(sign, ` ${fraction}`), text).replace(/[−–]/, "-").replace(",", ".");
  const parts = /^\s*([-+]?)\s*(\d+(?:\.\d+)?|\.\d+)?(?:\s*(?<!\d)(\d{1,2})\/(\d{1,2}))?\s*$/.exec(plain);
  if (!parts || (parts[2] === undefined && parts[3] === undefined)) return NaN;
  const value = Number(parts[2] ?? 0) + (parts[3] === undefined ? 0 : Number(parts[3]) / Number(parts[4]));
  return parts[1] === "-" ? -value : value;
}

/** Metres of one unit in which a crew counts: a turn, where the plan has a pitch, or a millimetre. */
const unitOf = ({ options }: Plan): number => options.pitch ?? 1e-3;

const sameWay = ({ action }: Turn): number => (action === "lengthen" ? 1 : -1);

/** Where a turn is ticked off, and what was really turned is entered: in turns or millimetres the planned way round. */
export function madeCell(plan: Plan, index: number, notebook: Notebook): HTMLElement[] {
  const turn = plan.turns[index]!;
  const unit = unitOf(plan);
  const planned = Math.abs(turn.stroke) / unit;
  const words = (value: number): string => (plan.options.pitch === null ? fixed(value, 2) : turnsText(value, plan.options));
  const name = `cable ${turn.edge_id}, pass ${turn.pass}`;
  const done = h("input", { type: "checkbox", class: "tick", "aria-label": `${name} is turned` });
  const value = h("input", { type: "text", class: "as-made", inputmode: "decimal", placeholder: words(planned), autocomplete: "off", "aria-label": `as made, ${name}` });
  const set = (stroke: number | null): void => {
    const strokes = plan.turns.map((_, i) => notebook.notes.strokes?.[i] ?? null);
    strokes[index] = stroke;
    notebook.change({ strokes });
  };
  // Millimetres entered for turns are seen beside what was planned.
  const meant = h("small", { class: "meant" });
  const isRefused = (): boolean => value.getAttribute("aria-invalid") === "true";
  done.addEventListener("change", () => set(done.checked && !isRefused() ? turn.stroke : null));
  value.addEventListener("change", () => {
    if (value.value.trim() === "") {
      value.setAttribute("aria-invalid", "false");
      value.title = "";
      return set(null);
    }
    const stroke = numberOf(value.value) * unit * sameWay(turn);
    // A slip of the pen is no turn, nor is the planned one made then.
    const isWrong = !(Math.abs(stroke) <= Math.max(10 * Math.abs(turn.stroke), 0.05));
    value.setAttribute("aria-invalid", String(isWrong));
    value.title = !isWrong ? "" : `expected ${plan.options.pitch === null ? "millimetres, such as 2.5" : "turns, such as 1 3/4"}${Number.isNaN(stroke) ? "" : ", no more than ten times the planned ones"}`;
    set(isWrong ? null : stroke);
  });
  notebook.subscribe(() => {
    const stroke = notebook.notes.strokes?.[index] ?? null;
    done.checked = stroke !== null;
    const asPlanned = stroke === null || Math.abs(stroke - turn.stroke) < 1e-9;
    const mm = plan.options.pitch === null || asPlanned ? "" : `${fixed(1e3 * stroke! * sameWay(turn), 2)} mm`;
    meant.textContent = mm && ` = ${mm}, ${fixed(1e3 * Math.abs(turn.stroke), 2)} mm planned`;
    if (document.activeElement === value || isRefused()) return;
    value.value = asPlanned ? "" : words(0) === "0" && stroke === 0 ? "0" : `${stroke! * sameWay(turn) < 0 ? "−" : ""}${words(Math.abs(stroke!) / unit)}`;
  });
  return [done, value, meant];
}

/** What was turned, as `identify --epoch SURVEY:TURNED` reads it; null where nothing was. */
export function turnedCsv(plan: Pick<Plan, "turns">, strokes: (number | null)[] = []): string | null {
  const sums = new Map<string, number>();
  plan.turns.forEach(({ edge_id }, i) => {
    const stroke = strokes[i] ?? null;
    if (stroke !== null) sums.set(edge_id, (sums.get(edge_id) ?? 0) + stroke);
  });
  return sums.size === 0 ? null : csvOf(["edge", "stroke"], [...sums]);
}

/** How many turns are made, and the file of them. */
export function madeBar(plan: Plan, notebook: Notebook): HTMLElement {
  const count = h("span", { role: "status", class: "quiet" });
  const save = h("button", { type: "button", id: "save-turned", onclick: () => download("turned.csv", turnedCsv(plan, notebook.notes.strokes) ?? "") }, "Save what was turned");
  notebook.subscribe(() => {
    const made = (notebook.notes.strokes ?? []).filter((stroke) => stroke !== null).length;
    count.textContent = `${made} of ${plan.turns.length} turned`;
    save.disabled = made === 0;
  });
  return h("span", { class: "made-bar" }, count, " ", save);
}
