// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards, in a real browser, against an app that needs the network, gives other numbers than the program,
// runs what stands in a file, blocks, or cannot be cancelled. TAUT_APP names the page, TAUT_PROGRAM the
// program, TAUT_CHROMIUM the browser (default: Debian's).

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { chromium } from "playwright-core";

const executablePath = process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium";
if (!existsSync(executablePath)) {
  console.log(`skipped: no Chromium at ${executablePath}, install the package chromium or set TAUT_CHROMIUM`);
  process.exit(0);
}
const app = resolve(process.env.TAUT_APP ?? new URL("../../build/app/taut.html", import.meta.url).pathname);
const program = process.env.TAUT_PROGRAM;
const folder = mkdtempSync(join(tmpdir(), "taut-app-"));
const identifyOptions = ["--noise", "0.5mm", "--prior", "uniform:5mm", "--draws", "200"];
const planOptions = ["--tension", "0.05kN..20kN", "--turn", "5mm", "--step", "1/4", "--thread", "right"];

const native = (...words) => execFileSync(program, words, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
const file = (name) => readFileSync(join(folder, name));

let browser;
before(async () => {
  native("example", "hilo-quarter", "-o", "net.json");
  native("form", "net.json", "--prior", "uniform:5mm", "--seed", "7", "-o", "built.csv");
  native("survey", "net.json", "built.csv", "--noise", "0.5mm", "--seed", "2", "-o", "survey.csv");
  native("identify", "net.json", "survey.csv", ...identifyOptions, "-o", "result.json", "--threads", "1");
  native("plan", "net.json", "result.json", ...planOptions, "-o", "plan.json", "--csv", "turns.csv", "--threads", "1");
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

async function open(options = {}, opener = browser) {
  const page = await ("newContext" in opener ? opener.newPage({ viewport: { width: 1280, height: 900 }, ...options }) : opener.newPage());
  page.setDefaultTimeout(120_000);  // a second survey takes seconds, more beside other work
  page.complaints = [];
  page.on("request", (request) => {
    if (!/^(file|data|blob|about):/.test(request.url())) page.complaints.push(`request ${request.url()}`);
  });
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !message.text().includes("GPU stall")) page.complaints.push(message.text());
  });
  page.on("pageerror", (error) => page.complaints.push(error.message));
  page.questions = [];
  page.on("dialog", (dialog) => {
    (dialog.type() === "confirm" ? page.questions : page.complaints).push(dialog.message());
    void dialog.accept();
  });
  await page.goto(`file://${app}`);
  await page.waitForSelector("body[data-ready]", { state: "attached" });
  return page;
}

/** window.taut.run() on files, and on those that it wrote before in this page; gives its texts. */
const run = (page, args, files = {}) => page.evaluate(async ([args, files]) => {
  const given = Object.entries(files).map(([name, content]) => [name, typeof content === "string" ? content : Uint8Array.from(content)]);
  window.kept = { ...window.kept, ...Object.fromEntries(given) };
  const { code, out, err, files: written } = await window.taut.run(args, window.kept);
  Object.assign(window.kept, written);
  const texts = Object.entries(written).map(([name, bytes]) => [name, name.endsWith(".h5") ? "" : new TextDecoder().decode(bytes)]);
  return { code, out, err, files: Object.fromEntries(texts) };
}, [args, Object.fromEntries(Object.entries(files).map(([name, bytes]) => [name, name.endsWith(".h5") ? [...bytes] : bytes.toString()]))]);

/** The lines of a list of turns without their order: where results differ by 1e-9 m, a sample may break a limit on the way in one of them. */
const turnsOf = (list) => list.toString().split("\n").map((line) => line.split(",").slice(4).join(",")).sort();

/** The largest difference of two lists of numbers. */
const largestDifference = (a, b) => {
  assert.equal(a.length, b.length);
  return Math.max(...a.map((value, i) => Math.abs(value - b[i])));
};

test("the command line in the page gives the program's lengths, samples and turns", async () => {
  const page = await open();
  assert.equal((await run(page, ["--version"])).out, native("--version"));
  const inputs = { "net.json": file("net.json"), "survey.csv": file("survey.csv") };
  const identified = await run(page, ["identify", "net.json", "survey.csv", ...identifyOptions, "-o", "result.json"], inputs);
  assert.equal(identified.code, 0, identified.err);
  assert.deepEqual(Object.keys(identified.files).sort(), ["result.json", "result_draws.h5"]);
  const result = JSON.parse(identified.files["result.json"]);
  const expected = JSON.parse(file("result.json"));
  for (const key of ["length_deviation", "std", "lower", "upper"]) {
    const of = ({ edges }) => edges.map((edge) => edge[key]);
    assert.ok(largestDifference(of(result), of(expected)) <= 1e-9, key);
  }
  assert.equal(result.trust.verdict, expected.trust.verdict);
  const planned = await run(page, ["plan", "net.json", "result.json", ...planOptions, "-o", "plan.json", "--csv", "turns.csv"]);
  assert.ok([0, 1].includes(planned.code), planned.err);
  const strokes = ({ turns }) => turns.toSorted((a, b) => a.edge - b.edge || a.pass - b.pass).map(({ stroke }) => stroke);
  assert.ok(largestDifference(strokes(JSON.parse(planned.files["plan.json"])), strokes(JSON.parse(file("plan.json")))) <= 1e-9);
  assert.deepEqual(turnsOf(planned.files["turns.csv"]), turnsOf(file("turns.csv")));
  // Of the very same result, in the same order.
  const same = { "result.json": file("result.json"), "result_draws.h5": file("result_draws.h5") };
  const again = await run(page, ["plan", "net.json", "result.json", ...planOptions, "-o", "plan.json", "--csv", "turns.csv"], same);
  assert.equal(again.files["turns.csv"], file("turns.csv").toString());
  assert.deepEqual(page.complaints, []);
  await page.close();
});

/** Drops files of the folder on the page. */
async function drop(page, place, names) {
  const files = names.map((name) => ({ name, bytes: [...file(name)] }));
  const data = await page.evaluateHandle((files) => {
    const transfer = new DataTransfer();
    for (const { name, bytes } of files) transfer.items.add(new File([new Uint8Array(bytes)], name.replace(/.*\//, "")));
    return transfer;
  }, files);
  await page.dispatchEvent(place, "drop", { dataTransfer: data });
}

test("errors are those of the program, in one line, and the page lives on", async () => {
  const page = await open();
  writeFileSync(join(folder, "broken.csv"), "a,b\n1,2\n");
  for (const words of [["identify", "net.json", "broken.csv"], ["identify", "net.json", "missing.csv"], ["nothing"], ["inspect", "broken.csv"]]) {
    const { status, stderr } = spawnSync(program, words, { cwd: folder, encoding: "utf8" });
    const there = await run(page, words, { "net.json": file("net.json"), "broken.csv": file("broken.csv") });
    assert.equal(there.code, status, there.err);
    assert.equal(there.err, stderr);
  }
  assert.equal((await run(page, ["--version"])).code, 0);
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("two dropped files become lengths and a list of turns, and a job that opens again", async () => {
  const page = await open({ acceptDownloads: true });
  await drop(page, "#drop", ["net.json", "survey.csv"]);
  await page.waitForSelector("#read [data-state=done]");
  assert.match(await page.textContent("#read .output"), /survey survey\.csv: \d+ free nodes/);
  await page.click("#suggest summary");
  await page.fill('[name="--cost"]', "load-cell:5 frequency:1 sag:2 target:1 load:50");
  await page.dispatchEvent("#do-suggest", "click");
  await page.waitForSelector("#suggest [data-state=done]");
  assert.match(await page.textContent("#suggest .status"), /Standard deviation of the mean tension now: [\d.]+ % of the mean tension\.$/);
  assert.match((await page.locator("#suggestions tbody tr").allTextContents()).join("|"), /^(load cell\d+[\d.]+\skN[\d.]+\skN[\d.]+\|?)+$/);
  for (const [option, value] of [["--noise", "0.5mm"], ["--prior", "uniform:5mm"], ["--draws", "200"]]) await page.fill(`[name="${option}"]`, value);
  await page.dispatchEvent("#do-identify", "click");
  await page.waitForSelector("#identification [data-state=done]");
  const lengths = page.frameLocator("#lengths iframe");
  await lengths.locator("body[data-ready]").waitFor();
  assert.match(await lengths.locator(".trust").first().textContent(), /Checks/);
  for (const [option, value] of [["--tension", "0.05kN..20kN"], ["--turn", "5mm"], ["--step", "1/4"]]) await page.fill(`[name="${option}"]`, value);
  await page.selectOption('[name="--thread"]', "right");
  await page.dispatchEvent("#do-plan", "click");
  await page.waitForSelector("#planning [data-state=done]");
  await page.frameLocator("#turns iframe").locator("body[data-ready]").waitFor();
  assert.ok(await page.frameLocator("#turns iframe").locator("#crews tbody tr").count() > 0);
  const [saved] = await Promise.all([page.waitForEvent("download"), page.click("text=Save list of turns")]);
  assert.deepEqual(turnsOf(readFileSync(await saved.path())), turnsOf(file("turns.csv")));
  const [plan] = await Promise.all([page.waitForEvent("download"), page.click("#turns >> text=Save result")]);
  await plan.saveAs(join(folder, "page_plan.json"));
  native("export", "page_plan.json", "--to", "xlsx", "-o", "turns.xlsx");
  const [list] = await Promise.all([page.waitForEvent("download"), page.click("#turns >> text=Save for Excel")]);
  assert.ok(readFileSync(await list.path()).equals(file("turns.xlsx")));
  // A file for plans alone leaves the lengths as they are.
  const { nodes, supports } = JSON.parse(file("net.json"));
  const loaded = [...nodes.keys()].find((node) => !supports.includes(node));
  writeFileSync(join(folder, "snow.csv"), `id,x,y,z\n${loaded},0,0,-10\n`);
  await drop(page, "#drop", ["snow.csv"]);
  await page.waitForFunction(() => document.querySelector("#problem").textContent.startsWith("snow.csv: not used yet."));
  await page.selectOption("#files li:last-child select", "check");
  assert.deepEqual(await page.locator("#files select").evaluateAll((all) => all.map(({ value }) => value)), ["net", "survey", "check"]);
  assert.equal(await page.locator("#lengths iframe").count(), 1);
  for (const [option, value] of [["--target-tension", "4.5kN:50%"], ["--suggest-targets", "0.5mm"], ["further plan options", "--confidence 90%"]]) await page.fill(`[name="${option}"]`, value);
  await page.dispatchEvent("#do-plan", "click");
  await page.waitForSelector("#planning [data-state=done]");
  assert.match(await page.textContent("#planning .commands"), /--check snow\.csv .*--target-tension 4\.5kN:50% --suggest-targets 0\.5mm --confidence 90%/);

  const [job] = await Promise.all([page.waitForEvent("download"), page.click("#save-job")]);
  await job.saveAs(join(folder, "job.json"));
  const again = await open();
  await again.setInputFiles("#drop-pick", join(folder, "job.json"));
  await again.frameLocator("#turns iframe").locator("body[data-ready]").waitFor();
  assert.equal(await again.inputValue('[name="--tension"]'), "0.05kN..20kN");
  assert.deepEqual([...page.complaints, ...again.complaints], []);
  await page.close();
  await again.close();
});

test("what was ticked off, and the next survey, are an epoch; a page opened again has it all", async () => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  const page = await open({}, context);
  const small = join(folder, "small");
  mkdirSync(small);
  const native = (...words) => execFileSync(program, words, { cwd: small, stdio: "ignore" });
  native("example", "hypar:5x6", "-o", "net.json");
  native("form", "net.json", "--prior", "uniform:5mm", "--seed", "7", "-o", "built.csv");
  native("survey", "net.json", "built.csv", "--noise", "0.5mm", "--seed", "2", "-o", "survey.csv");
  await drop(page, "#drop", ["small/net.json", "small/survey.csv"]);
  await page.waitForSelector("#read [data-state=done]");
  for (const [option, value] of [["--noise", "0.5mm"], ["--prior", "uniform:5mm"], ["--draws", "40"]]) await page.fill(`[name="${option}"]`, value);
  await page.dispatchEvent("#do-identify", "click");
  await page.waitForSelector("#identification [data-state=done]");
  await page.fill('[name="--turn"]', "5mm");
  await page.fill('[name="--step"]', "1/4");
  await page.dispatchEvent("#do-plan", "click");
  await page.waitForSelector("#planning [data-state=done]");
  const report = page.frameLocator("#turns iframe");
  await report.locator("body[data-ready]").waitFor();
  await report.locator(".crew .tick").first().check();
  await page.waitForFunction(() => document.querySelector("#made").textContent.startsWith("1 of "));
  await page.waitForFunction(() => document.querySelector("#kept").textContent.startsWith("This browser keeps the job"));
  await page.waitForTimeout(500);
  await page.reload();
  await page.waitForSelector("body[data-ready]", { state: "attached" });
  await page.waitForFunction(() => document.querySelector("#made").textContent.startsWith("1 of "));
  await report.locator("body[data-ready]").waitFor();
  assert.equal(await report.locator(".crew .tick").first().isChecked(), true);
  const [edge] = (await report.locator(".crew tbody tr:not(.pass) th").first().textContent()).split(" ");
  // Built again with that turn, and surveyed into a file of the same name.
  const stroke = await report.locator(".crew tbody tr:not(.pass)").first().evaluate((row) => {
    const size = Number([...row.cells].find((cell) => cell.dataset.label === "stroke [mm]").textContent);
    return (row.textContent.includes("shorten") ? -1 : 1) * size / 1e3;
  });
  writeFileSync(join(small, "made.csv"), `edge,stroke\n${edge},${stroke}\n`);
  native("form", "net.json", "--prior", "uniform:5mm", "--seed", "7", "--turned", "made.csv", "-o", "after.csv");
  native("survey", "net.json", "after.csv", "--noise", "0.5mm", "--seed", "5", "-o", "survey.csv");
  await drop(page, "#drop-next", ["small/survey.csv"]);
  await page.waitForSelector("#read [data-state=done]");
  assert.deepEqual(await page.locator("#files li code").allTextContents(), ["net.json", "survey.csv", "turned.csv", "survey-2.csv"]);
  await page.dispatchEvent("#do-identify", "click");
  await page.waitForSelector("#identification [data-state=done]");
  assert.match(await page.textContent("#identification .status"), /Checks: (passed|doubtful)\./);
  assert.match(await page.textContent("#identification .commands"), /survey\.csv --epoch survey-2\.csv:turned\.csv /);
  await page.frameLocator("#lengths iframe").locator("body[data-ready]").waitFor();
  await page.waitForFunction(() => document.querySelector("#kept").textContent.startsWith("This browser keeps the job"));
  await page.waitForTimeout(500);
  await page.close();

  const again = await open({}, context);
  assert.equal(await again.inputValue('[name="--prior"]'), "uniform:5mm");
  assert.equal(await again.locator("#files li").count(), 4);
  await again.frameLocator("#lengths iframe").locator("body[data-ready]").waitFor();
  assert.match(await again.textContent("#identification .status"), /^Checks: (passed|doubtful)\.$/);
  assert.match(await again.textContent("#made"), /^survey-2\.csv was surveyed after what turned\.csv says was turned\. /);
  await again.click("#new-job");
  assert.deepEqual(again.questions.map((question) => question.slice(0, 11)), ["The results"]);
  assert.equal(await again.locator("#files li").count(), 0);
  assert.deepEqual([...page.complaints, ...again.complaints], []);
  await context.close();
});

test("files of another program, of forces and of control points are known by what stands in them", async () => {
  const page = await open();
  native("export", "net.json", "--to", "csv", "-o", "nodes.csv");
  native("export", "net.json", "--to", "obj", "-o", "net.obj");
  writeFileSync(join(folder, "cells.csv"), "edge,tension\n1,4.5\n");
  writeFileSync(join(folder, "law.csv"), "strain,stress\n0,0\n0.01,1e9\n");
  await drop(page, "#drop", ["nodes.csv", "nodes_edges.csv", "survey.csv", "cells.csv", "law.csv"]);
  await page.waitForSelector("#read [data-state=done], #read [data-state=failed]");
  const roles = () => page.locator("#files select").evaluateAll((all) => all.map(({ selectedOptions }) => selectedOptions[0].textContent));
  assert.deepEqual(await roles(), ["net", "edges of the net", "survey", "force measurements", "tension law: strain, stress"]);
  assert.match(await page.textContent("#read .commands"), /taut import nodes\.csv --edges nodes_edges\.csv --stress-strain law\.csv -o imported\.json/);
  assert.ok(await page.isVisible('[name="--force-unit"]'));
  await page.selectOption("#files li:last-child select", "none");
  await page.waitForSelector("#read [data-state=done]");
  await page.click("#new-job");
  await drop(page, "#drop", ["net.obj", "survey.csv"]);
  assert.deepEqual(await roles(), ["net", "survey"]);
  await page.click("#new-job");
  copyFileSync(new URL("../../tests/data/surveys/excel.xlsx", import.meta.url), join(folder, "excel.xlsx"));
  native("example", "hypar:4x5", "-o", "small.json");
  await drop(page, "#drop", ["small.json", "excel.xlsx"]);
  await page.waitForSelector("#read [data-state=done]");
  const surveyLine = (text) => /^survey excel\.xlsx: .*$/m.exec(text)[0];
  assert.equal(surveyLine(await page.textContent("#read .output")), surveyLine(native("inspect", "small.json", "--survey", "excel.xlsx")));
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("a plan made anew asks before it forgets ticks; a number takes its unit; what is set later shows", async () => {
  const page = await open();
  await page.click("#example");
  await page.waitForSelector("#read [data-state=done]");
  await page.fill('[name="--draws"]', "0");
  await page.fill('[name="--tension"]', "1..8");
  await page.dispatchEvent("#do-identify", "click");
  await page.waitForSelector("#identification [data-state=done]");
  await page.dispatchEvent("#do-plan", "click");
  await page.waitForSelector("#planning [data-state=failed]");
  assert.equal(await page.textContent("#planning .status"), "Limits of tension: 1 has no unit. Write 1kN, say.");
  await page.fill('[name="--tension"]', "0.05kN..20kN");
  await page.dispatchEvent("#do-plan", "click");
  await page.waitForSelector("#planning [data-state=done]");
  await page.fill('[name="--crews"]', "2");
  assert.match(await page.textContent("#planning .status"), / Settings have changed since\.$/);
  const report = page.frameLocator("#turns iframe");
  await report.locator("body[data-ready]").waitFor();
  await report.locator(".record input").first().fill("Roof hall B");
  await report.locator(".record input").first().blur();
  await report.locator(".crew .tick").first().check();
  await page.waitForFunction(() => document.querySelector("#made").textContent.startsWith("1 of "));
  assert.equal(await page.frameLocator("#lengths iframe").locator(".record input").first().inputValue(), "Roof hall B");
  await page.dispatchEvent("#do-plan", "click");
  await page.waitForSelector("#planning [data-state=running]");
  await page.waitForSelector("#planning [data-state=done]");
  assert.match(page.questions.join(), /^1 turn ticked off, and no survey after them/);
  assert.ok((await page.locator("#files li code").allTextContents()).includes("turned.csv"));
  await report.locator("body[data-ready]").waitFor();
  assert.equal(await report.locator(".record input").first().inputValue(), "Roof hall B");
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("a broken job, and files of the wrong kind, give one line, and the page lives on", async () => {
  const page = await open();
  const files = {
    "cut.json": '{"format": "taut-job", "version": 1, "inputs": [',
    "later.json": '{"format": "taut-job", "version": 2}',
    "half.json": '{"format": "taut-job", "version": 1, "inputs": [{"name": "a", "role": "king", "content": ""}], "settings": {}, "outputs": []}',
    "base.json": '{"format": "taut-job", "version": 1, "inputs": [{"name": "a", "role": "net", "content": "%%%"}], "settings": {}, "outputs": []}',
  };
  for (const [name, expected] of [["cut.json", /no whole JSON file/], ["later.json", /version 2, expected 1/], ["half.json", /not a whole job/], ["base.json", /not in base64/]]) {
    await page.setInputFiles("#drop-pick", { name, mimeType: "application/json", buffer: Buffer.from(files[name]) });
    await page.waitForFunction(() => document.querySelector("#problem").textContent !== "");
    assert.match(await page.textContent("#problem"), expected);
  }
  await page.click("#example");
  await page.waitForSelector("#read [data-state=done]");
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("a run can be cancelled", async () => {
  const page = await open();
  await page.click("#example");
  await page.waitForSelector("#read [data-state=done]");
  await page.fill('[name="--draws"]', "5000");
  await page.dispatchEvent("#do-identify", "click");
  await page.waitForSelector("#identification [data-state=running]");
  await page.click("#identification >> text=Cancel");
  await page.waitForFunction(() => document.querySelector("#identification .status").textContent === "Cancelled.");
  await page.fill('[name="--draws"]', "0");
  await page.dispatchEvent("#do-identify", "click");
  await page.waitForSelector("#identification [data-state=done]");
  assert.deepEqual(page.complaints, []);
  await page.close();
});

test("what stands in names runs nothing", async () => {
  const page = await open();
  const name = "<img src=x onerror=alert(1)>.csv";
  writeFileSync(join(folder, "hostile.csv"), file("survey.csv"));
  await page.setInputFiles("#drop-pick", [
    { name: "net.json", mimeType: "application/json", buffer: Buffer.from(file("net.json").toString().replace(/"name": *"[^"]*"/, '"name": "<script>alert(1)</script><img src=x onerror=alert(2)>"')) },
    { name, mimeType: "text/csv", buffer: file("survey.csv") },
  ]);
  await page.waitForSelector("#read [data-state=done]");
  await page.fill('[name="--draws"]', "0");
  await page.dispatchEvent("#do-identify", "click");
  await page.waitForSelector("#identification [data-state=done]");
  await page.frameLocator("#lengths iframe").locator("body[data-ready]").waitFor();
  assert.equal(await page.locator("img").count(), 0);
  assert.deepEqual(page.complaints, []);
  await page.close();
});
