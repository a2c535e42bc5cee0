// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { colourAt, css, palette } from "./colours";
import { h } from "./dom";
import { largestWords } from "./error_ellipses";
import { factorText, millimetres, short } from "./format";
import { type Model, type Quantity, rangeOf } from "./model";

/** Legend of a quantity's colours: a bar with numbers and unit, or names. */
export function legend(model: Model, quantity: Quantity): HTMLElement {
  const box = h("div", { class: "legend", role: "img" });
  if (quantity.kind === "names") {
    const used = new Set(quantity.values);
    const names = quantity.names!.filter((_, i) => used.has(i));
    for (const { text, colour } of names) {
      const swatch = h("span", { class: "swatch" });
      swatch.style.backgroundColor = css(colour);
      box.append(h("span", { class: "name" }, swatch, text));
    }
    if (quantity.key === "kind") {
      for (const text of ["free node", "support"]) box.append(h("span", { class: "name" }, h("span", { class: `swatch ${text.split(" ")[0]}` }), text));
    }
    box.setAttribute("aria-label", `Colours: ${names.map((n) => n.text).join(", ")}`);
    return box;
  }
  const [low, high] = rangeOf(model, quantity);
  const kind = quantity.kind;
  const bar = h("div", { class: "bar" });
  const stops = Array.from({ length: 17 }, (_, i) => css(colourAt(kind, i / 16)));
  bar.style.backgroundImage = `linear-gradient(to right, ${stops.join(",")})`;
  const ticks = [0, 0.25, 0.5, 0.75, 1].map((part) => h("span", {}, short(low + part * (high - low))));
  box.append(bar, h("div", { class: "ticks" }, ...ticks), h("div", { class: "unit" }, `${quantity.label} [${quantity.unit}]`));
  box.setAttribute("aria-label", `Colour scale of ${quantity.label}, from ${short(low)} to ${short(high)} ${quantity.unit}`);
  return box;
}

/** Legend of the arrows at the turnbuckles. */
export function strokeLegend(model: Model): HTMLElement {
  const strokes = [...model.strokes.values()];
  const entry = (text: string, colour: typeof palette.blue, count: number): HTMLElement => {
    const arrow = h("span", { class: "arrow", "aria-hidden": "true" }, "➜");
    arrow.style.color = css(colour);
    return h("span", { class: "name" }, arrow, `${text} (${count})`);
  };
  return h("div", { class: "legend strokes" },
    entry("shorten", palette.blue, strokes.filter((s) => s < 0).length),
    entry("lengthen", palette.orange, strokes.filter((s) => s > 0).length),
    h("div", { class: "unit" }, `longest arrow: ${millimetres(Math.max(...strokes.map(Math.abs)))} mm of stroke`));
}

/** Legend of the error ellipses. @param areDrawn false where another form is shown than the one they are of */
export function ellipseLegend(model: Model, factor: number, areDrawn: boolean): HTMLElement {
  const words = areDrawn ? `95 % error ellipses as seen, ${factorText(factor)}` : "none: this displacement shows another form";
  return h("div", { class: "legend ellipses" },
    h("span", { class: "name" }, h("span", { class: "swatch ellipse", "aria-hidden": "true" }), words),
    h("div", { class: "unit" }, `largest in plan: ${largestWords(model.covariances, model.nodeId)}`));
}
