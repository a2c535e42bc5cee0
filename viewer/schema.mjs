// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The schema of saved results, which the build writes. TAUT_RESULT_SCHEMA names it where it is in another build.

import { readFileSync } from "node:fs";

const built = new URL("../build/release/result.schema.json", import.meta.url);
export const schema = JSON.parse(readFileSync(process.env.TAUT_RESULT_SCHEMA ?? built, "utf8"));
