// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// A job: its files, what was set, and what came out, in one file that can be saved and mailed.

export type Role = "net" | "survey" | "target" | "none";

export interface Input {
  role: Role;
  bytes: Uint8Array;
}

export interface Job {
  inputs: Map<string, Input>;
  settings: Record<string, string>;
  /** Written by the program, by their names. */
  outputs: Record<string, Uint8Array>;
}

const format = "taut-job";
/** The largest file that the program reads. */
const largest = 256 * 2 ** 20;

export const newJob = (): Job => ({ inputs: new Map(), settings: {}, outputs: {} });

function base64Of(bytes: Uint8Array): string {
  const part = 0x8000;
  let text = "";
  for (let i = 0; i < bytes.length; i += part) text += String.fromCharCode(...bytes.subarray(i, i + part));
  return btoa(text);
}

const bytesOf = (base64: string): Uint8Array => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));

export const jobText = ({ inputs, settings, outputs }: Job): string => JSON.stringify({
  format,
  version: 1,
  inputs: [...inputs].map(([name, { role, bytes }]) => ({ name, role, content: base64Of(bytes) })),
  settings,
  outputs: Object.entries(outputs).map(([name, bytes]) => ({ name, content: base64Of(bytes) })),
});

interface JobFile {
  format: string;
  version: number;
  inputs: { name: string; role: Role; content: string }[];
  settings: Record<string, string>;
  outputs: { name: string; content: string }[];
}

/** A JSON document's format; none of other files. */
function formatOf(name: string, bytes: Uint8Array): string | null {
  if (!name.toLowerCase().endsWith(".json")) return null;
  try {
    return String((JSON.parse(new TextDecoder().decode(bytes)) as { format?: unknown } | null)?.format ?? "");
  } catch {
    return null;
  }
}

/** The job in a file; null where that is another. Throws where it is a later version. */
export function readJob(name: string, bytes: Uint8Array): Job | null {
  if (formatOf(name, bytes) !== format) return null;
  const file = JSON.parse(new TextDecoder().decode(bytes)) as JobFile;
  if (file.version !== 1) throw new Error(`${name} is a job of version ${String(file.version)}, expected 1`);
  return {
    inputs: new Map(file.inputs.map(({ name, role, content }) => [name, { role, bytes: bytesOf(content) }])),
    settings: file.settings,
    outputs: Object.fromEntries(file.outputs.map(({ name, content }) => [name, bytesOf(content)])),
  };
}

/** Whether a net must be imported first. */
export const isForeign = (name: string, bytes: Uint8Array): boolean => formatOf(name, bytes) !== "taut-net";

/** What a file may be for. */
export function guessedRole(name: string, bytes: Uint8Array, hasNet: boolean): Role {
  if (name.toLowerCase().endsWith(".ply")) return "target";
  if (/\.obj$/i.test(name)) return hasNet ? "target" : "net";
  return formatOf(name, bytes) === null ? "survey" : "net";
}

/** A file's content under a name without folders. Throws for one that the program would refuse. */
export async function contentOf(file: File): Promise<Uint8Array> {
  if (file.size > largest) throw new Error(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB, expected at most ${largest / 2 ** 20}`);
  return new Uint8Array(await file.arrayBuffer());
}
