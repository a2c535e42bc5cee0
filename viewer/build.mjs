// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Bundles the viewer into one page that taut fills with a result: node build.mjs OUTPUT

import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { build, transform } from "esbuild";
import { markup, noticesOf, packagesIn } from "./licences.mjs";

const output = process.argv[2];
if (!output) throw new Error("usage: node build.mjs OUTPUT");

const here = (name) => new URL(name, import.meta.url);
const folder = fileURLToPath(here("."));
const bundle = await build({
  absWorkingDir: folder,
  entryPoints: ["src/main.ts"],
  bundle: true,
  minify: true,
  write: false,
  format: "iife",
  target: ["chrome109", "firefox115", "safari16"],
  charset: "utf8",
  legalComments: "inline",
  metafile: true,
});
// Within a script element a script must not end it, nor open what changes its mode.
const script = bundle.outputFiles[0].text.trim().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const style = (await transform(await readFile(here("style.css"), "utf8"), { loader: "css", minify: true })).code.trim();
const hash = `sha256-${createHash("sha256").update(script).digest("base64")}`;
const notices = [
  { packages: ["taut"], text: (await readFile(here("../LICENSE"), "utf8")).trim() },
  ...(await noticesOf(packagesIn(bundle.metafile).map((name) => folder + name))),
];

const page = (await readFile(here("page.html"), "utf8"))
  .replace("@script-hash@", () => hash)
  .replace("@style@", () => style)
  .replace("@licences@", () => markup(notices))
  .replace("@script@", () => script);
await writeFile(output, page);
