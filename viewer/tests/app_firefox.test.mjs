// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a page that works in Chromium alone. TAUT_APP names the page, TAUT_FIREFOX the browser
// (default: Debian's).

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { test } from "node:test";
import puppeteer from "puppeteer-core";

const executablePath = process.env.TAUT_FIREFOX ?? "/usr/bin/firefox-esr";
const skip = existsSync(executablePath) ? false : `no Firefox at ${executablePath}, install the package firefox-esr or set TAUT_FIREFOX`;
const app = resolve(process.env.TAUT_APP ?? new URL("../../build/app/taut.html", import.meta.url).pathname);

test("Firefox identifies, plans, shows the reports and keeps the job", { skip }, async () => {
  const browser = await puppeteer.launch({ browser: "firefox", executablePath, headless: true });
  try {
    const page = await browser.newPage();
    const errors = [];
    page.on("pageerror", (error) => errors.push(error.message));
    await page.goto(`file://${app}`);
    await page.waitForSelector("body[data-ready]", { timeout: 60_000 });
    const press = (id) => page.evaluate((id) => document.getElementById(id).click(), id);
    const ended = (id) => page.waitForFunction((id) => /done|failed/.test(document.querySelector(`#${id} .work`).dataset.state), { timeout: 120_000 }, id);
    await press("example");
    await ended("read");
    for (const [button, section] of [["do-identify", "identification"], ["do-plan", "planning"]]) {
      await press(button);
      await ended(section);
    }
    assert.match(await page.$eval("#identification .status", (status) => status.textContent), /^Done in .* Checks: passed\.$/);
    assert.match(await page.$eval("#planning .status", (status) => status.textContent), /^Done in .* \d+ turns\.$/);
    const report = await (await page.waitForSelector("#turns iframe")).contentFrame();
    await report.waitForSelector("body[data-ready]", { timeout: 60_000 });
    await report.$eval("#crews .tick", (tick) => tick.click());
    await page.waitForFunction(() => document.getElementById("made").textContent.startsWith("1 of "));
    await page.waitForFunction(() => document.getElementById("kept").textContent.startsWith("This browser keeps the job"));
    assert.deepEqual(errors, []);
  } finally {
    await browser.close();
  }
});
