// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Measures the memory of the program as WebAssembly: node tests/app_memory.mjs PROGRAM.wasm NET
// Prints JSON: seconds and MiB of identifying and planning on a built-in net, as `taut example` names it, with
// the samples that are taken unless others are asked for. Such memory never shrinks, so what there is at
// the end is the most that a run held.

import { readFileSync } from "node:fs";
import { File, OpenFile, PreopenDirectory, WASI } from "@bjorn3/browser_wasi_shim";

const [program, net] = process.argv.slice(2);
const module = await WebAssembly.compile(readFileSync(program));
const root = new PreopenDirectory("/", new Map());

async function run(...words) {
  const said = new OpenFile(new File([]));
  const wasi = new WASI(["taut", ...words], [], [new OpenFile(new File([])), said, said, root], { debug: false });
  const instance = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: wasi.wasiImport });
  const start = performance.now();
  const code = wasi.start(instance);
  if (code !== 0) throw new Error(`taut ${words.join(" ")} ended with ${code}: ${new TextDecoder().decode(said.file.data)}`);
  return { seconds: (performance.now() - start) / 1e3, mebibytes: instance.exports.memory.buffer.byteLength / 2 ** 20 };
}

await run("example", net, "-o", "net.json");
await run("form", "net.json", "--prior", "uniform:5mm", "--seed", "7", "-o", "built.csv");
await run("survey", "net.json", "built.csv", "--noise", "0.5mm", "--seed", "2", "-o", "survey.csv");
console.log(JSON.stringify({
  identify: await run("identify", "net.json", "survey.csv", "--noise", "0.5mm", "--prior", "uniform:5mm", "-o", "result.json"),
  plan: await run("plan", "net.json", "result.json", "-o", "plan.json"),
}, null, 1));
