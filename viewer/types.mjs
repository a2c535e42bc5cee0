// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Makes src/result_schema.ts, the types of a saved result, from the schema: node types.mjs
// Type checks need it, the bundle does not: types are not in it.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { compile } from "json-schema-to-typescript";
import { schema } from "./schema.mjs";

const target = new URL("src/result_schema.ts", import.meta.url);
const types = await compile(schema, "Result", {
  additionalProperties: false,
  bannerComment: "// SPDX-FileCopyrightText: 2026 The taut authors\n// SPDX-License-Identifier: MIT\n//\n// Made by types.mjs from the schema of saved results, and not committed.",
  style: { printWidth: 120 },
});
// A file that stays the same keeps its time, so that nothing is built again for it.
if (!existsSync(target) || readFileSync(target, "utf8") !== types) writeFileSync(target, types);
