// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Takes the pictures of the documentation from the reports of a study and of a plan:
// node tests/pictures.mjs STUDY PLAN FOLDER

import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const [study, plan, folder] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});

/** One picture: what is done to the page first, and the part of it that is taken, from the top without one. */
async function take(name, { report = study, colorScheme = "light", first = async () => {}, part }) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 840 }, colorScheme });
  await page.goto(`file://${resolve(report)}`);
  await page.waitForSelector("body[data-ready]");
  await first(page);
  // What floats beside the pointer is no part of the picture.
  await page.mouse.move(0, 0);
  await page.waitForTimeout(500);
  const path = join(folder, `${name}.png`);
  if (part) {
    await page.locator(part).screenshot({ path });
  } else {
    const net = await page.locator("#net").boundingBox();
    await page.screenshot({ path, fullPage: true, clip: { x: 0, y: 0, width: 1200, height: net.y + net.height + 18 } });
  }
  await page.close();
  console.log(path);
}

await take("report", {});
await take("report-displacement", {
  colorScheme: "dark", part: "#net",
  first: async (page) => {
    await page.selectOption("#colour-by", "form_nominal");
    await page.selectOption("#displacement", "0");
  },
});
await take("report-top", {
  part: "#net",
  first: async (page) => {
    await page.selectOption("#colour-by", "tension");
    await page.click("[data-view=top]");
    await page.click("#tables tr[data-row] >> nth=0");
  },
});
await take("plan", { report: plan, part: "#net" });
await take("error-ellipses", {
  report: plan, part: "#net",
  first: async (page) => {
    await page.click("[data-view=top]");
    await page.check("#ellipses");
  },
});
await browser.close();
