// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Runs the program once on files in memory. Each run has a worker of its own: ending it cancels the run
// and gives its memory back.

import { ConsoleStdout, Directory, File, type Inode, OpenFile, PreopenDirectory, WASI, WASIProcExit } from "@bjorn3/browser_wasi_shim";
import type { Message, Task } from "./messages";

const post = (message: Message, transfer: Transferable[] = []): void => self.postMessage(message, { transfer });

/** What is written to a stream, as text. */
function collector(onText: (text: string) => void): ConsoleStdout {
  const decoder = new TextDecoder();
  return new ConsoleStdout((bytes) => onText(decoder.decode(bytes, { stream: true })));
}

/** Where the program goes back to the start of its line, to show its progress there. */
const restart = "\r\x1b[K";

/** Standard error without lines of progress, which are followed by another or by nothing. */
const withoutProgress = (text: string): string =>
  text.split(restart).map((part, i, parts) => (i > 0 && !part.includes("\n") && i < parts.length - 1 ? "" : part)).join("");

/** Files of a folder and those below it that were not given: what the program writes takes the place of others. */
function written(folder: Map<string, Inode>, given: Set<Inode>, prefix = ""): [string, Uint8Array][] {
  return [...folder].flatMap(([name, entry]): [string, Uint8Array][] => {
    if (entry instanceof Directory) return written(entry.contents, given, `${prefix}${name}/`);
    return entry instanceof File && !given.has(entry) ? [[prefix + name, entry.data]] : [];
  });
}

async function run({ module, args, files }: Task): Promise<void> {
  let out = "";
  let err = "";
  let shown = "";
  const inputs = new Map(Object.entries(files).map(([name, bytes]) => [name, new File(bytes)]));
  const root = new PreopenDirectory("/", new Map(inputs));
  const wasi = new WASI(["taut", ...args], ["TAUT_PROGRESS=1"], [
    new OpenFile(new File([])),
    collector((text) => { out += text; }),
    collector((text) => {
      err += text;
      const line = err.slice(err.lastIndexOf(restart) + restart.length);
      if (err.includes(restart) && line && line !== shown && !line.includes("\n")) post({ kind: "progress", line: (shown = line) });
    }),
    root,
  ], { debug: false });
  let code = 1;
  try {
    const instance = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: wasi.wasiImport });
    code = wasi.start(instance as unknown as Parameters<WASI["start"]>[0]);
  } catch (error) {
    if (error instanceof WASIProcExit) code = error.code;
    // Where memory or the stack ends, the program does.
    else if (!err.includes("taut: error: ")) err += `taut: error: the program ended: ${error instanceof Error ? error.message : String(error)}\n`;
  }
  const outputs = written(root.dir.contents, new Set(inputs.values()));
  post({ kind: "done", run: { code, out, err: withoutProgress(err), files: Object.fromEntries(outputs) } },
    [...new Set(outputs.map(([, bytes]) => bytes.buffer as ArrayBuffer))]);
}

self.addEventListener("message", ({ data }: MessageEvent<Task>) => void run(data));
