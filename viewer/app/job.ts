// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// A job: its files, what was set, and what came out, in one file that can be saved and mailed.

import { Unzip, UnzipInflate } from "fflate";
import { turnedCsv } from "../src/as_made";
import { isNotes, type Notes } from "../src/notes";
import type { Plan } from "../src/result";

export type Role = "net" | "edges" | "supports" | "law" | "survey" | "control" | "forces" | "frequencies" | "sag" | "later" | "turned" | "target" | "tensions" | "check" | "adjustable" | "none";

/** What roles are called, and the option that gives such a file to a command. */
export const roles: Record<Role, { label: string; command?: string; option?: string }> = {
  net: { label: "net" },
  edges: { label: "edges of the net", command: "import", option: "--edges" },
  supports: { label: "list of supports", command: "import", option: "--supports" },
  law: { label: "tension law: strain, stress", command: "import", option: "--stress-strain" },
  survey: { label: "survey" },
  control: { label: "control points", command: "identify", option: "--control" },
  forces: { label: "force measurements", command: "identify", option: "--forces" },
  frequencies: { label: "frequencies of cables", command: "identify", option: "--frequencies" },
  sag: { label: "points on sagging cables", command: "identify", option: "--sag" },
  later: { label: "later survey" },
  turned: { label: "turned before the next survey" },
  target: { label: "target form", command: "plan", option: "--target" },
  tensions: { label: "target tensions", command: "plan", option: "--target-tension" },
  check: { label: "later loads to check", command: "plan", option: "--check" },
  adjustable: { label: "edges that may be turned", command: "plan", option: "--adjustable" },
  none: { label: "not used" },
};

export interface Input {
  role: Role;
  bytes: Uint8Array;
  /** Files whose roles this one's changed when it took its own: they get these again when it takes another. */
  displaced?: { name: string; role: Role }[];
}

export interface Job {
  inputs: Map<string, Input>;
  settings: Record<string, string>;
  /** Written by the program, by their names. */
  outputs: Record<string, Uint8Array>;
  /** Written by hand on the reports. */
  notes: Notes;
  /** The settings that a result was made with, by its file. */
  madeWith?: Record<string, string> | undefined;
}

const format = "taut-job";
export const netFile = "net.json";
/** What another program's net was imported to. */
export const importedFile = "imported.json";
export const resultFile = "result.json";
export const planFile = "plan.json";
export const turnsFile = "turns.csv";
/** The largest file that the program reads. */
const largest = 256 * 2 ** 20;

export const newJob = (): Job => ({ inputs: new Map(), settings: {}, outputs: {}, notes: {} });

function base64Of(bytes: Uint8Array): string {
  const part = 0x8000;
  let text = "";
  for (let i = 0; i < bytes.length; i += part) text += String.fromCharCode(...bytes.subarray(i, i + part));
  return btoa(text);
}

const bytesOf = (base64: string): Uint8Array => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));

export const text = (bytes: Uint8Array | undefined): string => new TextDecoder().decode(bytes);

export const jobText = ({ inputs, settings, outputs, notes, madeWith }: Job): string => JSON.stringify({
  format,
  version: 1,
  inputs: [...inputs].map(([name, { role, bytes }]) => ({ name, role, content: base64Of(bytes) })),
  settings,
  outputs: Object.entries(outputs).map(([name, bytes]) => ({ name, content: base64Of(bytes) })),
  notes,
  madeWith,
});

interface JobFile {
  format: string;
  version: number;
  inputs: { name: string; role: Role; content: string }[];
  settings: Record<string, string>;
  outputs: { name: string; content: string }[];
  notes?: Notes;
  madeWith?: Record<string, string>;
}

/** A JSON document's format; none of other files. */
function formatOf(name: string, bytes: Uint8Array): string | null {
  if (!name.toLowerCase().endsWith(".json")) return null;
  try {
    return String((JSON.parse(text(bytes)) as { format?: unknown } | null)?.format ?? "");
  } catch {
    return null;
  }
}

function isJobFile(file: JobFile): boolean {
  const isText = (value: unknown): boolean => typeof value === "string";
  const isFile = (one: { name: string; content: string } | null): boolean => isText(one?.name) && isText(one?.content);
  return Array.isArray(file.inputs) && file.inputs.every((input) => isFile(input) && Object.hasOwn(roles, input.role)) &&
    Array.isArray(file.outputs) && file.outputs.every(isFile) &&
    typeof file.settings === "object" && file.settings !== null && Object.values(file.settings).every(isText);
}

/** The job in a file; null where that is another. Throws where it is a later version or broken. */
export function readJob(name: string, bytes: Uint8Array): Job | null {
  if (formatOf(name, bytes) !== format) return null;
  const file = JSON.parse(text(bytes)) as JobFile;
  // Of a page before this one.
  for (const output of file.outputs ?? []) if (output?.name === netFile && file.inputs?.every?.((input) => input?.name !== netFile)) output.name = importedFile;
  if (file.version !== 1) throw new Error(`${name} is a job of version ${String(file.version)}, expected 1`);
  if (file.outputs?.some?.((output) => !isMade(output?.name) || (file.inputs?.some?.((input) => input?.name === output.name) ?? true))) {
    throw new Error(`${name} is not a whole job: its outputs are not those of this page`);
  }
  if (!isJobFile(file)) throw new Error(`${name} is not a whole job: expected inputs, settings and outputs as this page saves them`);
  try {
    return {
      inputs: new Map(file.inputs.map(({ name, role, content }) => [name, { role, bytes: bytesOf(content) }])),
      settings: file.settings,
      outputs: Object.fromEntries(file.outputs.map(({ name, content }) => [name, bytesOf(content)])),
      notes: isNotes(file.notes) ? file.notes : {},
      madeWith: typeof file.madeWith === "object" && file.madeWith !== null ? file.madeWith : undefined,
    };
  } catch {
    throw new Error(`${name} is not a whole job: a file in it is not in base64`);
  }
}

/** Whether a net must be imported first. */
export const isForeign = (name: string, bytes: Uint8Array): boolean => formatOf(name, bytes) !== "taut-net";

/** The first file of a role. */
export const namedIn = ({ inputs }: Job, role: Role): string | undefined => [...inputs].find(([, input]) => input.role === role)?.[0];

/** The plan that was made; without turns where there is none. */
export function madePlan({ outputs }: Job): Pick<Plan, "turns" | "warnings"> {
  if (!outputs[planFile]) return { turns: [] };
  let plan: Plan | null = null;
  try {
    plan = JSON.parse(text(outputs[planFile])) as Plan | null;
  } catch {
    // Said below.
  }
  if (!Array.isArray(plan?.turns)) throw new Error("the plan of this job is damaged: make it anew");
  return plan;
}

const isZip = (bytes: Uint8Array): boolean => text(bytes.subarray(0, 4)) === "PK\x03\x04";

/** The first rows of an Excel file's sheets, as CSV without empty cells; empty where it is damaged, of which the program says what is wrong. */
function rowsOf(bytes: Uint8Array): string {
  const mostBytes = 2 ** 24;
  const mostRows = 50;
  // Split and stripped in time that grows with the text alone, whatever stands in it.
  const plain = (xml: string): string => xml.replace(/<[^<>]*>/g, "").replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&amp;/g, "&");
  const parts = (xml: string, tag: string): string[] => xml.split(`</${tag}>`).slice(0, -1).map((part) => part.slice(Math.max(0, part.lastIndexOf(`<${tag}`))));
  const unpacked = new Map<string, Uint8Array[]>();
  let size = 0;
  const unzip = new Unzip((file) => {
    if (!/sharedStrings|worksheets\/[^/]+$/.test(file.name)) return;
    const chunks: Uint8Array[] = [];
    unpacked.set(file.name, chunks);
    file.ondata = (error, data) => {
      if (error) throw error;
      size += data.length;
      chunks.push(data);
    };
    file.start();
  });
  unzip.register(UnzipInflate);
  try {
    // In parts, as what the archive says of sizes may be wrong.
    const part = 2 ** 14;
    for (let i = 0; i < bytes.length && size < mostBytes; i += part) unzip.push(bytes.subarray(i, i + part), i + part >= bytes.length);
    const files = [...unpacked].map(([name, chunks]) => [name, chunks.map(text).join("")] as const);
    const shared = files.filter(([name]) => name.includes("sharedStrings")).flatMap(([, xml]) => parts(xml, "si").map(plain));
    const cell = (xml: string): string => (/^<c\b[^<>]*\bt="s"/.test(xml) ? shared[Number(plain(xml))] ?? "" : plain(xml));
    return files.filter(([name]) => !name.includes("sharedStrings"))
      .flatMap(([, xml]) => parts(xml, "row").slice(0, mostRows))
      .map((row) => parts(row, "c").map(cell).join(",")).join("\n");
  } catch {
    return "";
  }
}

/** What a file may be for; throws for results, which the page makes itself. Of surveys the first is the net as built, and any other a later one. */
export function guessedRole(name: string, bytes: Uint8Array, job: Job): Role {
  if (name.toLowerCase().endsWith(".ply")) return "target";
  if (/\.obj$/i.test(name)) return ![undefined, name].includes(namedIn(job, "net")) ? "target" : "net";
  const known = formatOf(name, bytes);
  if (known?.startsWith("taut-") && known !== "taut-net") throw new Error(`${name} is a ${known} file, expected a net, a survey or a job: results are made here`);
  if (known !== null) return "net";
  if (name.toLowerCase().endsWith(".json")) throw new Error(`${name} is no whole JSON file: is it cut off?`);
  const table = isZip(bytes) ? rowsOf(bytes) : text(bytes.subarray(0, 100_000));
  const head = table.slice(0, 2000);
  if (/\bstroke(_mm)?\b/.test(head)) return "turned";
  if (/^\s*edge\W+tension\W+tolerance\b/m.test(head)) return "tensions";
  if (/^\s*edge\W+tension\b/m.test(head)) return "forces";
  if (/^\s*edge\W+frequency\b/m.test(head)) return "frequencies";
  if (/^\s*edge\W+x\W+y\W+z\b/m.test(head)) return "sag";
  if (/^\s*strain\W+stress\b/m.test(head)) return "law";
  if (/^.*\bz\b.*\bis_free\b/m.test(head)) return "net";
  if (/^(?!.*\bx\b).*\b(q|q0|qopt|l0|EA)\b/m.test(head.split("\n", 1)[0]!)) return "edges";
  // What has no three numbers in a row of a table holds no points.
  if (/\.(csv|txt|tsv|asc|xyz|pts|xlsx)$/i.test(name) && table && !/(^|[\s,;])[-+]?[.\d][\d.,e+-]*[\s,;]+[-+]?[.\d][\d.,e+-]*[\s,;]+[-+]?[.\d]/m.test(table)) return "none";
  const isLater = job.outputs[planFile] || namedIn(job, "later") !== undefined || namedIn(job, "turned") !== undefined;
  return namedIn(job, "survey") !== undefined && isLater ? "later" : "survey";
}

/** A name that no other file has: two surveys are often called the same. */
function freeName(job: Job, name: string): string {
  const [, stem, ending] = /^(.*?)(\.[^.]*)?$/.exec(name) as unknown as [string, string, string?];
  let free = name;
  for (let i = 2; job.inputs.has(free) || isMade(free); ++i) free = `${stem}-${i}${ending ?? ""}`;
  return free;
}

/** Whether the program writes a file of that name. */
export const isMade = (name: string): boolean => [importedFile, resultFile, planFile, turnsFile, "report.html", "result_draws.h5"].includes(name);

/** Turns that are ticked off become a file; nothing where there are none. @param before what it comes before, or the end */
export function fileMade(job: Job, role: Role, before?: string): string | undefined {
  const turned = turnedCsv(madePlan(job), job.notes.strokes);
  delete job.notes.strokes;
  if (turned === null) return undefined;
  const after = [...job.inputs];
  const place = before === undefined ? after.length : after.findIndex(([name]) => name === before);
  const name = freeName(job, "turned.csv");
  after.splice(place, 0, [name, { role, bytes: new TextEncoder().encode(turned) }]);
  job.inputs = new Map(after);
  return name;
}

/** Roles of which a job has many files; of the others it has one, the last. */
const many: Role[] = ["later", "turned", "check", "none"];

/** Gives a file its role. What is ticked off counts as turned before a later survey, unless a file says what was. */
export function setRole(job: Job, name: string, role: Role): void {
  const input = job.inputs.get(name)!;
  if (input.role === role) return;
  for (const before of input.displaced ?? []) {
    const other = job.inputs.get(before.name);
    // Unless it, or another file, has a role since.
    const isFree = many.includes(before.role) || [undefined, name].includes(namedIn(job, before.role));
    if (isFree && other?.role === (before.role === "none" ? "turned" : "none")) other.role = before.role;
  }
  const displaced: Input["displaced"] = [];
  if (!many.includes(role)) {
    for (const [other, one] of job.inputs) {
      if (other === name || one.role !== role) continue;
      displaced.push({ name: other, role });
      one.role = "none";
    }
  }
  input.role = role;
  if (role === "later") {
    const before = [...job.inputs].slice(0, [...job.inputs.keys()].indexOf(name)).map(([, one]) => one.role);
    const made = before.lastIndexOf("turned") <= before.lastIndexOf("later") ? fileMade(job, "turned", name) : undefined;
    if (made !== undefined) displaced.push({ name: made, role: "none" });
  }
  input.displaced = displaced;
}

/**
 * A file that comes again takes the place of the old one, unless it is another survey.
 * @param isNext whether a survey is one after the turns
 */
export function addFile(job: Job, name: string, bytes: Uint8Array, isNext = false): void {
  const safe = name.replace(/[:/\\]/g, "_").replace(/^-/, "_");
  const guessed = guessedRole(safe, bytes, job);
  // Beside lengths a table of points may be a target or loads as well. The next survey has a place of its own.
  const isUnsure = ["survey", "later"].includes(guessed) && !isNext && job.outputs[resultFile] !== undefined && job.inputs.get(safe)?.role !== "survey";
  const role = isUnsure ? "none" : guessed === "survey" && isNext && namedIn(job, "survey") !== undefined ? "later" : guessed;
  const own = role === "later" || role === "turned" || isMade(safe) ? freeName(job, safe) : safe;
  job.inputs.delete(own);
  job.inputs.set(own, { role: "none", bytes });
  setRole(job, own, role);
}

/** Options that give files of other roles to a command. */
export const roleWords = ({ inputs }: Job, command: string): string[] =>
  [...inputs].flatMap(([name, { role }]) => (roles[role].command === command ? [roles[role].option!, name] : []));

/** The later surveys, each with what was turned before it: the file that stands before it, or else the one behind all. */
export function epochsOf({ inputs }: Job): { epochs: { survey: string; turned: string }[]; rest: string } {
  const epochs: { survey: string; turned: string }[] = [];
  let turned = "";
  for (const [name, { role }] of inputs) {
    if (role === "turned") {
      if (turned) throw new Error(`${turned} and ${name} both are what was turned before the same survey: put them into one file, or set one to "${roles.none.label}"`);
      turned = name;
    }
    if (role !== "later") continue;
    epochs.push({ survey: name, turned });
    turned = "";
  }
  const last = epochs.at(-1);
  if (last === undefined || last.turned || !turned) return { epochs, rest: turned };
  last.turned = turned;
  return { epochs, rest: "" };
}

/** Options that give the later surveys. */
export function epochWords(job: Job): string[] {
  const { epochs, rest } = epochsOf(job);
  if (rest) throw new Error(`${rest} is what was turned before a later survey, which is missing: drop it, or set ${rest} to "${roles.none.label}"`);
  return epochs.flatMap(({ survey, turned }) => ["--epoch", turned ? `${survey}:${turned}` : survey]);
}

/** A file's content under a name without folders. Throws for one that the program would refuse. */
export async function contentOf(file: File): Promise<Uint8Array> {
  if (file.size > largest) throw new Error(`${file.name} has ${Math.round(file.size / 2 ** 20)} MiB, expected at most ${largest / 2 ** 20}`);
  return new Uint8Array(await file.arrayBuffer());
}
