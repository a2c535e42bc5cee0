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
const { addFile, epochWords, fileMade, newJob, setRole, text } = await bundled("../app/job.ts");
const { identifySettings, inFields, planSettings, wordsOf } = await bundled("../app/settings.ts");
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
  assert.deepEqual(filesOf(job), ["net-2.json none", "_10_30.csv survey", "plan-2.json net"]);
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
  assert.equal(inFields("--loads is none of the page's"), "--loads is none of the page's");
});

test("an Excel file is known by what stands in it, a damaged one is left to the program", () => {
  const job = newJob();
  const sheet = (...cells) => zipSync({ "xl/worksheets/sheet1.xml": strToU8(cells.map((cell) => `<c t="inlineStr"><is><t>${cell}</t></is></c>`).join("")) });
  addFile(job, "survey.xlsx", readFileSync(new URL("../../tests/data/surveys/excel.xlsx", import.meta.url)));
  addFile(job, "made.xlsx", sheet("number", "edge", "stroke_mm"));
  addFile(job, "cells.xlsx", sheet("edge", "tension"));
  addFile(job, "goals.xlsx", sheet("edge", "tension", "tolerance"));
  addFile(job, "cut.xlsx", sheet("edge", "tension").slice(0, 40));
  assert.deepEqual(filesOf(job), ["survey.xlsx survey", "made.xlsx turned", "cells.xlsx forces", "goals.xlsx tensions", "cut.xlsx later"]);
});

test("settings become words, further options as in a shell, commas as the program wants them", () => {
  assert.deepEqual(wordsOf(planSettings, { "--stages": "ridge:50% , valley", "further plan options": `--objective largest --check "my loads.csv"` }),
    ["--stages", "ridge:50%,valley", "--objective", "largest", "--check", "my loads.csv"]);
  assert.deepEqual(wordsOf(identifySettings, { "further identify options": "--slack 3" }), ["--slack", "3"]);
  assert.throws(() => wordsOf(planSettings, { "--target-tension": "12@ridge" }), /^Error: Target tension: 12 has no unit/);
});
