// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { checksBox, type ShowItem } from "./checks";
import { ofComparison } from "./comparison_summary";
import { ofControl } from "./control_summary";
import { h } from "./dom";
import { ofIdentification } from "./identification_summary";
import type { Notebook } from "./notes";
import { ofPlan, planBoxes } from "./plan_summary";
import type { Result } from "./result";
import { ofStudy } from "./study_summary";
import type { Summary } from "./summary_words";

function summaryOf(result: Result): Summary {
  switch (result.format) {
    case "taut-study": return ofStudy(result);
    case "taut-identification": return ofIdentification(result);
    case "taut-plan": return ofPlan(result);
    case "taut-comparison": return ofComparison(result);
    case "taut-control": return ofControl(result);
  }
}

/** The top of the page, for who reads nothing else. */
export function summary(result: Result, notebook: Notebook, show: ShowItem): HTMLElement {
  const { title, done, sentences, figures } = summaryOf(result);
  document.title = `${result.net.name || "A net"} – taut report`;
  const cards = figures.map(({ value, unit, label }) =>
    h("div", { class: "card" }, h("div", { class: "value" }, value, h("small", {}, unit ? ` ${unit}` : "")), h("div", { class: "label" }, label)));
  const provenance = [result.program, result.date, result.net.fingerprint && `net ${result.net.fingerprint}`].filter(Boolean).join(" · ");
  return h("header", {},
    h("div", { class: "brand" }, h("span", { class: "logo", "aria-hidden": "true" }), h("span", {}, "taut report"), h("span", { class: "quiet provenance" }, provenance)),
    h("h1", {}, result.net.name || "A net", h("small", {}, title)),
    notebook.fields(),
    ...(result.format === "taut-plan" ? planBoxes(result) : [checksBox(result, show)]),
    h("p", { class: "done" }, done),
    h("ol", { class: "sentences", "aria-label": "Main results" }, ...sentences.map((text) => h("li", {}, text))),
    cards.length > 0 ? h("div", { class: "cards" }, ...cards) : null);
}
