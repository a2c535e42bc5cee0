// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against files that the app takes for something else, turns that count twice or not at all, and names
// that a list of turns changes.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { strToU8, zipSync } from "fflate";

async function bundled(entry) {
  const { outputFiles } = await build({ entryPoints: [fileURLToPath(new URL(entry, import.meta.url))], bundle: true, write: false, format: "esm" });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);
}
const { addFile, epochWords, fileMade, jobText, newJob, readJob, setRole, text } = await bundled("../app/job.ts");
const { inFields, planSettings, readingWords, wordsOf } = await bundled("../app/settings.ts");
const { numberOf, turnedCsv } = await bundled("../src/as_made.ts");

const bytes = (content) => new TextEncoder().encode(content);
const net = bytes('{"format": "taut-net"}');
const survey = bytes("id,x,y,z\n1,0,0,0\n");
const turned = bytes("edge,stroke\n7,0.001\n");
const plan = { turns: [{ edge_id: "7", stroke: 0.004 }, { edge_id: "8", stroke: -0.002 }, { edge_id: "7", stroke: 0.001 }] };

/** A job with a plan, of which two turns are ticked off. */
function planned() {
  const job = newJob();
  addFile(job, "net.json", net);
  addFile(job, "survey.csv", survey);
  job.outputs["plan.json"] = bytes(JSON.stringify(plan));
  job.notes.strokes = [0.004, null, 0.0005];
  return job;
}
const filesOf = ({ inputs }) => [...inputs].map(([name, { role }]) => `${name} ${role}`);

test("the next survey comes after what was ticked off, which counts once", () => {
  const job = planned();
  addFile(job, "survey.csv", survey);
  addFile(job, "third.csv", survey);
  assert.deepEqual(filesOf(job), ["net.json net", "survey.csv survey", "turned.csv turned", "survey-2.csv later", "third.csv later"]);
  assert.equal(text(job.inputs.get("turned.csv").bytes), "edge,stroke\r\n7,0.0045000000000000005\r\n");
  assert.deepEqual(epochWords(job), ["--epoch", "survey-2.csv:turned.csv", "--epoch", "third.csv"]);
  assert.equal(job.notes.strokes, undefined);
});

test("a file of what was turned goes before ticks, and a survey after it is a later one", () => {
  const job = planned();
  addFile(job, "made.csv", turned);
  job.outputs = {};
  addFile(job, "second.csv", survey);
  assert.deepEqual(epochWords(job), ["--epoch", "second.csv:made.csv"]);
  addFile(job, "list.csv", bytes("number,edge,stroke_mm\n1,7,2\n"));
  assert.throws(() => epochWords(job), /^Error: list\.csv is what was turned before a later survey, which is missing/);
});

test("a role that is set by hand takes the ticks, and ticks that a change forgets stay as a file", () => {
  const job = planned();
  addFile(job, "targets.csv", survey);
  setRole(job, "targets.csv", "later");
  assert.deepEqual(epochWords(job), ["--epoch", "targets.csv:turned.csv"]);
  const other = planned();
  fileMade(other, "none");
  assert.deepEqual(filesOf(other), ["net.json net", "survey.csv survey", "turned.csv none"]);
  fileMade(other, "none");
  assert.equal(other.inputs.size, 3);
});

test("names that the program writes, or that its options would split, are others; results are no nets", () => {
  const job = newJob();
  addFile(job, "net.json", bytes('{"vertices": []}'));
  addFile(job, "-10:30.csv", survey);
  addFile(job, "plan.json", net);
  assert.deepEqual(filesOf(job), ["net.json none", "_10_30.csv survey", "plan-2.json net"]);
  assert.throws(() => addFile(job, "result.json", bytes('{"format": "taut-identification"}')), /^Error: result\.json is a taut-identification file, expected a net, a survey or a job/);
});

test("a list of turns has names as the program reads them", () => {
  const names = ["#1", "a,b", "=x", "'=x", "c d", 'say "e"', "-5"];
  const turns = names.map((edge_id) => ({ edge_id, stroke: 0.001 }));
  assert.deepEqual(turnedCsv({ turns }, turns.map(({ stroke }) => stroke)).split("\r\n").slice(1, -1),
    ['"#1",0.001', '"a,b",0.001', "'=x,0.001", "''=x,0.001", '"c d",0.001', '"say ""e""",0.001', "-5,0.001"]);
  assert.equal(turnedCsv({ turns }, []), null);
});

test("turns are read as crews write them", () => {
  for (const [written, value] of [["1 3/4", 1.75], ["1¾", 1.75], ["¾", 0.75], ["1,5", 1.5], ["+2", 2], ["−1 ¼", -1.25], [".5", 0.5], ["1/3", 1 / 3]]) {
    assert.ok(Math.abs(numberOf(written) - value) < 1e-12, `${written}: ${numberOf(written)}`);
  }
  for (const written of ["", "x", "1-1/2", "1/0x", "1 2", "--1", "1/2/3"]) assert.ok(Number.isNaN(numberOf(written)), written);
  assert.ok(!Number.isFinite(numberOf("1/0")));
});

test("messages of the program name the fields of the page", () => {
  assert.equal(inFields("--step is 3, expected with --turn"), "“Smallest part of a turn” is 3, expected with “Change of length by one turn”");
  assert.equal(inFields("--solver is none of the page's"), "--solver is none of the page's");
});

test("an Excel file is known by what stands in it, a damaged one is left to the program", () => {
  const job = newJob();
  const cells = (row) => row.map((cell) => (typeof cell === "number" ? `<c r="A1"><v>${cell}</v></c>` : `<c t="inlineStr"><is><t>${cell}</t></is></c>`)).join("");
  const excel = (...rows) => zipSync({ "xl/worksheets/sheet1.xml": strToU8(`<sheetData>${rows.map((row) => `<row>${cells(row)}</row>`).join("")}</sheetData>`) });
  const shared = zipSync({
    "xl/worksheets/sheet1.xml": strToU8('<row r="1"><c r="A1" t="s"><v>1</v></c><c r="B1" t="s"><v>0</v></c></row>'),
    "xl/sharedStrings.xml": strToU8("<sst><si><t>tension</t></si><si><r><t>ed</t></r><r><t>ge</t></r></si></sst>"),
  });
  addFile(job, "survey.xlsx", readFileSync(new URL("../../tests/data/surveys/excel.xlsx", import.meta.url)));
  addFile(job, "made.xlsx", excel(["number", "edge", "stroke_mm"], [1, "7", 2]));
  addFile(job, "nodes.xlsx", excel(["id", "x", "y", "z", "is_free"], ["a", 1, 2, 3, 1]));
  addFile(job, "edges.xlsx", excel(["id", "from", "to", "l0", "EA"], ["e", "a", "b", 2, 1e5]));
  addFile(job, "cells.xlsx", shared);
  addFile(job, "goals.xlsx", excel(["edge", "tension", "tolerance"], ["7", 1, 2]));
  addFile(job, "list.xlsx", excel(["edge"], ["7"], ["8"]));
  assert.deepEqual(filesOf(job), ["survey.xlsx survey", "made.xlsx turned", "nodes.xlsx net", "edges.xlsx edges", "cells.xlsx forces", "goals.xlsx tensions", "list.xlsx none"]);
  addFile(job, "cut.xlsx", excel(["edge", "tension"]).slice(0, 40));
  assert.match(filesOf(job).at(-1), /^cut\.xlsx (survey|later)$/);
  for (const tag of ["<row ", "<c ", "<", "<row></row>"]) {  // hours, where each is looked for up to the end
    addFile(job, "hostile.xlsx", zipSync({ "xl/worksheets/sheet1.xml": strToU8(tag.repeat(2 ** 20)) }));
  }
});

test("a file that takes another role gives back what its arrival took", () => {
  const job = newJob();
  addFile(job, "survey.csv", survey);
  addFile(job, "snow.csv", survey);
  assert.deepEqual(filesOf(job), ["survey.csv none", "snow.csv survey"]);
  setRole(job, "snow.csv", "check");
  assert.deepEqual(filesOf(job), ["survey.csv survey", "snow.csv check"]);
  addFile(job, "wind.csv", survey);
  addFile(job, "third.csv", survey);
  setRole(job, "wind.csv", "check");  // whose place another has taken since
  assert.deepEqual(filesOf(job), ["survey.csv none", "snow.csv check", "wind.csv check", "third.csv survey"]);
  setRole(job, "survey.csv", "survey");
  setRole(job, "third.csv", "target");
  setRole(job, "survey.csv", "none");
  assert.deepEqual(filesOf(job), ["survey.csv none", "snow.csv check", "wind.csv check", "third.csv target"]);
  const later = planned();
  addFile(later, "snow.csv", survey);
  setRole(later, "snow.csv", "check");
  assert.deepEqual(filesOf(later), ["net.json net", "survey.csv survey", "turned.csv none", "snow.csv check"]);
  assert.deepEqual(epochWords(later), []);
});

test("beside lengths a table of points waits for its role, but for the same survey again and the next one", () => {
  const job = newJob();
  addFile(job, "survey.csv", survey);
  job.outputs["result.json"] = bytes("{}");
  addFile(job, "snow.csv", survey);
  addFile(job, "survey.csv", survey);
  assert.deepEqual(filesOf(job), ["snow.csv none", "survey.csv survey"]);
  addFile(job, "second.csv", survey, true);
  assert.equal(filesOf(job).at(-1), "second.csv later");
});

test("settings become words, further options as in a shell, commas as the program wants them", () => {
  const words = (line) => wordsOf(planSettings, { "further plan options": line });
  assert.deepEqual(wordsOf(planSettings, { "--stages": "ridge:50% , valley" }), ["--stages", "ridge:50%,valley"]);
  assert.deepEqual(words(`--objective largest --check "snow, 2nd's.csv"`), ["--objective", "largest", "--check", "snow, 2nd's.csv"]);
  assert.throws(() => words('--check "my loads.csv'), /^Error: Further options: cannot be split into words from "my loads\.csv on/);
  assert.deepEqual(wordsOf(planSettings, { "--tension": "1kN..9kN@a 2kN..3kN@b" }), ["--tension", "1kN..9kN@a", "--tension", "2kN..3kN@b"]);
  assert.throws(() => wordsOf(planSettings, { "--target-tension": "12kN:5%@ridge 14@valley" }), /^Error: Target tension: 14 has no unit/);
  assert.deepEqual(readingWords(["--columns", "id,x,y,z", "--slack", "s.csv", "--match=name", "--names", "n.csv"]), ["--columns", "id,x,y,z", "--match=name"]);
});

test("what was turned counts before the last survey, wherever its file stands, and twice not at all", () => {
  const job = newJob();
  addFile(job, "net.json", net);
  addFile(job, "survey.csv", survey);
  for (const [name, role] of [["second.csv", "later"], ["made.csv", "turned"]]) {
    job.inputs.set(name, { role: "none", bytes: survey });
    setRole(job, name, role);
  }
  assert.deepEqual(epochWords(job), ["--epoch", "second.csv:made.csv"]);
  job.inputs = new Map([["again.csv", { role: "turned", bytes: turned }], ["made.csv", job.inputs.get("made.csv")], ["second.csv", job.inputs.get("second.csv")]]);
  assert.throws(() => epochWords(job), /again\.csv and made\.csv both are what was turned/);
});

test("a saved job comes back, with a net of its own beside an imported one", () => {
  const job = planned();
  addFile(job, "other.csv", bytes("id,x,y,z,is_free\n"));
  job.outputs["imported.json"] = net;
  job.madeWith = { "result.json": "[]" };
  const back = readJob("taut-job.json", bytes(jobText(job)));
  assert.deepEqual(filesOf(back), filesOf(job));
  assert.deepEqual(back.madeWith, job.madeWith);
  assert.throws(() => addFile(newJob(), "cut.json", bytes('{"format": "taut-jo')), /cut\.json is no whole JSON file/);
});
