// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { chartElement, type Figure } from "./chart";
import { comparisonFigures } from "./comparison_figures";
import { controlFigures } from "./control_figures";
import { h, section } from "./dom";
import { identificationFigures } from "./identification_figures";
import { inkStyle } from "./inks";
import type { Model } from "./model";
import { planFigures } from "./plan_figures";
import type { Result } from "./result";
import type { Selection } from "./selection";
import { studyFigures } from "./study_figures";

function figuresOf(result: Result, model: Model | null): Figure[] {
  switch (result.format) {
    case "taut-study": return studyFigures(result, model!);
    case "taut-identification": return identificationFigures(result, model!);
    case "taut-plan": return planFigures(result, model!);
    case "taut-comparison": return comparisonFigures(result);
    case "taut-control": return controlFigures(result);
  }
}

/** All figures of a result. */
export function figuresSection(result: Result, model: Model | null, selection: Selection): HTMLElement {
  document.head.append(h("style", {}, inkStyle()));
  const all = figuresOf(result, model).filter((figure) => figure.charts.length > 0);
  return section("figures", "Figures",
    h("p", { class: "quiet no-print" }, "Draw a box over a chart to zoom in; double-click to see all of it."),
    ...all.map(({ heading, charts, caption }) => h("figure", {},
      h("h3", {}, heading),
      h("div", { class: "drawings" }, ...charts.map((chart) => chartElement(chart, selection))),
      h("figcaption", {}, caption))));
}
