// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against an app that dies, or says nothing, where memory ends or a file is too large or damaged.
// TAUT_APP names the page, TAUT_CHROMIUM the browser (default: Debian's).

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { after, before, test } from "node:test";
import { chromium } from "playwright-core";

const executablePath = process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium";
if (!existsSync(executablePath)) {
  console.log(`skipped: no Chromium at ${executablePath}, install the package chromium or set TAUT_CHROMIUM`);
  process.exit(0);
}
const app = resolve(process.env.TAUT_APP ?? new URL("../../build/app/taut.html", import.meta.url).pathname);

let browser;
let page;
before(async () => {
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
  page = await browser.newPage();
  page.on("pageerror", (error) => assert.fail(error.message));
  await page.goto(`file://${app}`);
  await page.waitForSelector("body[data-ready]", { state: "attached" });
  await page.evaluate(async () => {
    window.net = async (name) => (await window.taut.run(["example", name, "-o", "net.json"])).files;
    window.said = ({ code, out, err, files }) => ({ code, out, err, written: Object.keys(files) });
  });
});
after(() => browser?.close());

/** One line on standard error that begins as every error does, and nothing written. */
function expectError({ code, out, err, written }, expected, text) {
  assert.equal(code, expected, err);
  assert.match(err, /^taut: error: [^\n]*\n$/);
  assert.match(err, text);
  assert.equal(out, "");
  assert.deepEqual(written, []);
}

test("what is known to need more than --memory is refused before it starts", async () => {
  const outcome = await page.evaluate(async () =>
    window.said(await window.taut.run(["sample", "net.json", "-n", "1000000", "-o", "data.h5", "--memory", "1GiB"], await window.net("hilo-quarter"))));
  expectError(outcome, 2, /--memory is 1GiB, but the command needs .* for 1000000 samples/);
});

test("where memory ends, so does the run, with one line, and the next one works", async () => {
  const [ended, next] = await page.evaluate(async () => {
    const net = await window.net("hypar:100x100");
    const words = ["form", "net.json", "-o", "form.csv"];
    const ended = window.said(await window.taut.run([...words, "--memory", "40MiB"], net));
    return [ended, window.said(await window.taut.run(words, net))];
  });
  expectError(ended, 1, /not enough memory \(--memory is 40MiB\)/);
  assert.equal(next.code, 0, next.err);
  assert.deepEqual(next.written, ["form.csv"]);
});

test("files that are too large, cut off or no text give one line", async () => {
  const outcomes = await page.evaluate(async () => {
    const { "net.json": net } = await window.net("hilo-quarter");
    const inspect = async (bytes) => window.said(await window.taut.run(["inspect", "net.json"], { "net.json": bytes }));
    return [await inspect(new Uint8Array(300 << 20)), await inspect(net.slice(0, net.length / 2)), await inspect(new Uint8Array(1000).fill(0xff))];
  });
  expectError(outcomes[0], 2, /net\.json: .*256 MiB/);
  for (const outcome of outcomes.slice(1)) expectError(outcome, 2, /net\.json/);
});
