// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Takes the pictures of docs/app.md from the app, on its example: node tests/app_pictures.mjs APP FOLDER

import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const [app, folder] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 1200, height: 840 } });
await page.goto(`file://${resolve(app)}`);
await page.waitForSelector("body[data-ready]", { state: "attached" });

/** A picture of a step, as soon as its work and the report in it are done. */
async function take(name, step, report) {
  await page.waitForSelector(`${step} [data-state=done]`);
  if (report) await page.frameLocator(`${report} iframe`).locator("body[data-ready]").waitFor();
  await page.locator(step).scrollIntoViewIfNeeded();
  await page.waitForTimeout(1000);  // until the net is drawn
  const { y } = await page.locator(step).boundingBox();
  await page.evaluate((top) => scrollBy(0, top), y);
  await page.waitForTimeout(500);
  const path = join(folder, `${name}.png`);
  await page.screenshot({ path });
  console.log(path);
}

await page.click("#example");
await page.waitForSelector("#read [data-state=done]");
await page.evaluate(() => scrollTo(0, 0));
await page.screenshot({ path: join(folder, "app-files.png") });
await page.click("#do-identify");
await take("app-lengths", "#identification", "#lengths");
await page.click("#do-plan");
await take("app-turns", "#planning", "#turns");
await browser.close();
