// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Measures the app beside the program, on the built-in net: node tests/app_speed.mjs APP PROGRAM
// Prints JSON: seconds until the page is ready, and medians of identifying and planning with 200 samples, in
// the page and by the program on one thread.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const [app, program] = process.argv.slice(2);
const repeats = 5;
const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
const folder = mkdtempSync(join(tmpdir(), "taut-app-"));
const native = (...words) => execFileSync(resolve(program), words, { cwd: folder, stdio: "ignore", env: { ...process.env, OPENBLAS_NUM_THREADS: "1" } });
const commands = {
  identify: ["identify", "net.json", "survey.csv", "--noise", "0.5mm", "--prior", "uniform:5mm", "--draws", "200", "-o", "result.json"],
  plan: ["plan", "net.json", "result.json", "--tension", "0.05kN..20kN", "--turn", "5mm", "--step", "1/4", "-o", "plan.json"],
};

native("example", "hilo-quarter", "-o", "net.json");
native("form", "net.json", "--prior", "uniform:5mm", "--seed", "7", "-o", "built.csv");
native("survey", "net.json", "built.csv", "--noise", "0.5mm", "--seed", "2", "-o", "survey.csv");

const browser = await chromium.launch({ executablePath: process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const ready = [];
let page;
for (let i = 0; i < repeats; ++i) {
  await page?.close();
  page = await browser.newPage();
  const start = performance.now();
  await page.goto(`file://${resolve(app)}`);
  await page.waitForSelector("body[data-ready]", { state: "attached" });
  ready.push((performance.now() - start) / 1e3);
}
const result = { ready: median(ready) };
const inputs = Object.fromEntries(["net.json", "survey.csv"].map((name) => [name, readFileSync(join(folder, name), "utf8")]));
for (const [name, words] of Object.entries(commands)) {
  const here = [];
  const there = [];
  for (let i = 0; i < repeats; ++i) {
    const start = performance.now();
    native(...words, "--threads", "1", "--quiet");
    here.push((performance.now() - start) / 1e3);
    there.push(await page.evaluate(async ([words, inputs]) => {
      const start = performance.now();
      const { files } = await window.taut.run(words, { ...inputs, ...window.kept });
      const seconds = (performance.now() - start) / 1e3;
      window.kept = { ...window.kept, ...files };
      return seconds;
    }, [words, inputs]));
  }
  result[name] = { app: median(there), program: median(here) };
}
await browser.close();
rmSync(folder, { recursive: true });
console.log(JSON.stringify(result, null, 1));
