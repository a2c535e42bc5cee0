// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h } from "./dom";

/** A table that is neither sorted nor filtered, the first cell of each row its heading. */
export function plainTable(caption: string, head: (string | HTMLElement)[], rows: (string | number)[][], classes: string[] = []): HTMLElement {
  const cells = (row: (string | number)[]): HTMLElement[] =>
    row.map((text, i) => (i === 0 ? h("th", { scope: "row" }, text) : h("td", { class: classes[i] ?? "" }, text)));
  return h("div", { class: "scroll" }, h("table", { class: "plain" },
    h("caption", { class: "hidden" }, caption),
    h("thead", {}, h("tr", {}, ...head.map((text, i) => h("th", { scope: "col", class: classes[i] ?? "" }, text)))),
    h("tbody", {}, ...rows.map((row) => h("tr", {}, ...cells(row))))));
}
