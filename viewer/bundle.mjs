// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// What the pages are made of: scripts, styles and licences.

import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { build, transform } from "esbuild";
import { noticesOf, packagesIn } from "./licences.mjs";

export const here = (name) => new URL(name, import.meta.url);
const folder = fileURLToPath(here("."));

/** A bundled script, and esbuild's account of it. `texts` are modules by their names that give a text. */
export async function bundled(entry, texts = {}) {
  const { outputFiles, metafile } = await build({
    absWorkingDir: folder,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["chrome109", "firefox115", "safari16"],
    charset: "utf8",
    legalComments: "inline",
    metafile: true,
    plugins: [{
      name: "texts",
      setup({ onResolve, onLoad }) {
        onResolve({ filter: /^taut:/ }, ({ path }) => ({ path, namespace: "texts" }));
        onLoad({ filter: /.*/, namespace: "texts" }, ({ path }) => ({ contents: texts[path], loader: "text" }));
      },
    }],
  });
  // Within a script element a script must not end it, nor open what changes its mode.
  const script = outputFiles[0].text.trim().replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
  return { script, metafile };
}

/** Style sheets, one after the other. */
export async function styleOf(...names) {
  const sheets = await Promise.all(names.map((name) => readFile(here(name), "utf8")));
  return (await transform(sheets.join("\n"), { loader: "css", minify: true })).code.trim();
}

/** taut's licence, and those of the packages in bundles. */
export async function licencesOf(...bundles) {
  const folders = new Set(bundles.flatMap(({ metafile }) => packagesIn(metafile)).map((name) => folder + name));
  return [{ packages: ["taut"], text: (await readFile(here("../LICENSE"), "utf8")).trim() }, ...(await noticesOf([...folders]))];
}
