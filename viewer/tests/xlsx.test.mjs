// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards, in a real browser, against an Excel file that the app reads otherwise than the program does, or
// that hangs it. TAUT_CHROMIUM names the browser (default: Debian's).

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { strToU8, zipSync } from "fflate";
import { chromium } from "playwright-core";

const executablePath = process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium";
if (!existsSync(executablePath)) {
  console.log(`skipped: no Chromium at ${executablePath}, install the package chromium or set TAUT_CHROMIUM`);
  process.exit(0);
}
const data = (name) => readFileSync(new URL(`../../tests/data/surveys/${name}`, import.meta.url));

let browser;
let page;
before(async () => {
  const { outputFiles } = await build({
    entryPoints: [fileURLToPath(new URL("../app/xlsx.ts", import.meta.url))], bundle: true, write: false, format: "iife", globalName: "excel",
  });
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
  page = await browser.newPage();
  await page.addScriptTag({ content: outputFiles[0].text });
});
after(() => browser?.close());

/** What the app makes of a file, or what it says. */
const read = (bytes) => page.evaluate((numbers) => {
  try {
    return new TextDecoder().decode(window.excel.withoutExcel("a.xlsx", Uint8Array.from(numbers)));
  } catch (error) {
    return `${error.message}`;
  }
}, [...bytes]);

const type = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
const relations = (...all) => `<Relationships>${all.map(([kind, target], k) => `<Relationship Id="r${k}" Type="${type}/${kind}" Target="${target}"/>`).join("")}</Relationships>`;

/** An Excel file of sheets by their XML. */
function excel(sheets, parts = {}) {
  const names = Object.keys(sheets);
  return zipSync(Object.fromEntries(Object.entries({
    "_rels/.rels": relations(["officeDocument", "/xl/workbook.xml"]),
    "xl/_rels/workbook.xml.rels": relations(...names.map((_, k) => ["worksheet", `worksheets/${k}.xml`]), ["sharedStrings", "sharedStrings.xml"]),
    "xl/workbook.xml": `<workbook xmlns:r="${type}"><sheets>${names.map((name, k) => `<sheet name="${name}" r:id="r${k}"/>`).join("")}</sheets></workbook>`,
    "xl/sharedStrings.xml": "<sst><si><t>P1</t></si></sst>",
    ...Object.fromEntries(Object.values(sheets).map((xml, k) => [`xl/worksheets/${k}.xml`, `<worksheet>${xml}</worksheet>`])),
    ...parts,
  }).map(([name, text]) => [name, strToU8(text)])));
}
const rows = (...all) => `<sheetData>${all.join("")}</sheetData>`;
const point = '<row r="2"><c r="A2" t="s"><v>0</v></c><c r="B2"><v>1</v></c><c r="C2"><v>2.5</v></c><c r="D2"><v>0.1</v></c></row>';

test("an Excel file is read as the program reads it, and other files as they are", async () => {
  assert.equal(await read(data("excel.xlsx")), data("excel.txt").toString());
  assert.equal(await read(data("own.csv")), data("own.csv").toString());
  assert.equal(await read(excel({ one: rows(point) })), "\nP1,1,2.5,0.1\n");
});

test("an Excel file that cannot be read gives one line", async () => {
  const whole = excel({ one: rows(point) });
  const cases = [
    [whole.slice(0, -30), "a.xlsx: is a ZIP archive, as xlsx files are, that is damaged or encrypted"],
    [zipSync({ "content.xml": strToU8("<office/>") }), "a.xlsx: is a ZIP archive, but no Excel file"],
    [excel({ one: rows() }), "a.xlsx: is an Excel file whose sheets are empty"],
    [excel({ one: rows(point), two: rows(point) }), "a.xlsx: holds tables in the sheets 'one', 'two'"],
    [excel({ one: rows('<row r="7"><c r="A7" t="e"><v>#REF!</v></c></row>') }), "a.xlsx:7: cell A7 holds the error '#REF!'"],
    [excel({ one: rows('<row r="7"><c r="A7"><f>B1</f></c></row>') }), "a.xlsx:7: cell A7 holds a formula that was never computed"],
    [excel({ one: rows('<row r="7"><c r="A7" t="s"><v>9</v></c></row>') }), "a.xlsx:7: cell A7 names the shared text '9', of which there are 1"],
    [excel({ one: `${rows(point)}<mergeCells><mergeCell ref="A1:A2"/></mergeCells>` }), "a.xlsx:1: begins the merged cells A1:A2"],
    [excel({ one: rows(point) }, { "xl/workbook.xml": '<!DOCTYPE w [<!ENTITY a "a">]><workbook/>' }), "a.xlsx: its part xl/workbook.xml is no XML of Excel"],
    [excel({ one: rows(point) }, { "xl/worksheets/other.xml": " ".repeat(33 * 2 ** 20) }), "a.xlsx: is larger than 32 MiB when unpacked"],
    [Uint8Array.of(0xd0, 0xcf, 0x11, 0xe0), "a.xlsx is an old Office file"],
  ];
  for (const [bytes, message] of cases) assert.ok((await read(bytes)).startsWith(message), `${await read(bytes)}\n${message}`);
});
