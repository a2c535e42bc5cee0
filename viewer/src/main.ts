// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { linkCharts } from "./charts";
import { comparisonSection, frameSection, listsSection, paperSection, settingsSection } from "./details";
import { byId, h } from "./dom";
import { type Model, modelOfIdentification, modelOfStudy } from "./model";
import { netSection } from "./net_section";
import { readResult, type Result } from "./result";
import { Selection } from "./selection";
import { summary } from "./summary";
import { tablesSection } from "./tables";

function modelOf(result: Result): Model | null {
  if (result.format === "taut-study") return modelOfStudy(result);
  return result.format === "taut-identification" ? modelOfIdentification(result) : null;
}

/** After the page was drawn once. */
const drawn = (): Promise<void> => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

/** Puts the page together around the figures, which stand in it already; the view comes last. */
async function show(result: Result): Promise<void> {
  const main = byId("report");
  const figures = byId("figures");
  const selection = new Selection();
  const model = modelOf(result);
  let start = (): void => {};
  main.before(summary(result));
  if (model) {
    const isStudy = result.format === "taut-study";
    const net = netSection(model, selection, "identified");
    start = net.start;
    figures.before(net.element);
    linkCharts(model, selection);
    if (result.format === "taut-study") main.append(paperSection(result));
    if (result.format === "taut-identification") {
      const frame = frameSection(result);
      figures.before(listsSection(result, model, selection), ...(frame ? [frame] : []));
    }
    main.append(tablesSection(model, selection, { edge: "identified", node: isStudy ? "form_identified" : "form_predicted" }));
  } else if (result.format === "taut-comparison") {
    main.append(comparisonSection(result));
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
    byId("report").prepend(h("p", { class: "failure", role: "alert" }, `This report cannot be shown: ${message}. Make it again with “taut report RESULT -o report.html”.`));
  }
}

void run();
