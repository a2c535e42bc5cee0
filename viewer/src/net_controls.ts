// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";
import { clearExaggeration } from "./error_ellipses";
import { extentOf } from "./extent";
import { factorText, nice } from "./format";
import { ellipseLegend, legend, strokeLegend } from "./legend";
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
  return largest > 0 ? Math.max(1, nice(extentOf(model.form) / 5 / largest)) : 1;
}

/** Mean length of an edge. */
function meanLength({ ends, form, edgeCount }: Model): number {
  let sum = 0;
  for (let e = 0; e < edgeCount; ++e) {
    const [s, t] = [3 * ends[2 * e]!, 3 * ends[2 * e + 1]!];
    sum += Math.hypot(form[s]! - form[t]!, form[s + 1]! - form[t + 1]!, form[s + 2]! - form[t + 2]!);
  }
  return sum / Math.max(edgeCount, 1);
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
  private readonly ellipses = h("input", { type: "checkbox", id: "ellipses", class: "tick" });
  private readonly ellipseSlider = h("input", { type: "range", id: "ellipse-exaggeration", min: 1, max: 100, value: 50, disabled: true, "aria-label": "Exaggeration of the ellipses" });
  private readonly ellipseKey = h("div", { class: "key" });
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
    for (const input of [this.ellipses, this.ellipseSlider]) input.addEventListener("input", () => this.outline());
    this.names.addEventListener("change", () => this.view?.setLabels(this.names.value as Labelled));
    this.element = h("div", { class: "controls" },
      field("Colour by", this.colourBy), this.key,
      model.strokes.size > 0 ? strokeLegend(model) : null,
      field("Show displacement", this.moved),
      field("Exaggeration", h("span", { class: "slider" }, this.slider, this.factor)),
      model.covariances.length > 0 ? h("div", { class: "field slider" }, h("label", {}, this.ellipses, " Error ellipses, 95 %"), this.ellipseSlider) : null,
      this.ellipseKey,
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
    this.factor.textContent = displacement ? factorText(factor) : "";
    this.view?.setDisplacement(displacement, factor);
    this.outline();
  }

  private outline(): void {
    const isShown = this.ellipses.checked;
    const factor = isShown ? clearExaggeration(this.model.covariances, meanLength(this.model)) * (Number(this.ellipseSlider.value) / 50) ** 2 : 0;
    this.ellipseSlider.disabled = !isShown;
    this.view?.setEllipses(factor);
    this.ellipseKey.replaceChildren(...(isShown ? [ellipseLegend(this.model, factor, this.view?.hasEllipses ?? false)] : []));
  }

  private look(viewpoint: Viewpoint): void {
    this.view?.setViewpoint(viewpoint);
    for (const button of this.viewpoints) button.setAttribute("aria-pressed", String(button.dataset.view === viewpoint));
  }
}
