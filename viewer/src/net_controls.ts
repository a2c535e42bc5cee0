// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";
import { nice } from "./format";
import { legend, strokeLegend } from "./legend";
import type { Displacement, Model, Quantity } from "./model";
import type { Viewpoint } from "./net_camera";
import { type Labelled, labelled } from "./net_labels";
import type { NetView } from "./view";

/** The factor at which the largest displacement of its scale is a fifth of the net. */
function largestFactor(model: Model, displacement: Displacement): number {
  let largest = 0;
  for (const other of model.displacements) {
    if (other !== displacement && !(displacement.scale && other.scale === displacement.scale)) continue;
    const { vectors } = other;
    for (let i = 0; i < vectors.length; i += 3) {
      largest = Math.max(largest, Math.hypot(vectors[i]!, vectors[i + 1]!, vectors[i + 2]!));
    }
  }
  let extent = 0;
  for (let k = 0; k < 3; ++k) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < model.form.length; i += 3) [low, high] = [Math.min(low, model.form[i]!), Math.max(high, model.form[i]!)];
    extent = Math.max(extent, high - low);
  }
  return largest > 0 ? Math.max(1, nice(extent / 5 / largest)) : 1;
}

function field(label: string, control: HTMLElement): HTMLElement {
  return h("label", { class: "field" }, h("span", {}, label), control);
}

/** Controls of the view: colours, displacement and viewpoint. */
export class NetControls {
  readonly element: HTMLElement;
  quantity: Quantity;
  private readonly key = h("div", { class: "key" });
  private readonly colourBy = h("select", { id: "colour-by" });
  private readonly moved = h("select", { id: "displacement" }, h("option", { value: -1 }, "none"));
  private readonly slider = h("input", { type: "range", id: "exaggeration", min: 0, max: 100, value: 50, disabled: true });
  private readonly factor = h("output", { for: "exaggeration" });
  private readonly names = h("select", { id: "labels" }, ...labelled.map((which) => h("option", {}, which)));
  private readonly viewpoints: HTMLElement[];
  private view: NetView | null = null;

  /** @param first key of the quantity that is shown at first */
  constructor(private readonly model: Model, first: string) {
    this.quantity = model.quantities.find((q) => q.key === first) ?? model.quantities[0]!;
    for (const [of, label] of [["edge", "Edges"], ["node", "Nodes"]] as const) {
      const options = model.quantities.filter((q) => q.of === of)
        .map((q) => h("option", { value: q.key, selected: q === this.quantity }, q.unit ? `${q.label} [${q.unit}]` : q.label));
      this.colourBy.append(h("optgroup", { label }, ...options));
    }
    model.displacements.forEach((d, i) => this.moved.append(h("option", { value: i }, d.label)));
    this.viewpoints = ([["perspective", "Perspective"], ["top", "Top view"]] as const).map(([viewpoint, label]) =>
      h("button", { type: "button", "data-view": viewpoint, onclick: () => this.look(viewpoint) }, label));
    this.colourBy.addEventListener("change", () => this.colour());
    this.moved.addEventListener("change", () => this.move());
    this.slider.addEventListener("input", () => this.move());
    this.names.addEventListener("change", () => this.view?.setLabels(this.names.value as Labelled));
    this.element = h("div", { class: "controls" },
      field("Colour by", this.colourBy), this.key,
      model.strokes.size > 0 ? strokeLegend(model) : null,
      field("Show displacement", this.moved),
      field("Exaggeration", h("span", { class: "slider" }, this.slider, this.factor)),
      field("Labels", this.names),
      h("div", { class: "buttons no-print", role: "group", "aria-label": "Viewpoint" }, ...this.viewpoints));
    this.key.append(legend(model, this.quantity));
  }

  /** Connects the controls to a view. */
  connect(view: NetView): void {
    this.view = view;
    this.colour();
    this.move();
    this.look("perspective");
  }

  private colour(): void {
    this.quantity = this.model.quantities.find((q) => q.key === this.colourBy.value) ?? this.quantity;
    this.view?.setQuantity(this.quantity);
    this.key.replaceChildren(legend(this.model, this.quantity));
  }

  private move(): void {
    const displacement = this.model.displacements[Number(this.moved.value)] ?? null;
    const factor = displacement ? (largestFactor(this.model, displacement) * Number(this.slider.value)) / 100 : 0;
    this.slider.disabled = displacement === null;
    this.factor.textContent = displacement ? `× ${factor < 10 ? factor.toFixed(1) : Math.round(factor)}` : "";
    this.view?.setDisplacement(displacement, factor);
  }

  private look(viewpoint: Viewpoint): void {
    this.view?.setViewpoint(viewpoint);
    for (const button of this.viewpoints) button.setAttribute("aria-pressed", String(button.dataset.view === viewpoint));
  }
}
