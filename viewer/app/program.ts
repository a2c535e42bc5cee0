// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The program in the page: the command line of taut, on files in memory.

import workerSource from "taut:worker";
import { byId } from "../src/dom";
import type { Message, Run, Task } from "./messages";

/** A run that was cancelled. */
export class Cancelled extends Error {}

function decoded(base64: string): Uint8Array<ArrayBuffer> {
  // Newer browsers do it ten times as fast.
  const { fromBase64 } = Uint8Array as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> };
  if (fromBase64) return fromBase64.call(Uint8Array, base64);
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function compiled(): Promise<WebAssembly.Module> {
  const zipped = new Blob([decoded(byId("program").textContent ?? "")]);
  const program = new Response(zipped.stream().pipeThrough(new DecompressionStream("gzip")), { headers: { "Content-Type": "application/wasm" } });
  return WebAssembly.compileStreaming(program);
}

/** The program, compiled once. */
export const module = compiled();
module.catch(() => {});  // each run says so

const workerUrl = URL.createObjectURL(new Blob([workerSource], { type: "text/javascript" }));

export interface RunOptions {
  onProgress?: (line: string) => void;
  signal?: AbortSignal;
}

/**
 * Runs `taut args...` in a worker, on files by their names.
 * @throws Cancelled after signal.abort()
 */
export async function run(args: string[], files: Record<string, Uint8Array | string> = {}, options: RunOptions = {}): Promise<Run> {
  const encoder = new TextEncoder();
  const bytes = Object.entries(files).map(([name, content]) => [name, typeof content === "string" ? encoder.encode(content) : content]);
  const task: Task = { module: await module, args, files: Object.fromEntries(bytes) as Task["files"] };
  const { onProgress, signal } = options;
  const worker = new Worker(workerUrl);
  try {
    return await new Promise<Run>((done, fail) => {
      const cancel = (): void => fail(new Cancelled());
      if (signal?.aborted) cancel();
      signal?.addEventListener("abort", cancel);
      worker.onmessage = ({ data }: MessageEvent<Message>) => (data.kind === "done" ? done(data.run) : onProgress?.(data.line));
      worker.onerror = (event) => fail(new Error(event.message || "the worker of this page ended"));
      worker.postMessage(task);
    });
  } finally {
    worker.terminate();
  }
}
