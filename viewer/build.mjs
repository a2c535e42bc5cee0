// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Bundles the viewer into one page that taut fills with a result: node build.mjs OUTPUT

import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";
import { bundled, here, licencesOf, styleOf } from "./bundle.mjs";
import { markup } from "./licences.mjs";

const output = process.argv[2];
if (!output) throw new Error("usage: node build.mjs OUTPUT");

const bundle = await bundled("src/main.ts");
const style = await styleOf("style.css");
const licences = markup(await licencesOf(bundle));
const hash = `sha256-${createHash("sha256").update(bundle.script).digest("base64")}`;

const page = (await readFile(here("page.html"), "utf8"))
  .replace("@script-hash@", () => hash)
  .replace("@style@", () => style)
  .replace("@licences@", () => licences)
  .replace("@script@", () => bundle.script);
await writeFile(output, page);
