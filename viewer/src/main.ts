// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { roundsSection } from "./control_sections";
import { comparisonSection, frameSection, listsSection, paperSection } from "./details";
import { crewsSection } from "./crew_list";
import { byId, h } from "./dom";
import { figuresSection } from "./figures";
import { indexOf, type Model, modelOfIdentification, modelOfStudy } from "./model";
import { netSection } from "./net_section";
import { keyOf, Notebook } from "./notes";
import { modelOfPlan } from "./plan_model";
import { planSection } from "./plan_sections";
import { readResult, type Result } from "./result";
import { Selection } from "./selection";
import { settingsSection } from "./settings";
import { summary } from "./summary";
import { tablesSection } from "./tables";

function modelOf(result: Result): Model | null {
  if (result.format === "taut-study") return modelOfStudy(result);
  if (result.format === "taut-plan") return modelOfPlan(result);
  return result.format === "taut-identification" ? modelOfIdentification(result) : null;
}

/** Quantities shown first in view and tables. */
const firstShown = {
  "taut-study": { edge: "identified", node: "form_identified" },
  "taut-identification": { edge: "identified", node: "form_predicted" },
  "taut-plan": { edge: "stroke", node: "normal_planned" },
};

/** After the page was drawn once. */
const drawn = (): Promise<void> => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

/** Puts the page together; the view comes last. */
async function show(result: Result): Promise<void> {
  const main = byId("report");
  const selection = new Selection();
  const model = modelOf(result);
  const figures = figuresSection(result, model, selection);
  main.append(figures);
  let start = (): void => {};
  const notebook = new Notebook(keyOf(result));
  main.before(summary(result, notebook, (of, id) => {
    const index = model ? indexOf(model, of, id) : -1;
    return index < 0 ? null : () => selection.show({ of, index });
  }));
  if (model) {
    const first = firstShown[result.format as keyof typeof firstShown];
    const net = netSection(model, selection, first.edge);
    start = net.start;
    figures.before(net.element);
    if (result.format === "taut-study") main.append(paperSection(result));
    if (result.format === "taut-identification") {
      const frame = frameSection(result);
      figures.before(listsSection(result, model, selection), ...(frame ? [frame] : []));
    }
    if (result.format === "taut-plan") {
      net.element.before(planSection(result));
      main.append(crewsSection(result, model, notebook));
    }
    main.append(tablesSection(model, selection, first));
  } else if (result.format === "taut-comparison") {
    main.append(comparisonSection(result));
  } else if (result.format === "taut-control") {
    main.append(roundsSection(result));
  }
  main.append(settingsSection(result));
  await drawn();
  start();
}

async function run(): Promise<void> {
  try {
    await show(readResult(byId("result").textContent ?? ""));
    document.body.dataset.ready = "true";
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    byId("report").prepend(h("p", { class: "failure", role: "alert" }, `This report cannot be shown: ${message}. Create it again with “taut report RESULT -o report.html”.`));
  }
}

void run();
