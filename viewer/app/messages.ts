// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

export interface Task {
  module: WebAssembly.Module;
  args: string[];
  files: Record<string, Uint8Array>;
}

/** What a run of the program gave. */
export interface Run {
  /** Its exit code, as on the command line. */
  code: number;
  /** Standard output, and standard error without lines of progress. */
  out: string;
  err: string;
  /** What it wrote. */
  files: Record<string, Uint8Array>;
}

export type Message = { kind: "progress"; line: string } | { kind: "done"; run: Run };
