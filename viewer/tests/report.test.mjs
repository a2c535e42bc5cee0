// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards, in a real browser, against a report that needs the network, shows other numbers than its
// result's, loses a selection on the way, runs what stands in a name, or is empty.
// TAUT_PROGRAM names the program; TAUT_CHROMIUM the browser (default: Debian's).

import assert from "node:assert/strict";
import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { chromium } from "playwright-core";
import { folder, makeReports, refusalOf, report as reportOf, write } from "./results.mjs";

const executablePath = process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium";
if (!existsSync(executablePath)) {
  console.log(`skipped: no Chromium at ${executablePath}, install the package chromium or set TAUT_CHROMIUM`);
  process.exit(0);
}

let browser;
let browserWithoutView;
let reports;
/** Pages that stay open, as opening one takes most of the time of its tests. */
const pages = new Map();

before(async () => {
  reports = makeReports();
  // Without a graphics card Chromium draws in software only by a flag.
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
  browserWithoutView = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu", "--disable-3d-apis"] });
});
after(async () => {
  await browser?.close();
  await browserWithoutView?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Opens a report; its page keeps what it asks for and complains about. */
async function open(path, options = {}, opener = browser) {
  const hasView = (opener.browser?.() ?? opener) === browser;
  const page = await ("newContext" in opener ? opener.newPage({ viewport: { width: 1280, height: 900 }, ...options }) : opener.newPage());
  page.complaints = [];
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) page.complaints.push(`request ${request.url()}`);
  });
  page.on("console", (message) => {
    // Reading pixels back is slow, says the driver; only tests and print do. And what is switched off is missing.
    const isExpected = message.text().includes("GPU stall") || (!hasView && message.text().includes("WebGL"));
    if (["error", "warning"].includes(message.type()) && !isExpected) page.complaints.push(message.text());
  });
  page.on("pageerror", (error) => page.complaints.push(error.message));
  page.on("dialog", (dialog) => page.complaints.push(`dialog ${dialog.message()}`));
  await page.goto(`file://${path}`);
  await page.waitForSelector("body[data-ready]");
  return page;
}

/** Runs checks on the page of a report, which is shared by tests, as it was opened but for what they clicked. */
async function on(name, checks, opener = browserWithoutView) {
  const key = `${name} ${opener === browser}`;
  if (!pages.has(key)) pages.set(key, await open(reports[name].page, {}, opener));
  const page = pages.get(key);
  await page.emulateMedia({ media: null, colorScheme: null });
  await checks(page, reports[name].result);
  assert.deepEqual(page.complaints, []);
}

/** The same with the view of the net, which takes twice the time. */
const onView = (name, checks) => on(name, checks, browser);

/** The picture of the view. */
async function pixels(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.$eval(".canvas canvas:not(.labels)", (canvas) => canvas.toDataURL());
}

const inspected = (page) => page.textContent(".inspector h3");
const inspectedValue = (page, name) => page.$eval(".inspector dl", (list, name) =>
  [...list.querySelectorAll("dt")].find((dt) => dt.textContent === name)?.nextElementSibling.textContent, name);

const plainNumber = (text) => Number(text.replaceAll("−", "-").replace(/[^\d.e-]/g, ""));

/** That a number on the page is a value to the three digits that are shown. */
function assertShown(text, value, what) {
  assert.ok(Math.abs(plainNumber(text) - value) <= 0.006 * Math.abs(value), `${what ?? ""}: ${text} for ${value}`);
}

const rootMeanSquare = (values) => Math.sqrt(values.reduce((sum, v) => sum + v * v, 0) / values.length);
const millimetresOf = ({ dx, dy, dz }) => 1e3 * Math.hypot(dx, dy, dz);
const figureNames = (page) => page.locator("#figures [data-figure]").evaluateAll((all) => all.map((figure) => figure.dataset.figure));
const cells = (page, rows) => page.$$eval(rows, (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));

/** What a click on a button saves, as rows of a CSV file without quotes in it. */
async function saved(page, button) {
  const [file] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
  return readFileSync(await file.path(), "utf8").trim().split("\r\n").map((line) => line.split(",").map((cell) => cell.replace(/^"(.*)"$/, "$1")));
}

/** Each chart is saved as an SVG that stands alone, on white, from the dark page too. */
async function checkSavedCharts(page, name) {
  await page.emulateMedia({ colorScheme: "dark" });
  const files = await page.evaluate(() => {
    const [create, click] = [URL.createObjectURL, HTMLAnchorElement.prototype.click];
    const blobs = [];
    const names = [];
    URL.createObjectURL = (blob) => create.call(URL, (blobs.push(blob), blob));
    HTMLAnchorElement.prototype.click = function () { names.push(this.download); };
    for (const button of document.querySelectorAll("#figures [data-figure] .chart-tools button:last-child")) button.click();
    [URL.createObjectURL, HTMLAnchorElement.prototype.click] = [create, click];
    const errorOf = (text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror")?.textContent ?? "";
    return Promise.all(blobs.map(async (blob, i) => [names[i], await blob.text(), errorOf(await blob.text())]));
  });
  assert.deepEqual(files.map(([file]) => file), (await figureNames(page)).map((figure) => `${figure}.svg`));
  for (const [file, text, error] of files) {
    assert.match(text, /<svg [^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
    assert.doesNotMatch(text, /var\(|currentColor|NaN|undefined|<script|href|url\((?!#)/);
    assert.equal(error, "", `${name} ${file}`);
    assert.ok(text.includes('fill="white"') && text.includes("<text"), `${name} ${file}`);
  }
}

/** Every control and drawing has a name for a screen reader, and headings go down by one. */
async function checkNames(page) {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, select, input, svg, canvas, section, [role=region]")]
      .filter((e) => !(e.ariaHidden || e.ariaLabel || e.labels?.length || e.textContent.trim() && e.matches("button") || document.getElementById(e.getAttribute("aria-labelledby"))))
      .map((e) => e.outerHTML.slice(0, 80)));
  assert.deepEqual(nameless, []);
  const levels = await page.$$eval("h1, h2, h3", (heads) => heads.map((h) => Number(h.tagName[1])));
  levels.forEach((level, i) => assert.ok(i === 0 ? level === 1 : level <= levels[i - 1] + 1, `heading ${i}`));
}

test("every report opens from disk without a request or a complaint, has names for all it shows, and saves its charts", async () => {
  const viewed = ["study", "troubled", "plan"];
  for (const name of Object.keys(reports)) {
    await on(name, async (page, result) => {
      assert.ok((await page.textContent("h1")).includes(result.net.name));
      assert.equal(await page.locator(".sentences li").count(), 3);
      assert.ok((await page.locator("#figures svg").count()) > 0);
      assert.equal(await page.locator(".failure[role=alert]").count(), 0);
      assert.doesNotMatch(await page.innerText("body"), /NaN|undefined|Infinity/);
      await checkNames(page);
      await checkSavedCharts(page, name);
    }, viewed.includes(name) ? browser : browserWithoutView);
  }
});

test("a click in the view selects an edge or a node, in charts and table too", () => onView("study", async (page, { cable_net, sample }) => {
  const clickBetween = async (...nodes) => {
    const [x, y] = await page.$eval(".canvas", ({ netView }, nodes) => {
      const places = nodes.map((node) => netView.placeOf(node));
      return [0, 1].map((k) => places.reduce((sum, place) => sum + place[k] / places.length, 0));
    }, nodes);
    await page.click(".canvas canvas:not(.labels)", { position: { x, y } });
  };
  const edge = cable_net.edges.findIndex((_, e) => !cable_net.adjustable.includes(e));
  await clickBetween(...cable_net.edges[edge]);
  assert.equal(await inspected(page), `Edge ${edge}`);
  assert.equal(await page.locator("#figures .mark.selected").count(), 6);
  assert.equal(await page.textContent("#tables tr[aria-selected=true] td"), String(edge));
  const node = cable_net.nodes.findIndex((_, i) => !cable_net.supports.includes(i));
  await clickBetween(node);
  assert.equal(await inspected(page), `Free node ${node}`);
  const shown = plainNumber(await inspectedValue(page, "form deviation, true − identified"));
  assert.ok(Math.abs(shown - 1e3 * sample.form_error.identified[0]) < 1e-4);
}));

test("every colouring, viewpoint and displacement draws another picture", () => onView("study", async (page) => {
  const seen = new Map();
  for (const key of await page.$$eval("#colour-by option", (options) => options.map((o) => o.value))) {
    await page.selectOption("#colour-by", key);
    const legend = await page.getAttribute(".legend", "aria-label");
    // Where all edges are of one axial stiffness, strain is tension in another unit.
    const picture = (key.endsWith("strain") ? legend : "") + (await pixels(page));
    assert.ok(!seen.has(picture), `${key} looks like ${seen.get(picture)}`);
    seen.set(picture, key);
    assert.ok(legend.length > 10);
  }
  await page.selectOption("#colour-by", "identified");
  const perspective = await pixels(page);
  await page.click("[data-view=top]");
  const top = await pixels(page);
  assert.notEqual(top, perspective);
  await page.selectOption("#displacement", "0");
  const moved = await pixels(page);
  assert.notEqual(moved, top);
  await page.fill("#exaggeration", "90");
  assert.notEqual(await pixels(page), moved);
  assert.match(await page.textContent(".slider output"), /^× \d/);
}));

test("keys, a drag and the wheel move the view, and the arrows go through the table", () => onView("study", async (page) => {
  await page.focus("#tables .rows");
  await page.keyboard.press("ArrowDown");
  const first = await inspected(page);
  await page.keyboard.press("ArrowDown");
  assert.notEqual(await inspected(page), first);
  await page.focus(".canvas canvas:not(.labels)");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".inspector h3").count(), 0);
  await page.locator(".canvas canvas:not(.labels)").scrollIntoViewIfNeeded();
  const box = await page.locator(".canvas canvas:not(.labels)").boundingBox();
  const [x, y] = [box.x + 200, box.y + 200];
  let before = await pixels(page);
  for (const [name, move] of Object.entries({
    arrow: () => page.keyboard.press("ArrowLeft"),
    plus: () => page.keyboard.press("+"),
    async drag() {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + 100, y + 30, { steps: 4 });
      await page.mouse.up();
    },
    wheel: () => page.mouse.wheel(0, -300),
  })) {
    await move();
    const now = await pixels(page);
    assert.notEqual(now, before, name);
    before = now;
  }
  assert.equal(await page.locator(".inspector h3").count(), 0, "the end of a drag is no click");
}));

test("light and dark differ, in page and view", () => onView("study", async (page) => {
  const looks = [];
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    looks.push([await page.evaluate(() => getComputedStyle(document.body).backgroundColor), await pixels(page)]);
  }
  for (const k of [0, 1]) assert.notEqual(looks[0][k], looks[1][k]);
}));

test("it prints on A4, black on white, with the view as a picture", () => onView("study", async (page, { cable_net }) => {
  await page.emulateMedia({ colorScheme: "dark" });
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
  assert.match(pdf, /\/MediaBox \[0 0 59[45][.\d]* 84[12]/);
  const count = pdf.match(/\/Type \/Page\b/g).length;
  assert.ok(count >= 2 && count <= 9, `${count} pages`);
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  assert.equal(await page.locator(".canvas canvas:not(.labels)").isVisible(), false);
  assert.equal(await page.locator(".canvas img").isVisible(), true);
  assert.equal(await page.locator("#tables .rows >> nth=0 >> tr[data-row]").count(), cable_net.edges.length);
  assert.equal(await page.locator("#licences").isVisible(), false);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
}));

/** Where edge i = index + 1 stands in a chart, by two of its tick labels, and the chart's height. */
function placeOfEdge(chart, index) {
  return chart.evaluate((drawing, index) => {
    const marks = [...drawing.querySelectorAll("[aria-label='x-axis tick label'] text")].filter((text) => text.textContent)
      .map((text) => [Number(text.textContent), Number(/translate\(([\d.]+)/.exec(text.getAttribute("transform"))[1])]);
    const [[a, atA], [b, atB]] = [marks[0], marks.at(-1)];
    const frame = drawing.getBoundingClientRect();
    const scale = frame.width / drawing.viewBox.baseVal.width;
    return [scale * (atA + ((index + 1 - a) / (b - a)) * (atB - atA)), frame.height];
  }, index);
}

test("a box drawn over a chart zooms to it, the whole comes back, and a click selects the edge that stands there", () => on("study", async (page, { cable_net }) => {
  const chart = page.locator("[data-figure=length_deviations] svg");
  const labels = () => page.locator("[data-figure=length_deviations] [aria-label='x-axis tick label'] text").allTextContents();
  const whole = await labels();
  await chart.scrollIntoViewIfNeeded();
  const [from, height] = await placeOfEdge(chart, 9);
  const [to] = await placeOfEdge(chart, 19);
  const box = await chart.boundingBox();
  await page.mouse.move(box.x + from, box.y + 0.4 * height);
  await page.mouse.down();
  await page.mouse.move(box.x + to, box.y + 0.6 * height, { steps: 4 });
  await page.mouse.up();
  const shown = (await labels()).filter(Boolean).map(Number);
  assert.ok(Math.min(...shown) >= 10 && Math.max(...shown) <= 20 && shown.length >= 5, String(shown));
  assert.equal(await page.locator("#figures .mark.selected").count(), 0);
  await page.click("[data-figure=length_deviations] button:has-text('Whole')");
  assert.deepEqual(await labels(), whole);
  await page.click("[data-figure=length_deviations] button[title='Zoom in']");
  assert.notDeepEqual(await labels(), whole);
  await chart.dblclick({ position: { x: 200, y: 100 } });
  assert.deepEqual(await labels(), whole);
  await chart.click({ position: { x: from, y: height / 2 } });
  const interior = cable_net.edges.map((_, e) => e).filter((e) => !cable_net.adjustable.includes(e));
  assert.equal(await inspected(page), `Edge ${interior[9]}`);
}));

test("the numbers on the page are the result's", () => on("study", async (page, result) => {
  const method = result.methods.gp_as_in_paper;
  const cards = await page.locator(".card .value").allTextContents();
  [1e3 * Math.sqrt(method.mse), 100 * method.mrse, 1e3 * result.form_error.nominal.mean, 1e3 * result.form_error.identified.mean, 100 * method.coverage_95]
    .forEach((value, i) => assertShown(cards[i], value, `card ${i}`));
  const rows = (await cells(page, "#paper table:last-of-type tbody tr")).slice(-4);
  rows.forEach(([key, ...shown]) => [result.paper.form_error.nominal, result.form_error.nominal, result.paper.form_error.identified, result.form_error.identified]
    .forEach((errors, i) => assertShown(shown[i], 1e3 * errors[key.toLowerCase()], key)));
  const settings = await page.textContent("#settings");
  for (const text of [result.prior, result.net.fingerprint, result.date, result.command, String(result.samples.training)]) assert.ok(settings.includes(text), text);
}));

test("only the rows that are seen exist", () => on("study", async (page) => {
  const rows = () => page.locator("#tables .rows >> nth=0 >> tr[data-row]").count();
  assert.ok((await rows()) < 60);
  const first = await page.textContent("#tables tr[data-row] td");
  await page.$eval("#tables .rows", (scroller) => (scroller.scrollTop = scroller.scrollTop > 0 ? 0 : scroller.scrollHeight));
  await page.waitForFunction((first) => document.querySelector("#tables tr[data-row] td").textContent !== first, first);
  assert.ok((await rows()) < 60);
}));

test("without WebGL all but the view is there, and it says so", () => on("study", async (page) => {
  assert.match(await page.textContent(".canvas"), /no WebGL/);
  assert.equal(await page.locator("[data-figure=net_plan]").isVisible(), true);
}));

test("the page has the licence of each package whose code is in it", () => on("study", async (page) => {
  // Which these are comes from the map of the code here, and from the metafile in the build.
  const viewer = fileURLToPath(new URL("..", import.meta.url));
  const { outputFiles } = await build({ absWorkingDir: viewer, entryPoints: ["src/main.ts"], bundle: true, write: false, outdir: "out", sourcemap: "external", sourcesContent: false });
  const { sources } = JSON.parse(outputFiles.find((file) => file.path.endsWith(".map")).text);
  const packages = new Set(sources.map((source) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(source)?.[1]).filter(Boolean));
  assert.ok(packages.has("three") && packages.has("d3-array"));
  const words = (text) => text.split(/\s+/).join(" ").trim();
  assert.equal(await page.locator("#licences pre >> nth=0").isVisible(), false);
  await page.click("#licences summary");
  const shown = words(await page.innerText("#licences"));
  for (const name of packages) {
    assert.ok(shown.includes(`${name} `), `${name} is named`);
    assert.ok(shown.includes(words(readFileSync(join(viewer, "node_modules", name, "LICENSE"), "utf8"))), `the licence of ${name}`);
  }
}));

test("the table is sorted, filtered and downloaded with all digits", () => on("plain", async (page, result) => {
  const download = () => saved(page, "#tables .csv >> nth=0");
  const [head, ...all] = await download();
  assert.equal(all.length, result.cable_net.edges.length);
  const column = head.indexOf("deviation [mm]");
  for (const edge of result.edges) {
    const row = all.find((cells) => cells[0] === String(edge.edge));
    assert.equal(Number(row[column]), 1e3 * edge.length_deviation);
    assert.ok(Math.abs(Number(row[head.indexOf("95 % from [mm]")]) - 1e3 * edge.lower) < 1e-9);
  }
  const magnitudes = all.map((cells) => cells[column]).filter(Boolean).map((text) => Math.abs(Number(text)));
  assert.deepEqual(magnitudes, [...magnitudes].sort((a, b) => b - a), "the largest first");
  await page.click("#tables th button >> nth=0");
  assert.equal((await download())[1][0], "0");
  await page.fill("#tables input >> nth=0", "adjustable");
  assert.equal((await download()).length - 1, result.cable_net.adjustable.length);
  assert.match(await page.textContent("#tables [role=status]"), /of \d+ rows/);
}));

/** Headline and caption have the same distances, over the same targets. */
async function checkDistances(page, { outliers, residuals }, apart) {
  const left = new Set(outliers.map((o) => o.node));
  const distances = residuals.filter((r) => !left.has(r.node)).map(millimetresOf);
  const caption = await page.textContent("figure:has([data-figure=residual_map]) figcaption");
  const [, rms, most] = /predicted form: ([^ ]+) mm RMS, max ([^ ]+) mm\./.exec(caption);
  assertShown(rms, rootMeanSquare(distances), caption);
  assertShown(most, Math.max(...distances), caption);
  const headline = await page.textContent(".sentences li:nth-child(2)");
  if (apart) assert.ok(headline.includes(`targets in use. ${apart}`) && caption.includes(apart), `${headline} ${caption}`);
  else assert.ok(headline.includes(`is ${rms} mm (RMS) from the surveyed one, max ${most} mm.`), headline);
}

test("troubles of a survey are listed and lead to their place", () => onView("troubled", async (page, result) => {
  const list = (i) => `#lists .list:nth-child(${i})`;
  for (const words of ["T-900", "<b>T-901</b>"]) assert.ok((await page.textContent("#lists")).includes(words), words);
  assert.deepEqual(await page.locator("#lists .count").allTextContents(), ["1", "1", "1", "2", "2"]);
  assert.equal(await page.locator("[data-figure=residual_histogram]").count(), 1);
  assert.match(await page.textContent(".sentences"), /1 slack cable.*1 cable not determined.*1 gross error.*2 nodes not surveyed/s);
  // A gross error in mm, its statistic where more is asked of it.
  const gross = page.locator(`${list(3)} .chip`);
  assert.equal(await gross.textContent(), "8 51.2 mm");
  assert.match(await gross.getAttribute("title"), /5\.25 \(excluded above 4\.50\)/);
  await gross.click();
  assert.equal(await inspected(page), "Free node 8");
  assert.equal(await inspectedValue(page, "gross error, from the place predicted by all others"), "51.200 mm");
  assert.equal(await inspectedValue(page, "test statistic of the gross error"), "5.25 (excluded above 4.50)");
  // A slack edge with its bound, and in no statistic of the deviations.
  const slack = result.edges[0].edge;
  assert.equal(await page.textContent(`${list(1)} .chip`), `${slack} ≥ 63.2 mm`);
  await page.click(`${list(1)} .chip`);
  assert.equal(await inspected(page), `Edge ${slack}`);
  assert.equal(await inspectedValue(page, "status"), "slack");
  assert.equal(await inspectedValue(page, "length deviation of a slack edge, lower bound"), "63.200 mm");
  assert.equal(await inspectedValue(page, "length deviation, identified"), undefined);
  await page.click(`${list(2)} .chip`);
  assert.equal(await inspectedValue(page, "status"), "not determined");
  const tense = result.edges.filter((e) => e.status !== "slack").map((e) => 1e3 * e.length_deviation);
  const [, longest] = /deviates most, of those that are not slack: ([^ ]+) mm/.exec(await page.textContent(".sentences li:nth-child(1)"));
  assertShown(longest, Math.max(...tense.map(Math.abs)));
  assertShown(await page.locator(".card", { hasText: "length deviation, RMS, without slack cables" }).locator(".value").textContent(), rootMeanSquare(tense));
  assert.notEqual(await page.textContent("#tables tr[data-row] td"), String(slack), "the slack edge is ranked among the largest deviations");
  assert.match(await page.textContent("[data-figure=length_intervals]"), /slack: lower bound/);
  assert.match(await page.textContent(".sentences"), /Variance factor 1\.47 \(expected 0\.80 to 1\.20\): the survey scatters more than its standard deviation/);
  await checkDistances(page, result.survey, "1 target excluded as a gross error, up to 50.0 mm away.");
}));

test("a name in a finding brings it into the view, with its label; the top view has a scale bar", () => onView("raised", async (page) => {
  const labels = (part) => page.$eval(".canvas .labels", (canvas, [x, y, width, height]) => {
    const context = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    return context.getImageData(x * canvas.width, y * canvas.height, width * canvas.width, height * canvas.height).data.some((value) => value > 0);
  }, part);
  const settled = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.click("[data-view=perspective]");
  const before = await pixels(page);
  const button = page.locator(".findings button.link").first();
  assert.equal(await button.textContent(), "8");
  await page.evaluate(() => scrollTo(0, 0));
  await button.click();
  await settled();
  assert.equal(await inspected(page), "Free node 8");
  assert.ok((await page.locator("#net").boundingBox()).y < 20, "the view is at the top of the window");
  assert.notEqual(await pixels(page), before, "the view has gone there");
  assert.ok(await labels([0.25, 0.25, 0.5, 0.5]), "its label is in the middle");
  await page.focus(".canvas canvas:not(.labels)");
  await page.keyboard.press("Escape");
  await settled();
  assert.equal(await labels([0, 0, 1, 1]), false);
  await page.selectOption("#labels", "supports");
  await settled();
  assert.ok(await labels([0, 0, 1, 1]));
  await page.selectOption("#labels", "none");
  await page.click("[data-view=top]");
  await settled();
  assert.ok(await labels([0, 0.9, 0.3, 0.1]), "a scale bar");
  await page.click("[data-view=perspective]");
}));

test("prior, variance factor, smallest errors, frame and control residuals are shown", () => on("moved", async (page, result) => {
  const top = await page.textContent("header");
  assert.equal(result.length_prior, "uniform:2mm");
  assert.match(top, /Prior: lengths deviate uniformly within ±2 mm\./);
  const { ratio, std } = result.diagnostics.noise;
  const [, factor, low, high] = /Variance factor ([\d.]+) \(expected ([\d.]+) to ([\d.]+)\): the survey scatters/.exec(top);
  [[factor, ratio], [low, 1 - 1.96 * std], [high, 1 + 1.96 * std]].forEach(([shown, value]) => assert.equal(shown, value.toFixed(2)));
  assert.match(await page.textContent("#settings"), /prior of the length deviationsuniform:2mm, exact/);
  const smallest = `turnbuckle ${Number((1e3 * result.detectable.adjustable).toPrecision(2))} mm`;
  assert.match(await page.textContent("#detectable"), /^Smallest error this survey would show/);
  assert.ok((await page.textContent("#detectable")).includes(smallest), smallest);
  const determined = result.edges.filter((e) => e.status === "determined").length;
  assert.ok(determined > 0 && top.includes(`${determined} of ${result.edges.length} interior cables are determined`));
  const assumed = await page.textContent("#assumptions");
  assert.ok(result.assumptions.length > 0 && result.assumptions.every((one) => assumed.includes(one.value)), assumed);
  await checkDistances(page, result.survey);
  const { fit, control } = result.frame;
  assert.equal(fit.count, control.length);
  assert.ok(top.includes(`into the net's frame with ${fit.count} control points`));
  const distances = control.map(millimetresOf);
  const largest = Math.max(...distances);
  const [, rms, most, id] = /residuals are ([^ ]+) mm \(RMS\), max ([^ ]+) mm \((\S+)\)/.exec(await page.textContent("#frame p"));
  assertShown(rms, 1e3 * fit.rms);
  assertShown(most, largest);
  assert.equal(id, control[distances.indexOf(largest)].id);
  const [, ...rows] = await saved(page, "#frame .csv");
  assert.equal(rows.length, fit.count);
  assert.equal(Number(rows[0][4]), largest);
}));

test("what a result does not have is said, not left empty", async () => {
  await on("plain", async (page) => {
    assert.match(await page.textContent("#lists"), /None: every cable is in tension/);
    assert.match(await page.textContent(".sentences"), /No cable is slack/);
    assert.match(await page.textContent("#settings"), /frame of the surveythe net's/);
    assert.equal(await page.locator("[data-figure=residual_histogram]").count(), 0);
  });
  await on("bare", async (page) => {
    assert.equal(await page.locator("[data-figure=residual_map]").count(), 0);
    assert.equal(await page.locator("#colour-by option[value=tension]").count(), 0);
  });
  await on("one", async (page) => assert.match(await page.textContent("#figures"), /the one validation sample/));
});

test("the findings of a result are listed with kind, ids, value, and the option that is the remedy", () => on("full_identification", async (page) => {
  assert.match(await page.innerText(".trust"), /^Checks: failed\./);
  const items = await page.locator(".findings li").allTextContents();
  assert.equal(items[0], "failed Prior of the length deviations 5: std 12.3 ± 0.40 mmoneConfounded with 7.");
  assert.equal(items[1], "doubtful Length outlier 5: 12.3 ± 0.40 mmtwoConfounded with 7.");
  // Advice that the next finding gives, too, stands there alone.
  assert.equal(items[2], "note Target 5: 12.3 ± 0.40 mmthreeConfounded with 7.Look at it. --prior uniform:8mm");
}));

test("names with markup are shown as text and run nothing", () => on("hostile", async (page, result) => {
  assert.ok((await page.textContent("h1")).includes(result.net.name));
  await page.click("#tables tr[data-row] >> nth=0");
  assert.ok((await inspected(page)).includes("<img src=x onerror"));
  assert.equal(await page.evaluate(() => window.harmed), undefined);
  assert.equal(await page.locator("img:not(.print-only)").count(), 0);
  // A cell that begins like a formula would be run by a spreadsheet.
  assert.ok((await saved(page, "#tables .csv >> nth=0"))[1][0].startsWith("'=<img"));
}));

test("a comparison shows each method and the Cramér-Rao bound", () => on("comparison", async (page, { rows }) => {
  assert.deepEqual(await figureNames(page), ["error_over_noise", "error_over_training", "error_over_hidden"]);
  assert.match(await page.textContent("#figures .legend"), /Cramér-Rao bound/);
  assert.equal(await page.locator("#tables tr[data-row]").count(), rows.length);
  const sentences = await page.textContent(".sentences");
  assert.match(sentences, /standard deviation of 0\.5 mm per coordinate, \w+ has the smallest error of a length: .* mm \(RMS\); the Cramér-Rao bound is/);
  assert.match(sentences, /95 % intervals, of surveys with noise: .*map [\d.]+/);
  const unable = await page.locator("#tables tr[data-row]", { hasText: "needs a survey of all free nodes" }).count();
  assert.equal(unable, rows.filter((r) => r.first_failure === "needs a survey of all free nodes").length);
}));

test("simulated jobs are shown in words, curves and all rounds", () => on("jobs", async (page, { strategies }) => {
  const of = (name) => strategies.find((s) => s.strategy === name).rounds;
  const mm = (metres) => `${(1e3 * metres).toPrecision(3)} mm`;
  const sentences = await page.textContent(".sentences");
  assert.ok(sentences.includes(`2 rounds of turns planned on identified lengths bring the nets from ${mm(of("identified")[0].normal_rmse)} to ${mm(of("identified")[2].normal_rmse)}`), sentences);
  for (const [name, words] of [["true lengths", "when planned on the true lengths"], ["design", "on the design lengths"], ["design, once", "on the design lengths in the first round only"]]) {
    assert.ok(sentences.includes(`${mm(of(name)[2].normal_rmse)} ${words}`), `${name}: ${sentences}`);
  }
  assert.match(sentences, /Of 4 jobs, limits are broken in (none|\d) as built; after 2 rounds in (none|\d) planned on identified lengths/);
  assert.match(sentences, /No identification or plan failed/);
  assert.deepEqual(await figureNames(page), ["control_form", "control_limits", "control_strokes"]);
  const rows = await cells(page, "#rounds tbody tr");
  assert.deepEqual(rows.map(([name, round]) => `${name} ${round}`), ["as built 0", "true lengths 1", "true lengths 2", "identified 1", "identified 2", "design 1", "design 2", "design, once 1"]);
  assert.equal(rows[4][6], (1e3 * of("identified")[2].normal_rmse).toFixed(2));
  assert.equal(rows[4][9], `${of("identified")[2].broken_trials}/4`);
  const settings = await page.textContent("#settings");
  for (const text of ["uniform:2mm", "0.2 mm", "min 0.05 kN, max 20 kN", "±15 mm"]) assert.ok(settings.includes(text), text);
  // The table of rounds fits on A4 without its margins.
  await page.setViewportSize({ width: 688, height: 1000 });
  await page.emulateMedia({ media: "print" });
  const [table, paper] = await page.$eval("#rounds table", (table) => [table.getBoundingClientRect().right, document.documentElement.clientWidth]);
  assert.ok(table <= paper, `${table} of ${paper}`);
}));

test("one job, and jobs without a plan, say so", async () => {
  await on("job", async (page) => {
    const sentences = await page.textContent(".sentences");
    assert.match(sentences, /1 round of turns planned on identified lengths brings the nets/);
    assert.doesNotMatch(sentences, /first round only|in the last/);
    assert.match(await page.textContent("#figures"), /1 job; one job does not show how much jobs differ/);
  });
  await on("failed", async (page) => {
    const sentences = await page.textContent(".sentences");
    assert.match(sentences, /No plan on identified lengths succeeded: the nets stay as built/);
    assert.match(sentences, /failed 1 of 1 time on the true lengths, 1 of 1 time on identified lengths/);
    assert.match(await page.textContent("#figures"), /4 plans of all jobs failed/);
  });
});

/** Cells of a crew's list: [number, step, cable, action, rotation, turns, mm, scale reading, tension, ""]. */
const crewRows = (page, crew) => cells(page, `[data-crew="${crew}"] tbody tr:not(.pass)`);

test("each crew's list has all its turns, in the order of work, and is printed on its own sheets", () => on("plan", async (page, { turns }) => {
  for (const crew of [1, 2]) {
    const own = turns.filter((t) => t.crew === crew);
    assert.ok(own.length > 0);
    const rows = await crewRows(page, crew);
    assert.deepEqual(rows.map((r) => r[2].replace(/ \(.*/, "")), own.map((t) => t.edge_id));
    // The drawing has the numbers of the lines, and the supports at which they are.
    const drawn = await page.locator(`[data-crew="${crew}"] .crew-drawing .number`).allTextContents();
    assert.deepEqual(drawn.flatMap((text) => text.split(", ")).map(Number).sort((a, b) => a - b), rows.map((r) => Number(r[0])));
    assert.deepEqual(own.map((t) => turns.indexOf(t) + 1), rows.map((r) => Number(r[0])));
    rows.forEach((row, i) => {
      const turn = own[i];
      assert.equal(Number(row[1]), turn.step + 1);
      assert.ok(row[3].includes(turn.stroke < 0 ? "shorten" : "lengthen"), row[3]);
      // With a left-hand thread clockwise lengthens.
      assert.equal(row[4], turn.stroke < 0 ? "↺ counterclockwise" : "↻ clockwise");
      const [, whole, part] = /^(\d*) ?([¼½¾]?)$/.exec(row[5]);
      assert.equal(5 * (Number(whole) + ({ "¼": 0.25, "½": 0.5, "¾": 0.75 }[part] ?? 0)), Math.abs(1e3 * turn.stroke).toFixed(6) * 1);
      [Math.abs(1e3 * turn.stroke), 1e3 * turn.reading_after, turn.tension_after / 1e3]
        .forEach((value, k) => assert.ok(Math.abs(plainNumber(row[6 + k]) - value) < 0.0051, `${row[6 + k]} for ${value}`));
    });
    assert.equal(await page.locator(`[data-crew="${crew}"] .tick`).count(), own.length);
  }
  await page.evaluate(() => (window.print = () => {}));
  await page.click("#crews .print");
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
  assert.equal(pdf.match(/\/Type \/Page\b/g).length, 2, "one page a crew, and nothing else");
  await page.click("#crews .print");
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator("header").isVisible(), false);
  assert.equal(await page.locator("#crews .crew tbody tr:not(.pass):visible").count(), turns.length);
  for (const crew of [1, 2]) assert.ok((await page.innerText(`[data-crew="${crew}"] thead`)).includes(`Crew ${crew} of 2`));
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
}));

test("what is turned is ticked off or entered, kept when the page is opened again, and saved for the next survey", async () => {
  const { page: path, result: { turns } } = reports.plan;
  const context = await browserWithoutView.newContext({ acceptDownloads: true });
  const page = await open(path, {}, context);
  assert.equal(await page.textContent(".made-bar [role=status]"), `0 of ${turns.length} turned`);
  assert.equal(await page.isDisabled("#save-turned"), true);
  const own = (i) => page.locator(`[data-crew="${turns[i].crew}"] tbody tr`).nth(turns.filter((t) => t.crew === turns[i].crew).indexOf(turns[i]));
  await own(0).locator(".tick").check();
  // Half a turn of 5 mm more than planned, a turn the other way round, and what is no number.
  const planned = Math.abs(turns[1].turns);
  await own(1).locator(".as-made").fill(`${planned} 1/2`.replace(/^\d+\.\d+ 1\/2$/, String(planned + 0.5)));
  await own(2).locator(".as-made").fill("−1 ¼");
  await own(3).locator(".as-made").fill("two");
  await page.locator("h1").click();
  // What is refused stays to be seen, and is no turn, whatever else is ticked.
  await own(4).locator(".tick").check();
  await own(4).locator(".tick").uncheck();
  assert.equal(await own(3).locator(".as-made").getAttribute("aria-invalid"), "true");
  assert.equal(await own(3).locator(".as-made").inputValue(), "two");
  assert.equal(await own(3).locator(".tick").isChecked(), false);
  assert.equal(await page.textContent(".made-bar [role=status]"), `3 of ${turns.length} turned`);
  await page.locator(".record input").first().fill("Roof 7");
  await page.locator("h1").click();
  await page.reload();
  await page.waitForSelector("body[data-ready]");
  assert.equal(await page.textContent(".made-bar [role=status]"), `3 of ${turns.length} turned`);
  assert.equal(await page.locator(".record input").first().inputValue(), "Roof 7");
  const [saved] = await Promise.all([page.waitForEvent("download"), page.click("#save-turned")]);
  const rows = readFileSync(await saved.path(), "utf8").trim().split("\r\n").slice(1).map((line) => line.split(","));
  const signs = turns.slice(0, 3).map(({ stroke }) => Math.sign(stroke));
  const expected = [turns[0].stroke, turns[1].stroke + 0.0025 * signs[1], -0.00625 * signs[2]];
  assert.deepEqual(rows.map(([edge]) => edge), turns.slice(0, 3).map((t) => t.edge_id));
  rows.forEach(([, stroke], i) => assert.ok(Math.abs(Number(stroke) - expected[i]) < 1e-12, `${stroke} for ${expected[i]}`));
  // The program reads it.
  await saved.saveAs(join(folder, "turned.csv"));
  assert.equal(refusalOf("form", "net.json", "--turned", "turned.csv", "-o", "turned_form.csv"), null);
  assert.deepEqual(page.complaints, []);
  await context.close();
});

test("on a phone nothing of the crews' list is cut off", async () => {
  const page = await open(reports.plan.page, { viewport: { width: 390, height: 844 } }, browserWithoutView);
  const widest = await page.$$eval("#crews .list-rows *", (all) => Math.max(...all.map((one) => one.getBoundingClientRect().right)));
  assert.ok(widest <= 390, `${widest} of 390`);
  await page.close();
});

test("the head of a plan has the checks it depends on, whether limits are kept, and how near it comes", () => on("plan", async (page, result) => {
  const top = await page.textContent("header");
  assert.ok(top.includes(`Checks of the identification: ${result.identification.verdict}.`));
  assert.ok(result.feasible && result.order.safe);
  assert.match(await page.textContent("#verdict"), /All limits are kept, with the required probability of 95 %/);
  assert.match(top, /No step breaks a limit that was kept before the work, with a probability of [\d.]+ % \(required: 95 %\)/);
  const [, probability] = /kept with a probability of ([\d.]+) % \(required: 95 %; 50 posterior samples\)/.exec(top);
  assert.ok(Math.abs(Number(probability) - 100 * result.tension.limit_probability) < 0.06);
  const rows = await cells(page, "#plan table tbody tr");
  ["normal_rmse", "normal_mean", "normal_max", "rmse", "mean", "max"].forEach((key, i) => ["as_built", "planned", "unconstrained"].forEach((state, k) =>
    assertShown(rows[i][k + 1], 1e3 * result.form[state][key], `${state} ${key}`)));
}));

test("a plan that cannot keep its limits says so, and names those in the way", () => on("infeasible", async (page, result) => {
  assert.equal(result.feasible, false);
  const verdict = await page.textContent("#verdict");
  assert.match(verdict, /Limits cannot all be kept/);
  assert.ok(verdict.includes(`tension of edge ${result.violations[0].id}: `), verdict);
  assert.match(await page.textContent("#warnings"), /^DO NOT TURN BY THIS LIST/);
  assert.match(await page.textContent("#crews"), /DO NOT TURN BY THIS LIST/);
  const top = await page.textContent("header");
  assert.match(top, /No strokes keep all limits/);
  assert.doesNotMatch(top, /keeps all cables within their limits|with the required probability/);
  // A crew may have no other sheet than its own.
  await page.emulateMedia({ media: "print" });
  assert.match(await page.innerText("[data-crew='1']"), /DO NOT TURN BY THIS LIST/);
}));

test("a plan towards target tensions shows how near each comes, the worst first, and what is in the way", () => on("to_tensions", async (page, { target_tensions, options }) => {
  const rows = await cells(page, "#plan table:nth-of-type(1) ~ table tbody tr, #plan .scroll:nth-of-type(2) tbody tr");
  const off = (t) => Math.abs(t.mean - t.target) / t.tolerance;
  const sorted = [...target_tensions].sort((a, b) => off(b) - off(a));
  sorted.slice(0, 40).forEach((t, i) => ["target", "tolerance", "as_built", "planned", "unconstrained", "mean", "std"].forEach((key, k) =>
    assertShown(rows[i][k + 1], t[key] / 1e3, `${t.edge_id} ${key}`)));
  const within = target_tensions.filter((t) => t.obstacle === "none").length;
  assert.ok((await page.textContent(".sentences")).includes(`${within} of ${target_tensions.length} target tensions`));
  const words = await page.textContent("#plan");
  assert.match(words, /missed: no strokes of these turnbuckles were found that reach all targets, not even unlimited ones with any form/);
  assert.ok(words.includes(`A form deviation of ${(1e3 * options.form_tolerance).toFixed(2)} mm counts as much as one tolerance`), words);
}));

test("a plan without samples, pitch or turns says what it does not have", async () => {
  await on("unsure", async (page, { draws }) => {
    assert.equal(draws, 0);
    assert.match(await page.textContent("#verdict"), /No limits of tension or reaction were given; no cable goes slack, by the estimate alone/);
    assert.doesNotMatch(await page.textContent("header"), /limits are kept/i);
    assert.match(await page.textContent(".sentences"), /the probability is not known: /);
    assert.equal((await crewRows(page, 1))[0].length, 7, "no step, turns or rotation");
    assert.match(await page.textContent("#crews"), /the thread is not known/);
    assert.doesNotMatch(await page.textContent("#crews"), /clockwise/);
  });
  await on("idle", async (page, { turns }) => {
    assert.equal(turns.length, 0);
    assert.match(await page.textContent(".sentences"), /Nothing to turn: .* within the tolerance of 50\.0 mm/);
    assert.match(await page.textContent("#crews"), /there is no list/);
    assert.equal(await page.locator(".strokes").count(), 0);
  });
});

test("before and after are exaggerated alike, and coloured on one scale", () => onView("plan", async (page) => {
  await page.selectOption("#displacement", "0");
  const factor = await page.textContent(".slider output");
  await page.selectOption("#displacement", "1");
  assert.equal(await page.textContent(".slider output"), factor);
  await page.selectOption("#displacement", "-1");
  for (const name of ["normal", "distance", "tension"]) {
    const scales = [];
    for (const state of ["built", "planned"]) {
      await page.selectOption("#colour-by", `${name}_${state}`);
      scales.push(await page.textContent(".legend .ticks"));
    }
    assert.equal(scales[0], scales[1], name);
  }
}));

test("arrows at the turnbuckles differ by hue and direction", () => onView("plan", async (page, result) => {
  const strokes = new Map();
  for (const { edge, stroke } of result.turns) strokes.set(edge, (strokes.get(edge) ?? 0) + stroke);
  const shorter = [...strokes.values()].filter((s) => s < 0).length;
  assert.match(await page.textContent(".strokes"), new RegExp(`shorten \\(${shorter}\\).*lengthen \\(${strokes.size - shorter}\\)`));
  await page.click("[data-view=top]");
  // On grey edges only the arrows, and the nodes' blue, have these hues.
  await page.selectOption("#colour-by", "std");
  const hues = await page.$eval(".canvas canvas:not(.labels)", async (canvas) => {
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
    const near = (i, [r, g, b]) => Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 24;
    let [blue, orange] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (near(i, [0, 114, 178])) ++blue;
      if (near(i, [213, 94, 0])) ++orange;
    }
    return { blue, orange };
  });
  assert.equal(hues.blue > 20, shorter > 0, JSON.stringify(hues));
  assert.equal(hues.orange > 20, strokes.size > shorter, JSON.stringify(hues));
}));

/** [semi-major, semi-minor, angle] of the 95 % ellipse of a 2 x 2 covariance. */
function axesOf([[a, b], [, c]]) {
  const [middle, half] = [(a + c) / 2, Math.sqrt(((a - c) / 2) ** 2 + b * b)];
  return [...[half, -half].map((part) => 2.447747 * Math.sqrt(Math.max(middle + part, 0))), 0.5 * Math.atan2(2 * b, a - c)];
}

test("error ellipses have the axes of the covariances, in a turned view too, and the scale of the legend", async () => {
  // Standard deviations of 3 and 1 mm in plan, the larger one at 30 degrees from x to y, and 2 mm in height.
  const [[cos, sin], [along, across, height]] = [[Math.sqrt(0.75), 0.5], [3e-3, 1e-3, 2e-3].map((std) => std ** 2)];
  const covariance = [along * cos * cos + across * sin * sin, (along - across) * cos * sin, 0, along * sin * sin + across * cos * cos, 0, height];
  const result = structuredClone(reports.moved.result);
  const node = result.cable_net.nodes.findIndex((_, i) => !result.cable_net.supports.includes(i));
  result.form_covariance = result.cable_net.nodes.map((_, i) => (i === node ? covariance : [1e-8, 0, 0, 1e-8, 0, 1e-8]));
  write("ellipses", result);
  const page = await open(reportOf("ellipses").page);
  const drawn = () => page.$eval(".canvas", ({ netView }) => netView.ellipses());
  const own = async () => (await drawn()).find((one) => one.node === node);
  assert.deepEqual(await drawn(), [], "shown without being asked for");
  await page.click("[data-view=top]");
  await page.check("#ellipses");
  assert.equal((await drawn()).length, result.cable_net.nodes.length);
  const factor = plainNumber(/× ([\d.]+)/.exec(await page.textContent(".legend.ellipses"))[1]);
  assert.match(await page.textContent(".legend.ellipses"), new RegExp(`95 % .*largest in plan: semi-axes of 7\\.34 × 2\\.45 mm at node ${node}$`));
  assert.match(await page.textContent(".sentences"), new RegExp(`largest 95 % error ellipse of the predicted form in plan has semi-axes of 7\\.34 × 2\\.45 mm at node ${node}\\.`));
  // Pixels of a metre, from two nodes of the form seen from above.
  const other = result.cable_net.nodes.findIndex((_, i) => i !== node && Math.abs(result.form[i][0] - result.form[node][0]) > 0.3);
  const pixelsOfMetre = await page.$eval(".canvas", ({ netView }, [node, other, metres]) =>
    Math.abs(netView.placeOf(node)[0] - netView.placeOf(other)[0]) / metres, [node, other, Math.abs(result.form[node][0] - result.form[other][0])]);
  const check = ({ ellipse }, seen, what) => {
    const [major, minor, angle] = axesOf(seen);
    const scale = factor * pixelsOfMetre;
    assert.ok(Math.abs(ellipse.major / (scale * major) - 1) < 0.02, `${what}: semi-major ${ellipse.major} for ${scale * major}`);
    assert.ok(Math.abs(ellipse.minor / (scale * minor) - 1) < 0.02, `${what}: semi-minor ${ellipse.minor} for ${scale * minor}`);
    // Down the screen is down the net.
    assert.ok(Math.abs(Math.sin(ellipse.angle + angle)) < 0.01, `${what}: angle ${ellipse.angle} for ${-angle}`);
  };
  const covarianceOf = (i, k) => covariance[[[0, 1, 2], [1, 3, 4], [2, 4, 5]][i][k]];
  /** Seen by a camera at such an angle about z, and from the vertical. */
  const seenFrom = (azimuth, polar) => {
    const axes = [[-Math.sin(azimuth), Math.cos(azimuth), 0], [-Math.cos(polar) * Math.cos(azimuth), -Math.cos(polar) * Math.sin(azimuth), Math.sin(polar)]];
    return axes.map((u) => axes.map((v) => u.reduce((sum, x, i) => sum + x * v.reduce((part, y, k) => part + covarianceOf(i, k) * y, 0), 0)));
  };
  check(await own(), seenFrom(-Math.PI / 2, 0), "top view");
  await page.focus(".canvas canvas:not(.labels)");
  for (let i = 0; i < 6; ++i) await page.keyboard.press("ArrowRight");
  check(await own(), seenFrom(-Math.PI / 2 + 0.6, 0), "turned");
  for (let i = 0; i < 8; ++i) await page.keyboard.press("ArrowDown");
  check(await own(), seenFrom(-Math.PI / 2 + 0.6, 0.8), "turned and tilted");
  await page.click("[data-view=perspective]");
  const moves = await page.$eval(".canvas", ({ netView: { camera, canvas } }, place) => [0, 1, 2].map((k) => {
    const [before, after] = [-0.02, 0.02].map((by) => camera.project(Float32Array.from(place, (x, i) => x + (i === k ? by : 0)), canvas.clientWidth, canvas.clientHeight));
    return [0, 1].map((i) => (after[i] - before[i]) / 0.04);
  }), result.form[node]);
  const projected = [0, 1].map((u) => [0, 1].map((v) => moves.reduce((sum, a, i) => sum + moves.reduce((part, b, k) => part + a[u] * covarianceOf(i, k) * b[v], 0), 0)));
  const [major, minor, angle] = axesOf(projected);
  const { ellipse } = await own();
  assert.ok(Math.abs(ellipse.major / (factor * major) - 1) < 0.02 && Math.abs(ellipse.minor / (factor * minor) - 1) < 0.02, JSON.stringify([ellipse, factor * major, factor * minor]));
  assert.ok(Math.abs(Math.sin(ellipse.angle - angle)) < 0.01);
  // Larger by the slider, gone where another form is shown or it is switched off.
  const before = (await own()).ellipse.major;
  await page.fill("#ellipse-exaggeration", "100");
  assert.ok(Math.abs((await own()).ellipse.major / before - 4) < 0.01);
  await page.uncheck("#ellipses");
  assert.deepEqual(await drawn(), []);
  assert.equal(await page.locator(".legend.ellipses").count(), 0);
  await page.close();
});

test("results have the covariances of their form, and the ellipses stand where that form is shown", async () => {
  await onView("moved", async (page, { form_covariance, cable_net }) => {
    assert.equal(form_covariance.length, cable_net.nodes.length);
    await page.check("#ellipses");
    const drawn = await page.$eval(".canvas", ({ netView }) => netView.ellipses().map(({ node }) => node));
    for (const node of cable_net.nodes.keys()) {
      if (!cable_net.supports.includes(node)) assert.ok(drawn.includes(node), `free node ${node}`);
    }
    const inPlan = form_covariance.map(([xx, xy, , yy]) => axesOf([[xx, xy], [xy, yy]])[0]);
    const largest = inPlan.indexOf(Math.max(...inPlan));
    const [, major, node] = /semi-axes of (\S+) × \S+ mm at node (\d+)/.exec(await page.textContent(".sentences"));
    assert.equal(Number(node), largest);
    assertShown(major, 1e3 * inPlan[largest]);
    await page.uncheck("#ellipses");
  });
  await onView("plan", async (page, { planned_form_covariance, planned_form_std }) => {
    planned_form_covariance.forEach(([xx, , , yy, , zz], i) => [xx, yy, zz].forEach((variance, k) =>
      assert.ok(Math.abs(Math.sqrt(variance) - planned_form_std[i][k]) < 2e-9, `${i} ${k}`)));
    await page.check("#ellipses");
    const count = (displacement) => page.selectOption("#displacement", displacement).then(() => page.$eval(".canvas", ({ netView }) => netView.ellipses().length));
    const all = await count("-1");
    assert.equal(all, planned_form_covariance.filter((c) => c[0] > 0).length);
    assert.ok(all > 0);
    assert.deepEqual([await count("0"), await count("1"), await count("2")], [0, all, all], "as built, as planned, effect of turning");
    await page.selectOption("#displacement", "-1");
    await page.uncheck("#ellipses");
  });
  await on("unsure", async (page, { planned_form_covariance }) => {
    assert.equal(planned_form_covariance, null);
    assert.equal(await page.locator("#ellipses").count(), 0);
    assert.doesNotMatch(await page.textContent(".sentences"), /ellipse/);
  });
});

test("in the crews' drawing a name stands apart from the numbers of others", () => on("infeasible", async (page) => {
  const gaps = await page.$$eval(".crew-drawing", (drawings) => drawings.flatMap((drawing) => {
    const rings = [...drawing.querySelectorAll(".ring")];
    const own = rings.map((ring) => [ring, ring.nextElementSibling.nextElementSibling]);
    return own.filter(([, name]) => name.textContent).flatMap(([ring, name]) => rings.filter((other) => other !== ring).flatMap((other) => {
      const [a, b] = [name.getBBox(), other.getBBox()];
      if (a.y + a.height < b.y || b.y + b.height < a.y) return [];
      return [Math.max(a.x - b.x - b.width, b.x - a.x - a.width)];
    }));
  }));
  assert.ok(gaps.length > 0);
  assert.ok(Math.min(...gaps) > 2.5, `${Math.min(...gaps)} mm`);
}));

test("a page whose result is damaged says so", async () => {
  const whole = readFileSync(reports.plain.page, "utf8");
  const start = whole.indexOf("id=\"result\">") + 12;
  const end = whole.indexOf("</script>", start);
  const page = await browserWithoutView.newPage();
  for (const damaged of [whole.slice(start, start + 500), "{\"format\": \"taut-net\"}", "{\"format\": \"taut-plan\", \"version\": 1}", ""]) {
    writeFileSync(join(folder, "damaged.html"), whole.slice(0, start) + damaged + whole.slice(end));
    await page.goto(`file://${join(folder, "damaged.html")}`);
    assert.match(await page.textContent("[role=alert]"), /cannot be shown.*taut report/s);
  }
});

test("tablets and phones see all of the page without scrolling sideways, and a tap selects", async () => {
  for (const name of ["study", "troubled", "comparison", "plan", "jobs"]) {
    const hasView = ["study", "plan"].includes(name);
    const page = await open(reports[name].page, { hasTouch: true, isMobile: true, colorScheme: "dark" }, hasView ? browser : browserWithoutView);
    for (const [width, height] of [[1180, 820], [390, 844], [820, 1180]]) {
      await page.setViewportSize({ width, height });
      await page.waitForFunction((width) => innerWidth === width, width);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, `${name} at ${width}`);
    }
    if (name === "study") {
      // The view follows the page's width, and begins dark where the page does.
      await page.waitForFunction(() => document.querySelector("canvas").clientWidth === document.querySelector(".canvas").clientWidth);
      await pixels(page);
      const ground = await page.$eval("canvas", (canvas) => {
        const copy = new OffscreenCanvas(1, 1).getContext("2d");
        copy.drawImage(canvas, 0, 0);
        return copy.getImageData(0, 0, 1, 1).data[0];
      });
      assert.ok(ground < 64, `${ground}`);
      const { nodes, supports } = reports.study.result.cable_net;
      const node = nodes.findIndex((_, i) => !supports.includes(i));
      const [x, y] = await page.$eval(".canvas", ({ netView }, node) => netView.placeOf(node), node);
      await page.tap(".canvas canvas:not(.labels)", { position: { x, y } });
      assert.equal(await inspected(page), `Free node ${node}`);
    }
    assert.deepEqual(page.complaints, []);
    await page.close();
  }
});
