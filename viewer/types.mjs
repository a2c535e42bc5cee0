// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Makes src/result_schema.ts, the types of a saved result, from the schema: node types.mjs
// With --check it fails where the file is another, and writes nothing.

import { readFile, writeFile } from "node:fs/promises";
import { compile } from "json-schema-to-typescript";

const target = new URL("src/result_schema.ts", import.meta.url);
const schema = JSON.parse(await readFile(new URL("../src/results/result.schema.json", import.meta.url), "utf8"));
const types = await compile(schema, "Result", {
  additionalProperties: false,
  bannerComment: "// SPDX-FileCopyrightText: 2026 The taut authors\n// SPDX-License-Identifier: MIT\n//\n// Made by types.mjs from src/results/result.schema.json: change that, then `npm run types`.",
  style: { printWidth: 120 },
});
if (process.argv[2] !== "--check") {
  await writeFile(target, types);
} else if ((await readFile(target, "utf8")) !== types) {
  console.error("src/result_schema.ts is not what src/results/result.schema.json gives, expected the output of: npm run types");
  process.exit(1);
}
