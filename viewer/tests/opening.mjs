// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Measures how fast reports open and turn, drawn by software: node tests/opening.mjs REPORT ...
// Prints a JSON array, for each report seconds from opening to interactive, those of them in which the
// browser gets ready to draw in three dimensions, and milliseconds of a frame while the net is
// orbited. All are medians.

import { basename, resolve } from "node:path";
import { statSync } from "node:fs";
import { chromium } from "playwright-core";

const openings = 5;
const frames = 20;

const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Takes the time of the page's first WebGL context. */
function watchContexts() {
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (...parameters) {
    const start = performance.now();
    const context = getContext.apply(this, parameters);
    if (parameters[0].startsWith("webgl")) window.contextSeconds ??= (performance.now() - start) / 1e3;
    return context;
  };
}

/** A browser for each opening: what is left of a page that was closed would count, too. */
const launch = () => chromium.launch({
  executablePath: process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});

const results = [];
for (const report of process.argv.slice(2)) {
  const seconds = [];
  const contexts = [];
  const milliseconds = [];
  for (let i = 0; i < openings; ++i) {
    const browser = await launch();
    const page = await browser.newPage({ viewport: { width: 1200, height: 840 } });
    await page.addInitScript(watchContexts);
    const start = performance.now();
    await page.goto(`file://${resolve(report)}`);
    await page.waitForSelector("body[data-ready]");
    seconds.push((performance.now() - start) / 1e3);
    contexts.push(await page.evaluate(() => window.contextSeconds));
    const view = await page.locator("#net canvas").first().boundingBox();
    const [x, y] = [view.x + 0.5 * view.width, view.y + 0.5 * view.height];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let k = 1; k <= frames; ++k) {
      const before = performance.now();
      await page.mouse.move(x + 4 * k, y + k);
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      milliseconds.push((performance.now() - before) / 2);
    }
    await page.mouse.up();
    await browser.close();
  }
  results.push({
    report: basename(report),
    mebibytes: statSync(report).size / 2 ** 20,
    seconds: median(seconds),
    context_seconds: median(contexts),
    frame_milliseconds: median(milliseconds),
  });
}
console.log(JSON.stringify(results));
