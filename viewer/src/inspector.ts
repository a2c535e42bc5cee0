// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";
import { fixed } from "./format";
import type { Model, Quantity } from "./model";
import type { Item, Selection } from "./selection";

function valueText(quantity: Quantity, index: number): string {
  const value = quantity.values[index]!;
  if (Number.isNaN(value)) return "–";
  if (quantity.kind === "names") return quantity.names![value]!.text;
  const end = (ends: Float64Array): string => fixed(ends[index]!, quantity.decimals);
  const interval = quantity.interval ? ` (95 %: ${end(quantity.interval.lower)} to ${end(quantity.interval.upper)})` : "";
  return `${fixed(value, quantity.decimals)} ${quantity.unit}${interval}`;
}

function heading(model: Model, item: Item): string {
  if (item.of === "edge") return `Edge ${model.edgeId(item.index)}`;
  return `${model.isSupport[item.index] ? "Support" : "Free node"} ${model.nodeId(item.index)}`;
}

function rows(model: Model, item: Item): [string, string][] {
  const own = model.quantities
    .filter((q) => q.of === item.of)
    .map((q): [string, string] => [q.label, valueText(q, item.index)])
    .filter(([, text]) => text !== "–");
  if (item.of === "edge") {
    const [s, t] = [model.ends[2 * item.index]!, model.ends[2 * item.index + 1]!];
    return [
      ["nodes", `${model.nodeId(s)} – ${model.nodeId(t)}`],
      ["design unstressed length", `${fixed(model.unstressed[item.index]!, 4)} m`],
      ...own,
    ];
  }
  const [x, y, z] = model.form.subarray(3 * item.index, 3 * item.index + 3);
  return [["position x, y, z", `${fixed(x!, 3)}, ${fixed(y!, 3)}, ${fixed(z!, 3)} m`], ...own, ...(model.remarks.get(item.index) ?? [])];
}

/** All values of the selected edge or node. */
export function inspector(model: Model, selection: Selection): HTMLElement {
  const box = h("div", { class: "inspector", role: "status", "aria-live": "polite" });
  const draw = (): void => {
    const item = selection.selected;
    if (!item) {
      box.replaceChildren(h("p", { class: "quiet" }, "Click an edge or a node, in the view, a chart or the table, to see all its values."));
      return;
    }
    const list = h("dl", {}, ...rows(model, item).flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
    box.replaceChildren(h("h3", {}, heading(model, item)), list);
  };
  selection.subscribe(draw);
  draw();
  return box;
}

/** A label beside the pointer, with the value that is shown in colour. */
export function tooltip(model: Model, selection: Selection, shown: () => Quantity | null): HTMLElement {
  const box = h("div", { class: "tooltip no-print", "aria-hidden": "true" });
  box.hidden = true;
  addEventListener("pointermove", (event) => {
    box.style.left = `${Math.min(event.clientX + 14, innerWidth - 230)}px`;
    box.style.top = `${event.clientY + 16}px`;
  });
  selection.subscribe(() => {
    const item = selection.hovered;
    box.hidden = item === null;
    if (!item) return;
    const quantity = shown();
    const value = quantity?.of === item.of ? valueText(quantity, item.index) : "";
    const first = model.quantities.find((q) => q.of === item.of && q.unit !== "" && !Number.isNaN(q.values[item.index]));
    const text = value && value !== "–" ? `${quantity!.label}: ${value}` : first ? `${first.label}: ${valueText(first, item.index)}` : "";
    box.replaceChildren(h("strong", {}, heading(model, item)), ...(text ? [h("div", {}, text)] : []));
  });
  return box;
}
