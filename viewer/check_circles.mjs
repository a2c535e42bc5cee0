// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Fails where sources import each other in a circle, types included: node check_circles.mjs [FOLDER]

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const folder = process.argv[2] ?? new URL("src", import.meta.url).pathname;
const imports = new Map(readdirSync(folder).filter((name) => name.endsWith(".ts")).map((name) =>
  [name.slice(0, -3), [...readFileSync(join(folder, name), "utf8").matchAll(/^(?:import|export|\}).* from "\.\/([^"]+)"/gm)].map((match) => match[1])]));

/** Prints a circle that a chain of imports runs into. */
function visit(name, chain) {
  const start = chain.indexOf(name);
  if (start >= 0) {
    console.error(`imports in a circle: ${[...chain.slice(start), name].map((part) => `${part}.ts`).join(" -> ")}, expected none`);
    process.exit(1);
  }
  for (const next of imports.get(name) ?? []) visit(next, [...chain, name]);
}
for (const name of imports.keys()) visit(name, []);
