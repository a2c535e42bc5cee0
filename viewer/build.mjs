// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Bundles the viewer into one page that taut fills with a result: node build.mjs OUTPUT

import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";
import { build, transform } from "esbuild";

const output = process.argv[2];
if (!output) throw new Error("usage: node build.mjs OUTPUT");

const here = (name) => new URL(name, import.meta.url);
const bundle = await build({
  entryPoints: [new URL("src/main.ts", import.meta.url).pathname],
  bundle: true,
  minify: true,
  write: false,
  format: "iife",
  target: ["chrome109", "firefox115", "safari16"],
  charset: "utf8",
  legalComments: "inline",
});
// Within a script element a script must not end it, nor open what changes its mode.
const script = bundle.outputFiles[0].text.trim().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const style = (await transform(await readFile(here("style.css"), "utf8"), { loader: "css", minify: true })).code.trim();
const hash = `sha256-${createHash("sha256").update(script).digest("base64")}`;

const page = (await readFile(here("page.html"), "utf8"))
  .replace("@script-hash@", () => hash)
  .replace("@style@", () => style)
  .replace("@script@", () => script);
await writeFile(output, page);
