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
import { folder, makeReports } from "./results.mjs";

const executablePath = process.env.TAUT_CHROMIUM ?? "/usr/bin/chromium";
if (!existsSync(executablePath)) {
  console.log(`skipped: no Chromium at ${executablePath}, install the package chromium or set TAUT_CHROMIUM`);
  process.exit(0);
}

let browser;
let browserWithoutView;
let reports;

before(async () => {
  reports = makeReports();
  // Without a graphics card Chromium draws in software only when told that it may.
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
  browserWithoutView = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu", "--disable-3d-apis"] });
});
after(async () => {
  await browser?.close();
  await browserWithoutView?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Opens a report; whatever it asks for or complains about fails the test. */
async function open(path, options = {}, opener = browser) {
  const page = await opener.newPage({ viewport: { width: 1280, height: 900 }, ...options });
  page.complaints = [];
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) page.complaints.push(`request ${request.url()}`);
  });
  page.on("console", (message) => {
    // Reading pixels back is slow, says the driver; only tests and print do. And what is switched off is missing.
    const isExpected = message.text().includes("GPU stall") || (opener === browserWithoutView && message.text().includes("WebGL"));
    if (["error", "warning"].includes(message.type()) && !isExpected) page.complaints.push(message.text());
  });
  page.on("pageerror", (error) => page.complaints.push(error.message));
  page.on("dialog", (dialog) => page.complaints.push(`dialog ${dialog.message()}`));
  await page.goto(`file://${path}`);
  await page.waitForSelector("body[data-ready]");
  return page;
}

/** The same without the view of the net, which takes half the time. */
const openWithoutView = (path) => open(path, {}, browserWithoutView);

async function close(page) {
  assert.deepEqual(page.complaints, []);
  await page.close();
}

/** The picture of the view. */
async function pixels(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.$eval(".canvas canvas", (canvas) => canvas.toDataURL());
}

const inspected = (page) => page.textContent(".inspector h3");
const plainNumber = (text) => Number(text.replaceAll("−", "-").replace(/[^\d.e-]/g, ""));

async function inspectedValue(page, name) {
  return page.$eval(".inspector dl", (list, name) => {
    const term = [...list.querySelectorAll("dt")].find((dt) => dt.textContent === name);
    return term?.nextElementSibling.textContent;
  }, name);
}

/** Each chart is saved as an SVG that stands alone, on white, from the dark page too. */
async function checkSavedCharts(page, name) {
  await page.emulateMedia({ colorScheme: "dark" });
  for (const figure of await page.locator("#figures [data-figure]:visible").all()) {
    const [download] = await Promise.all([page.waitForEvent("download"), figure.locator("button:has-text('Save as SVG')").click()]);
    const file = join(folder, `${name}_${download.suggestedFilename()}`);
    await download.saveAs(file);
    assert.equal(download.suggestedFilename(), `${await figure.getAttribute("data-figure")}.svg`);
    const text = readFileSync(file, "utf8");
    assert.match(text, /<svg [^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
    assert.doesNotMatch(text, /var\(|currentColor|NaN|undefined|<script|href|url\((?!#)/);
    const opened = await page.evaluate((text) => new DOMParser().parseFromString(text, "image/svg+xml").querySelector("parsererror")?.textContent ?? "", text);
    assert.equal(opened, "", file);
    assert.ok(text.includes('fill="white"') && text.includes("<text"), file);
  }
}

/** Every control and drawing has a name for a screen reader, and headings go down by one. */
async function checkNames(page) {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, select, input, svg, canvas, section, [role=region]")]
      .filter((e) => !(e.ariaLabel || e.labels?.length || e.textContent.trim() && e.matches("button") || document.getElementById(e.getAttribute("aria-labelledby"))))
      .map((e) => e.outerHTML.slice(0, 80)));
  assert.deepEqual(nameless, []);
  const levels = await page.$$eval("h1, h2, h3", (heads) => heads.map((h) => Number(h.tagName[1])));
  levels.forEach((level, i) => assert.ok(i === 0 ? level === 1 : level <= levels[i - 1] + 1, `heading ${i}`));
}

test("every report opens from disk without a request or a complaint, has names for all it shows, and saves its charts", async () => {
  for (const [name, { page: path, result }] of Object.entries(reports)) {
    const page = await open(path);
    assert.ok((await page.textContent("h1")).includes(result.net.name));
    assert.equal(await page.locator(".sentences li").count(), 3);
    assert.ok((await page.locator("#figures svg").count()) > 0);
    assert.equal(await page.locator(".failure[role=alert]").count(), 0);
    assert.doesNotMatch(await page.innerText("body"), /NaN|undefined|Infinity/);
    await checkNames(page);
    await checkSavedCharts(page, name);
    await close(page);
  }
});

test("a click on an edge in the view selects it in charts and table too", async () => {
  const { page: path, result } = reports.study;
  const page = await open(path);
  const edge = result.cable_net.edges.findIndex((_, e) => !result.cable_net.adjustable.includes(e));
  const place = await page.$eval(".canvas", ({ netView }, [s, t]) => {
    const [a, b] = [netView.placeOf(s), netView.placeOf(t)];
    return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2 };
  }, result.cable_net.edges[edge]);
  await page.click(".canvas canvas", { position: place });
  assert.equal(await inspected(page), `Edge ${edge}`);
  assert.equal(await page.locator("#figures .mark.selected").count(), 6);
  assert.equal(await page.textContent("#tables tr[aria-selected=true] td"), String(edge));
  await close(page);
});

test("a click on a node in the view tells its place and values", async () => {
  const { page: path, result } = reports.study;
  const page = await open(path);
  const node = result.cable_net.nodes.findIndex((_, i) => !result.cable_net.supports.includes(i));
  const [x, y] = await page.$eval(".canvas", ({ netView }, node) => netView.placeOf(node), node);
  await page.click(".canvas canvas", { position: { x, y } });
  assert.equal(await inspected(page), `Free node ${node}`);
  const shown = plainNumber(await inspectedValue(page, "form deviation, true − identified"));
  assert.ok(Math.abs(shown - 1e3 * result.sample.form_error.identified[0]) < 1e-4);
  await close(page);
});

/** Where edge i = index + 1 stands in a chart, told by two of its marks, and the chart's height. */
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

test("a click in a chart selects the edge that stands there", async () => {
  const page = await openWithoutView(reports.study.page);
  const chart = page.locator("[data-figure=length_deviations] svg");
  await chart.scrollIntoViewIfNeeded();
  const edge = 9;
  const [x, height] = await placeOfEdge(chart, edge);
  await chart.click({ position: { x, y: height / 2 } });
  const { adjustable, edges } = reports.study.result.cable_net;
  const interior = edges.map((_, e) => e).filter((e) => !adjustable.includes(e));
  assert.equal(await inspected(page), `Edge ${interior[edge]}`);
  await close(page);
});

test("a box drawn over a chart zooms to it, and the whole comes back", async () => {
  const page = await openWithoutView(reports.study.page);
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
  await close(page);
});

test("the arrows go through the table, and turn the view", async () => {
  const page = await open(reports.study.page);
  await page.focus("#tables .rows");
  await page.keyboard.press("ArrowDown");
  const first = await inspected(page);
  await page.keyboard.press("ArrowDown");
  assert.notEqual(await inspected(page), first);
  const before = await pixels(page);
  await page.focus(".canvas canvas");
  await page.keyboard.press("ArrowLeft");
  const turned = await pixels(page);
  assert.notEqual(turned, before);
  await page.keyboard.press("+");
  assert.notEqual(await pixels(page), turned);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator(".inspector h3").count(), 0);
  await close(page);
});

test("every colouring, viewpoint and displacement draws another picture", async () => {
  const page = await open(reports.study.page);
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
  await close(page);
});

test("the view is turned by a drag and zoomed by the wheel", async () => {
  const page = await open(reports.study.page);
  const box = await page.locator(".canvas canvas").boundingBox();
  const before = await pixels(page);
  await page.mouse.move(box.x + 200, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 300, box.y + 230, { steps: 4 });
  await page.mouse.up();
  const turned = await pixels(page);
  assert.notEqual(turned, before);
  assert.equal(await page.locator(".inspector h3").count(), 0, "the end of a drag is no click");
  await page.mouse.wheel(0, -300);
  assert.notEqual(await pixels(page), turned);
  await close(page);
});

test("the numbers on the page are the result's", async () => {
  const { page: path, result } = reports.study;
  const page = await openWithoutView(path);
  const method = result.methods.gp_as_in_paper;
  const cards = (await page.locator(".card .value").allTextContents()).map(plainNumber);
  const expected = [1e3 * Math.sqrt(method.mse), 100 * method.mrse, 1e3 * result.form_error.nominal.mean, 1e3 * result.form_error.identified.mean, 100 * method.coverage_95];
  cards.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) <= 0.006 * expected[i], `${value} for ${expected[i]}`));

  const rows = await page.$$eval("#paper table:last-of-type tbody tr", (rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  const forms = Object.fromEntries(rows.slice(-4).map(([name, ...cells]) => [name.toLowerCase(), cells.map(plainNumber)]));
  for (const key of ["max", "min", "mean", "rmse"]) {
    const [paperNominal, nominal, paperIdentified, identified] = forms[key];
    for (const [shown, metres] of [
      [paperNominal, result.paper.form_error.nominal[key]], [nominal, result.form_error.nominal[key]],
      [paperIdentified, result.paper.form_error.identified[key]], [identified, result.form_error.identified[key]],
    ]) {
      assert.ok(Math.abs(shown - 1e3 * metres) <= 0.006 * 1e3 * metres, `${key}: ${shown} for ${1e3 * metres}`);
    }
  }
  const settings = await page.textContent("#settings");
  for (const text of [result.prior, result.net.fingerprint, result.date, result.command, String(result.samples.training)]) assert.ok(settings.includes(text), text);
  await close(page);
});

/** Rows of a CSV text without quotes in it. */
const parse = (text) => text.trim().split("\r\n").map((line) => line.split(","));

test("the table is sorted, filtered and downloaded with all digits", async () => {
  const { page: path, result } = reports.plain;
  const page = await openWithoutView(path);
  const download = async () => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.click("#tables .csv >> nth=0")]);
    return parse(readFileSync(await file.path(), "utf8"));
  };
  const [head, ...all] = await download();
  assert.equal(all.length, result.cable_net.edges.length);
  const column = head.indexOf("deviation [mm]");
  for (const edge of result.edges) {
    const row = all.find((cells) => cells[0] === String(edge.edge));
    assert.equal(Number(row[column]), 1e3 * edge.length_deviation);
    assert.ok(Math.abs(Number(row[head.indexOf("95 % from [mm]")]) - 1e3 * edge.lower) < 1e-9);
  }
  const magnitudes = all.map((cells) => cells[column]).filter(Boolean).map((text) => Math.abs(Number(text)));
  assert.deepEqual(magnitudes, magnitudes.toSorted?.((a, b) => b - a) ?? [...magnitudes].sort((a, b) => b - a), "the largest first");

  await page.click("#tables th button >> nth=0");
  const [, ...byName] = await download();
  assert.equal(byName[0][0], "0");
  await page.fill("#tables input >> nth=0", "adjustable");
  const [, ...adjustable] = await download();
  assert.equal(adjustable.length, result.cable_net.adjustable.length);
  assert.match(await page.textContent("#tables [role=status]"), /of \d+ rows/);
  await close(page);
});

test("only the rows that are seen exist", async () => {
  const page = await openWithoutView(reports.study.page);
  const rows = () => page.locator("#tables .rows >> nth=0 >> tr[data-row]").count();
  assert.ok((await rows()) < 60);
  const first = await page.textContent("#tables tr[data-row] td");
  await page.$eval("#tables .rows", (scroller) => (scroller.scrollTop = scroller.scrollHeight));
  await page.waitForFunction((first) => document.querySelector("#tables tr[data-row] td").textContent !== first, first);
  assert.ok((await rows()) < 60);
  await close(page);
});

test("troubles of a survey are listed and lead to their place", async () => {
  const { page: path, result } = reports.troubled;
  const page = await open(path);
  const text = await page.textContent("#lists");
  for (const words of ["T-900", "<b>T-901</b>"]) assert.ok(text.includes(words), words);
  const counts = await page.locator("#lists .count").allTextContents();
  assert.deepEqual(counts, ["1", "1", "1", "2", "2"]);
  await page.click("#lists .list:nth-child(3) .chip");
  assert.equal(await inspected(page), "Free node 8");
  await page.click("#lists .list:nth-child(1) .chip");
  assert.equal(await inspected(page), `Edge ${result.edges[0].edge}`);
  assert.equal(await inspectedValue(page, "status"), "slack");
  assert.equal(await page.locator("[data-figure=residual_histogram]").count(), 1);
  assert.match(await page.textContent(".sentences"), /1 slack cable.*1 gross error.*2 nodes not surveyed/s);
  await close(page);
});

test("a gross error is told in mm, its statistic where more is asked of it", async () => {
  const page = await openWithoutView(reports.troubled.page);
  const chip = page.locator("#lists .list:nth-child(3) .chip");
  assert.equal(await chip.textContent(), "8 51.2 mm");
  assert.match(await chip.getAttribute("title"), /5\.25.*left out above 4\.50/);
  await chip.click();
  assert.equal(await inspectedValue(page, "gross error, from where all others tell"), "51.200 mm");
  assert.equal(await inspectedValue(page, "gross error, square in standard deviations"), "5.25; left out above 4.50");
  await close(page);
});

test("headline and caption tell the same distances, over the same targets", async () => {
  for (const { page: path, result } of [reports.troubled, reports.moved]) {
    const page = await openWithoutView(path);
    const left = new Set(result.survey.outliers.map((o) => o.node));
    const distances = result.survey.residuals.filter((r) => !left.has(r.node)).map((r) => 1e3 * Math.hypot(r.dx, r.dy, r.dz));
    const most = Math.max(...distances);
    const rms = Math.sqrt(distances.reduce((sum, d) => sum + d * d, 0) / distances.length);
    const caption = await page.textContent("figure:has([data-figure=residual_map]) figcaption");
    const [, ofCaption, mostOfCaption] = /give: ([^ ]+) mm RMS, at most ([^ ]+) mm\./.exec(caption);
    assert.ok(Math.abs(plainNumber(ofCaption) - rms) <= 0.006 * rms, caption);
    assert.ok(Math.abs(plainNumber(mostOfCaption) - most) <= 0.006 * most, caption);
    const headline = await page.textContent(".sentences li:nth-child(2)");
    if (left.size > 0) {
      assert.match(headline, /over the \d+ targets in use; the 1 left out for gross errors is 50\.0 mm away/);
      assert.match(caption, /1 target left out for gross errors, up to 50\.0 mm away/);
    } else {
      const [, inHeadline, mostInHeadline] = /lies ([^ ]+) mm \(RMS\).* at most ([^ ]+) mm\./.exec(headline);
      assert.deepEqual([inHeadline, mostInHeadline], [ofCaption, mostOfCaption]);
    }
    await close(page);
  }
});

test("slack edges stand apart with their bound, and in no statistic of deviations", async () => {
  const { page: path, result } = reports.troubled;
  const page = await openWithoutView(path);
  const slack = result.edges[0].edge;
  assert.equal(await page.textContent("#lists .list:nth-child(1) .chip"), `${slack} ≥ 63.2 mm`);
  assert.match(await page.textContent("#lists .list:nth-child(1)"), /in no statistic of the deviations/);
  const tense = result.edges.filter((e) => e.status !== "slack");
  const largest = Math.max(...tense.map((e) => Math.abs(1e3 * e.length_deviation)));
  const headline = await page.textContent(".sentences li:nth-child(1)");
  const [, told] = /of those that are not slack, the cable \S+ deviates most: ([^ ]+) mm/.exec(headline);
  assert.ok(Math.abs(plainNumber(told) - largest) <= 0.006 * largest, headline);
  const card = page.locator(".card", { hasText: "length deviation, RMS, slack cables apart" });
  const rms = 1e3 * Math.sqrt(tense.reduce((sum, e) => sum + e.length_deviation ** 2, 0) / tense.length);
  assert.ok(Math.abs(plainNumber(await card.locator(".value").textContent()) - rms) <= 0.006 * rms);
  assert.notEqual(await page.textContent("#tables tr[data-row] td"), String(slack), "the slack edge is ranked among the largest deviations");
  await page.click("#lists .list:nth-child(1) .chip");
  assert.equal(await inspectedValue(page, "length deviation of a slack edge, at least"), "63.200 mm");
  assert.equal(await inspectedValue(page, "length deviation, identified"), undefined);
  assert.match(await page.textContent("[data-figure=length_intervals]"), /slack: at least/);
  await close(page);
});

test("law, noise ratio, frame and control residuals are shown", async () => {
  const { page: path, result } = reports.moved;
  assert.equal(result.length_prior, "uniform:2mm");
  const page = await openWithoutView(path);
  const top = await page.textContent("header");
  assert.match(top, /anywhere within ±2 mm/);
  const ratio = plainNumber(/residuals are ([\d.]+) times what its noise lets expect/.exec(top)[1]);
  assert.ok(Math.abs(ratio - result.survey.noise_ratio) <= 0.006 * ratio);
  const settings = await page.textContent("#settings");
  assert.match(settings, /law of the length deviationsuniform:2mm/);
  assert.match(settings, /prior of the length deviationsuniform:2mm, taken as exact/);
  const found = `target ${Number((1e3 * result.detectable.target).toPrecision(2))} mm`;
  assert.ok((await page.textContent("#detectable")).includes(found), found);
  const determined = result.edges.filter((e) => e.status === "determined").length;
  assert.ok(determined > 0 && (await page.textContent(".sentences")).includes(`${determined} of ${result.edges.length} interior cables are determined`));
  const assumed = await page.textContent("#assumptions");
  assert.ok(result.assumptions.length > 0 && result.assumptions.every((one) => assumed.includes(one.value)), assumed);
  const { fit, control } = result.frame;
  assert.equal(fit.count, control.length);
  assert.ok(top.includes(`moved into the net's frame by ${fit.count} control points`));
  const told = await page.textContent("#frame p");
  const [, rms, most, id] = /within ([^ ]+) mm \(RMS\), at most ([^ ]+) mm \((\S+)\)/.exec(told);
  assert.ok(Math.abs(plainNumber(rms) - 1e3 * fit.rms) <= 0.006 * 1e3 * fit.rms, told);
  const distances = control.map((c) => 1e3 * Math.hypot(c.dx, c.dy, c.dz));
  assert.ok(Math.abs(plainNumber(most) - Math.max(...distances)) <= 0.006 * Math.max(...distances));
  assert.equal(id, control[distances.indexOf(Math.max(...distances))].id);
  const [file] = await Promise.all([page.waitForEvent("download"), page.click("#frame .csv")]);
  const [, ...rows] = parse(readFileSync(await file.path(), "utf8"));
  assert.equal(rows.length, fit.count);
  assert.equal(Number(rows[0][4]), Math.max(...distances));
  await close(page);
  const troubled = await openWithoutView(reports.troubled.page);
  assert.match(await troubled.textContent(".sentences"), /1\.47 times what its noise lets expect/);
  assert.match(await troubled.textContent("#settings"), /frame of the surveythe net's/);
  await close(troubled);
});

test("what a result does not tell is said, not left empty", async () => {
  const plain = await open(reports.plain.page);
  assert.match(await plain.textContent("#lists"), /None: every cable whose length was asked for carries tension/);
  assert.match(await plain.textContent(".sentences"), /No cable is slack/);
  assert.equal(await plain.locator("[data-figure=residual_histogram]").count(), 0);
  await close(plain);
  const bare = await open(reports.bare.page);
  assert.equal(await bare.locator("[data-figure=residual_map]").count(), 0);
  assert.equal(await bare.locator("#colour-by option[value=tension]").count(), 0);
  await close(bare);
  const one = await open(reports.one.page);
  assert.match(await one.textContent("#figures"), /the one validation sample/);
  assert.doesNotMatch(await one.innerText("body"), /NaN|undefined|Infinity/);
  await close(one);
});

test("the findings of a result are shown with the option that is the remedy", async () => {
  const page = await open(reports.full_identification.page);
  const shown = await page.innerText(".trust");
  assert.match(shown, /Checks: failed/);
  assert.match(shown, /failed: one/);
  assert.match(shown, /note: three Look at it\. --prior uniform:8mm/);
  await close(page);
});

test("names with markup are shown as text and run nothing", async () => {
  const { page: path, result } = reports.hostile;
  const page = await open(path);
  assert.ok((await page.textContent("h1")).includes(result.net.name));
  await page.click("#tables tr[data-row] >> nth=0");
  assert.ok((await inspected(page)).includes("<img src=x onerror"));
  assert.equal(await page.evaluate(() => window.harmed), undefined);
  assert.equal(await page.locator("img:not(.print-only)").count(), 0);
  // A cell that begins like a formula would be run by a spreadsheet.
  const [file] = await Promise.all([page.waitForEvent("download"), page.click("#tables .csv >> nth=0")]);
  assert.ok(readFileSync(await file.path(), "utf8").includes("\"'=<img"));
  await close(page);
});

test("a comparison shows each method and the best possible", async () => {
  const { page: path, result } = reports.comparison;
  const page = await openWithoutView(path);
  const figures = await page.locator("#figures [data-figure]").evaluateAll((all) => all.map((f) => f.dataset.figure));
  assert.deepEqual(figures, ["error_over_noise", "error_over_training", "error_over_hidden"]);
  assert.match(await page.textContent("#figures"), /best possible/);
  assert.equal(await page.locator("#tables tr[data-row]").count(), result.rows.length);
  const sentences = await page.textContent(".sentences");
  assert.match(sentences, /At a noise of 0\.5 mm a coordinate, \w+ does best: .* mm a length \(RMS\), where the best possible is/);
  assert.match(sentences, /95 % intervals, where there is noise: .*map [\d.]+/);
  const unable = await page.locator("#tables tr[data-row]", { hasText: "needs a survey of all free nodes" }).count();
  assert.equal(unable, result.rows.filter((r) => r.first_failure === "needs a survey of all free nodes").length);
  await close(page);
});

test("simulated jobs are told in words, curves and all rounds", async () => {
  const { page: path, result } = reports.jobs;
  const page = await openWithoutView(path);
  const of = (name) => result.strategies.find((s) => s.strategy === name).rounds;
  const mm = (metres) => `${(1e3 * metres).toPrecision(3)} mm`;
  const sentences = await page.textContent(".sentences");
  assert.ok(sentences.includes(`2 rounds of turns planned on identified lengths bring the nets from ${mm(of("identified")[0].normal_rmse)} to ${mm(of("identified")[2].normal_rmse)}`), sentences);
  for (const [name, on] of [["true lengths", "planned with the true lengths known"], ["design", "on the design"], ["design, once", "on the design in the first round alone"]]) {
    assert.ok(sentences.includes(`${mm(of(name)[2].normal_rmse)} ${on}`), name);
  }
  assert.match(sentences, /Of 4 jobs, limits are broken in (none|\d) as built; after 2 rounds in (none|\d) planned on identified lengths/);
  assert.match(sentences, /No identification or plan failed/);
  const figures = await page.locator("#figures [data-figure]").evaluateAll((all) => all.map((f) => f.dataset.figure));
  assert.deepEqual(figures, ["control_form", "control_limits", "control_strokes"]);
  const rows = await page.$$eval("#rounds tbody tr", (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(rows.map(([name, round]) => `${name} ${round}`), ["as built 0", "true lengths 1", "true lengths 2", "identified 1", "identified 2", "design 1", "design 2", "design, once 1"]);
  assert.equal(rows[4][6], (1e3 * of("identified")[2].normal_rmse).toFixed(2));
  assert.equal(rows[4][9], `${of("identified")[2].broken_trials}/4`);
  const settings = await page.textContent("#settings");
  for (const text of ["uniform:2mm", "0.2 mm", "at least 0.05 kN, at most 20 kN", "±15 mm"]) assert.ok(settings.includes(text), text);
  await close(page);
});

test("jobs in which nothing could be planned say so", async () => {
  const one = await openWithoutView(reports.job.page);
  assert.match(await one.textContent(".sentences"), /1 round of turns planned on identified lengths brings the nets/);
  assert.doesNotMatch(await one.textContent(".sentences"), /first round alone|in the last/);
  assert.match(await one.textContent("#figures"), /1 job, so that nothing is told of how much jobs differ/);
  await close(one);
  const page = await openWithoutView(reports.failed.page);
  const sentences = await page.textContent(".sentences");
  assert.match(sentences, /Nothing could be planned on identified lengths: the nets stay .* as built/);
  assert.match(sentences, /failed 1 of 1 time with the true lengths known, 1 of 1 time on identified lengths/);
  assert.match(await page.textContent("#figures"), /Where nothing could be planned, 4 times over all jobs/);
  await close(page);
});

test("the table of rounds fits on paper", async () => {
  // A4 without its margins.
  const page = await open(reports.jobs.page, { viewport: { width: 688, height: 1000 } });
  await page.emulateMedia({ media: "print" });
  const [table, paper] = await page.$eval("#rounds table", (table) => [table.getBoundingClientRect().right, document.documentElement.clientWidth]);
  assert.ok(table <= paper, `${table} of ${paper}`);
  await close(page);
});

/** Cells of a crew's list: ["", step, cable, do, turn, turns, mm, reading, tension]. */
const crewRows = (page, crew) => page.$$eval(`[data-crew="${crew}"] tbody tr:not(.pass)`, (rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));

test("each crew's list has all that it turns, in the order of the work", async () => {
  const { page: path, result } = reports.plan;
  assert.ok(result.turns.length > 2);
  const page = await openWithoutView(path);
  for (const crew of [1, 2]) {
    const own = result.turns.filter((t) => t.crew === crew);
    assert.ok(own.length > 0);
    const rows = await crewRows(page, crew);
    assert.deepEqual(rows.map((r) => r[2]), own.map((t) => t.edge_id));
    rows.forEach((row, i) => {
      const turn = own[i];
      assert.equal(Number(row[1]), turn.step + 1);
      assert.ok(row[3].includes(turn.stroke < 0 ? "shorten" : "lengthen"), row[3]);
      // With a left-hand thread clockwise lengthens.
      assert.equal(row[4], turn.stroke < 0 ? "↺ counterclockwise" : "↻ clockwise");
      const [, whole, part] = /^(\d*) ?([¼½¾]?)$/.exec(row[5]);
      assert.equal(5 * (Number(whole) + ({ "¼": 0.25, "½": 0.5, "¾": 0.75 }[part] ?? 0)), Math.abs(1e3 * turn.stroke).toFixed(6) * 1);
      assert.ok(Math.abs(plainNumber(row[6]) - Math.abs(1e3 * turn.stroke)) < 0.0051);
      assert.ok(Math.abs(plainNumber(row[7]) - 1e3 * turn.reading_after) < 0.0051);
      assert.ok(Math.abs(plainNumber(row[8]) - turn.tension_after / 1e3) < 0.0051);
    });
    assert.equal(await page.locator(`[data-crew="${crew}"] .tick`).count(), own.length);
  }
  await close(page);
});

test("the head of a plan tells what it stands on, whether limits are kept, and how near it comes", async () => {
  const { page: path, result } = reports.plan;
  const page = await openWithoutView(path);
  const top = await page.textContent("header");
  assert.ok(top.includes(`The identification that this plan stands on: ${result.identification.verdict}`));
  assert.ok(result.feasible);
  assert.match(await page.textContent("#verdict"), /All limits are kept, with the 95 % that were asked for/);
  assert.ok(result.order.safe);
  assert.match(top, /no step breaks a limit that was kept before the work, with a probability of [\d.]+ % \(required: 95 %\)/);
  const [, probability] = /probability of ([\d.]+) % \(50 draws\), where 95 % was asked for/.exec(top);
  assert.ok(Math.abs(Number(probability) - 100 * result.tension.limit_probability) < 0.06);
  const keys = ["normal_rmse", "normal_mean", "normal_max", "rmse", "mean", "max"];
  const rows = await page.$$eval("#plan table >> nth=0", ([table]) => [...table.tBodies[0].rows].map((row) => [...row.children].slice(1).map((cell) => cell.textContent)));
  keys.forEach((key, i) => ["as_built", "planned", "unconstrained"].forEach((state, k) => {
    const expected = 1e3 * result.form[state][key];
    assert.ok(Math.abs(plainNumber(rows[i][k]) - expected) <= 0.006 * expected, `${state} ${key}: ${rows[i][k]}`);
  }));
  await close(page);
});

test("a plan that cannot keep its limits says so, and names those in the way", async () => {
  const { page: path, result } = reports.infeasible;
  assert.equal(result.feasible, false);
  const page = await openWithoutView(path);
  const verdict = await page.textContent("#verdict");
  assert.match(verdict, /Limits cannot all be kept/);
  assert.ok(verdict.includes(`tension of edge ${result.violations[0].id}: `), verdict);
  assert.match(await page.textContent("#warnings"), /^DO NOT TURN BY THIS LIST/);
  assert.match(await page.textContent("#crews"), /DO NOT TURN BY THIS LIST/);
  // A crew may have no other sheet than its own.
  await page.emulateMedia({ media: "print" });
  assert.match(await page.innerText("[data-crew='1']"), /DO NOT TURN BY THIS LIST/);
  assert.match(await page.textContent("header"), /limits, which no strokes can all keep/);
  assert.doesNotMatch(await page.textContent("header"), /All limits are kept|no cable leaves its limits/);
  await close(page);
});

test("a plan without draws, pitch or turns says what it does not tell", async () => {
  const unsure = await openWithoutView(reports.unsure.page);
  assert.equal(reports.unsure.result.draws, 0);
  assert.match(await unsure.textContent("#verdict"), /No limits of tension or reaction were given; no cable goes slack, by the estimate alone/);
  assert.doesNotMatch(await unsure.textContent("header"), /limits are kept/i);
  assert.match(await unsure.textContent(".sentences"), /cannot be promised: /);
  assert.equal((await crewRows(unsure, 1))[0].length, 7, "neither turns nor which way to turn");
  assert.match(await unsure.textContent("#crews"), /the thread is not known/);
  assert.doesNotMatch(await unsure.textContent("#crews"), /clockwise/);
  await close(unsure);
  const idle = await openWithoutView(reports.idle.page);
  assert.equal(reports.idle.result.turns.length, 0);
  assert.match(await idle.textContent(".sentences"), /Nothing is to be turned: .* which is within the 50\.0 mm/);
  assert.match(await idle.textContent("#crews"), /there is no list/);
  assert.equal(await idle.locator(".strokes").count(), 0);
  await close(idle);
});

test("before and after are exaggerated alike, and coloured on one scale", async () => {
  const page = await open(reports.plan.page);
  await page.selectOption("#displacement", "0");
  const factor = await page.textContent(".slider output");
  await page.selectOption("#displacement", "1");
  assert.equal(await page.textContent(".slider output"), factor);
  for (const name of ["normal", "distance", "tension"]) {
    const scales = [];
    for (const state of ["built", "planned"]) {
      await page.selectOption("#colour-by", `${name}_${state}`);
      scales.push(await page.textContent(".legend .ticks"));
    }
    assert.equal(scales[0], scales[1], name);
  }
  await close(page);
});

test("arrows at the turnbuckles are told by hue and sense", async () => {
  const { page: path, result } = reports.plan;
  const page = await open(path);
  const strokes = new Map();
  for (const { edge, stroke } of result.turns) strokes.set(edge, (strokes.get(edge) ?? 0) + stroke);
  const shorter = [...strokes.values()].filter((s) => s < 0).length;
  assert.match(await page.textContent(".strokes"), new RegExp(`shorten: out of the net \\(${shorter}\\).*lengthen: into it \\(${strokes.size - shorter}\\)`));
  await page.selectOption("#colour-by", "kind");
  await page.click("[data-view=top]");
  // On grey edges only the arrows, and the nodes' blue, have these hues.
  await page.selectOption("#colour-by", "std");
  const hues = await page.$eval(".canvas canvas", async (canvas) => {
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
  await close(page);
});

test("the lists of crews are printed whole, each on its own sheets", async () => {
  const { page: path, result } = reports.plan;
  const page = await openWithoutView(path);
  await page.evaluate(() => (window.print = () => {}));
  await page.click("#crews .print");
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
  assert.equal(pdf.match(/\/Type \/Page\b/g).length, 2, "one page a crew, and nothing else");
  await page.click("#crews .print");
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator("header").isVisible(), false);
  assert.equal(await page.locator("#crews .crew tbody tr:not(.pass):visible").count(), result.turns.length);
  for (const crew of [1, 2]) assert.ok((await page.innerText(`[data-crew="${crew}"] thead`)).includes(`Crew ${crew} of 2`));
  await close(page);
});

test("a page whose result is damaged says so", async () => {
  const whole = readFileSync(reports.plain.page, "utf8");
  const start = whole.indexOf("id=\"result\">") + 12;
  const end = whole.indexOf("</script>", start);
  for (const damaged of [whole.slice(start, start + 500), "{\"format\": \"taut-net\"}", ""]) {
    const path = join(folder, "damaged.html");
    writeFileSync(path, whole.slice(0, start) + damaged + whole.slice(end));
    const page = await browser.newPage();
    await page.goto(`file://${path}`);
    assert.match(await page.textContent("[role=alert]"), /cannot be shown.*taut report/s);
    await page.close();
  }
});

test("tablets and phones see all of the page without scrolling sideways", async () => {
  for (const { page: path } of [reports.study, reports.troubled, reports.comparison, reports.plan, reports.jobs]) {
    const page = await open(path, { hasTouch: true, isMobile: true });
    for (const [width, height] of [[1180, 820], [820, 1180], [390, 844]]) {
      await page.setViewportSize({ width, height });
      await page.waitForFunction((width) => innerWidth === width, width);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, `${path} at ${width}`);
    }
    await close(page);
  }
});

test("a tap selects", async () => {
  const { page: path, result } = reports.study;
  const page = await open(path, { viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true });
  const node = result.cable_net.nodes.findIndex((_, i) => !result.cable_net.supports.includes(i));
  const [x, y] = await page.$eval(".canvas", ({ netView }, node) => netView.placeOf(node), node);
  await page.tap(".canvas canvas", { position: { x, y } });
  assert.equal(await inspected(page), `Free node ${node}`);
  await close(page);
});

test("it prints on A4, black on white, with the view as a picture", async () => {
  const page = await open(reports.study.page, { colorScheme: "dark" });
  const pdf = (await page.pdf({ preferCSSPageSize: true })).toString("latin1");
  assert.match(pdf, /\/MediaBox \[0 0 59[45][.\d]* 84[12]/);
  const pages = pdf.match(/\/Type \/Page\b/g).length;
  assert.ok(pages >= 2 && pages <= 9, `${pages} pages`);
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  assert.equal(await page.locator(".canvas canvas").isVisible(), false);
  assert.equal(await page.locator(".canvas img").isVisible(), true);
  assert.ok((await page.locator("#tables .rows >> nth=0 >> tr[data-row]").count()) <= 40);
  await close(page);
});

test("the page has the licence of each package whose code is in it, which is not printed", async () => {
  // Which these are comes from the map of the code here, and from the metafile in the build.
  const viewer = fileURLToPath(new URL("..", import.meta.url));
  const { outputFiles } = await build({ absWorkingDir: viewer, entryPoints: ["src/main.ts"], bundle: true, write: false, outdir: "out", sourcemap: "external", sourcesContent: false });
  const { sources } = JSON.parse(outputFiles.find((file) => file.path.endsWith(".map")).text);
  const packages = new Set(sources.map((source) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(source)?.[1]).filter(Boolean));
  assert.ok(packages.has("three") && packages.has("d3-array"));

  const page = await open(reports.study.page);
  const words = (text) => text.split(/\s+/).join(" ").trim();
  assert.equal(await page.locator("#licences pre >> nth=0").isVisible(), false);
  await page.click("#licences summary");
  const shown = words(await page.innerText("#licences"));
  for (const name of packages) {
    assert.ok(shown.includes(`${name} `), `${name} is named`);
    assert.ok(shown.includes(words(readFileSync(join(viewer, "node_modules", name, "LICENSE"), "utf8"))), `the licence of ${name}`);
  }
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.locator("#licences").isVisible(), false);
  await close(page);
});

test("light and dark differ, in page and view", async () => {
  const grounds = [];
  for (const colorScheme of ["light", "dark"]) {
    const page = await open(reports.study.page, { colorScheme });
    grounds.push([await page.evaluate(() => getComputedStyle(document.body).backgroundColor), await pixels(page)]);
    await close(page);
  }
  assert.notEqual(grounds[0][0], grounds[1][0]);
  assert.notEqual(grounds[0][1], grounds[1][1]);
});

test("without WebGL all but the view is there, and it says so", async () => {
  const page = await openWithoutView(reports.study.page);
  assert.match(await page.textContent(".canvas"), /no WebGL/);
  assert.equal(await page.locator("[data-figure=net_plan]").isVisible(), true);
  await close(page);
});
