// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Bundles the app, one page with the program in it:
// node build_app.mjs PROGRAM.wasm REPORT_PAGE VERSION LICENCES OUTPUT, REPORT_PAGE as build.mjs makes it,
// and LICENCES of what is linked into the program, from scripts/app_licences.py.

import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";
import { gzipSync } from "node:zlib";
import { bundled, here, licencesOf, styleOf } from "./bundle.mjs";
import { markup } from "./licences.mjs";

const [program, reportPage, version, linked, output] = process.argv.slice(2);
if (!output) throw new Error("usage: node build_app.mjs PROGRAM.wasm REPORT_PAGE VERSION LICENCES OUTPUT");

const worker = await bundled("app/worker.ts");
const main = await bundled("app/main.ts", { "taut:worker": worker.script });
const hash = `'sha256-${createHash("sha256").update(main.script).digest("base64")}'`;
// The script of the reports, which a frame of this page runs under this page's policy, too.
const reportHash = /script-src ('sha256-[^']+')/.exec(await readFile(reportPage, "utf8"))[1];
const licences = markup([...(await licencesOf(worker, main)), ...JSON.parse(await readFile(linked, "utf8"))]);
const style = await styleOf("style.css", "app/app.css");
const zipped = gzipSync(await readFile(program), { level: 9 }).toString("base64");

const page = (await readFile(here("app/page.html"), "utf8"))
  .replace("@script-hashes@", () => `${hash} ${reportHash}`)
  .replace("@style@", () => style)
  .replace("@version@", () => version)
  .replace("@licences@", () => licences)
  .replace("@program@", () => zipped)
  .replace("@script@", () => main.script);
await writeFile(output, page);
