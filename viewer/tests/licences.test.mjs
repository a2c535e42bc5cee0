// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a page with code of a package whose licence is not in it.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { markup, noticesOf, packagesIn } from "../licences.mjs";

const folder = mkdtempSync(join(tmpdir(), "taut-licences-"));
after(() => rmSync(folder, { recursive: true, force: true }));

test("a package without a licence is named, and the page not made", async () => {
  writeFileSync(join(folder, "package.json"), JSON.stringify({ name: "bare", version: "1.2.3" }));
  await assert.rejects(noticesOf([folder]), /code of bare 1\.2\.3 is in the bundle, expected a file LICENSE or COPYING/);
  writeFileSync(join(folder, "NOTICE"), "thanks");
  await assert.rejects(noticesOf([folder]), /bare/);
  writeFileSync(join(folder, "License.txt"), "Copyright <me> & others\n");
  assert.equal(markup(await noticesOf([folder])), "<h3>bare 1.2.3</h3>\n<pre>Copyright &lt;me&gt; &amp; others\n\nthanks</pre>");
});

test("packages are those with code in the output, in folders of others too", () => {
  const inputs = { "src/main.ts": 9, "node_modules/a/x.js": 3, "node_modules/a/y.js": 1, "node_modules/none/x.js": 0, "node_modules/a/node_modules/@s/b/x.js": 2 };
  const metafile = { outputs: { out: { inputs: Object.fromEntries(Object.entries(inputs).map(([file, bytesInOutput]) => [file, { bytesInOutput }])) } } };
  assert.deepEqual(packagesIn(metafile), ["node_modules/a", "node_modules/a/node_modules/@s/b"]);
});
