// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The way of a site visit: files, what taut read, lengths, turns.

import { byId, h, section } from "../src/dom";
import { counted } from "../src/format";
import { type Notes, withNotes } from "../src/notes";
import { plainTable } from "../src/plain_table";
import type { Identification } from "../src/result";
import { Frames } from "./frames";
import {
  importedFile, addFile, contentOf, epochsOf, epochWords, fileMade, guessedRole, isForeign, isMade, type Job, jobText, madePlan, namedIn, netFile, newJob, planFile, readJob, resultFile, type Role, roles, roleWords,
  setRole, text, turnsFile,
} from "./job";
import { Cancelled, module, run } from "./program";
import { fields as settingFields, forceSettings, identifySettings, importSettings, inFields, planSettings, readingWords, type Setting, shown, suggestSettings, wordsOf } from "./settings";
import { keep, keptJob } from "./store";
import { Work } from "./work";

/** More free nodes than this take minutes and over a gigabyte in a browser. */
const manyNodes = 2000;

let job: Job = newJob();
const named = (role: Role): string | undefined => namedIn(job, role);

async function keepNow(): Promise<void> {
  clearTimeout(keeping);
  const state = await keep(job);
  byId("kept").className = state === "kept" ? "quiet" : "problem";
  byId("kept").textContent = {
    kept: "This browser keeps the job, also when the page is closed.",
    other: "Another tab of this page keeps its job here since, so this browser no longer keeps this one: save it before you close this tab.",
    nothing: "This browser keeps nothing of this page: save the job before you close it.",
  }[state];
}

let keeping = 0;
const drawsFile = "result_draws.h5";
/** What settings are now, in one text. */
const settingsNow = (of: Setting[][]): string => JSON.stringify(of.flat().map(({ option, key }) => job.settings[key ?? option] ?? ""));
const ofLengthSettings = [identifySettings, forceSettings, importSettings];
/** Says where results are of other settings than those of now. */
function markStale(): void {
  for (const [work, file, of] of [[identifying, resultFile, ofLengthSettings], [planning, planFile, [...ofLengthSettings, planSettings]]] as const) {
    const before = job.madeWith?.[file];
    work.markStale(job.outputs[file] !== undefined && before !== undefined && before !== settingsNow([...of]));
  }
}
/** Keeps the job in the browser a moment after a change. */
function changed(): void {
  clearTimeout(keeping);
  keeping = window.setTimeout(() => void keepNow(), 50);
}
addEventListener("pagehide", () => void keepNow());

function save(name: string, content: Uint8Array | string): void {
  const link = h("a", { href: URL.createObjectURL(new Blob([content as BlobPart])), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Everything that a command may read. */
const filesOf = (): Record<string, Uint8Array> => ({
  ...Object.fromEntries([...job.inputs].map(([name, { bytes }]) => [name, bytes])),
  ...job.outputs,
});

/** The net in taut's own format: the one that was dropped, or what it was imported to. */
function netName(): string {
  const name = named("net");
  if (name === undefined) throw new Error("There is no net yet: drop its file, or load the example.");
  return isForeign(name, job.inputs.get(name)!.bytes) ? importedFile : name;
}

const frames = new Frames(() => job.notes, (change: Notes) => {
  job.notes = { ...job.notes, ...change };
  showMade();
  changed();
});

/** The report of a result, and what can be saved of it. */
async function showReport(into: HTMLElement, result: string, signal: AbortSignal): Promise<void> {
  const isPlan = result === planFile;
  const report = await frames.show(into, result, job.outputs[result]!, isPlan ? ["project", "engineer", "strokes"] : ["project", "engineer"], signal);
  into.append(h("div", { class: "buttons no-print" },
    h("button", { type: "button", onclick: () => save(result.replace(/json$/, "html"), withNotes(text(report), job.notes)) }, "Save report"),
    h("button", { type: "button", onclick: () => save(result, job.outputs[result]!) }, "Save result"),
    isPlan ? h("button", { type: "button", onclick: () => frames.print(into) }, "Print the lists") : null,
    isPlan && job.outputs[turnsFile] ? h("button", { type: "button", onclick: () => save(turnsFile, job.outputs[turnsFile]!) }, "Save list of turns") : null,
    !isPlan && job.outputs[drawsFile] ? h("button", { type: "button", title: "A plan by the command line needs them beside the result.", onclick: () => save(drawsFile, job.outputs[drawsFile]!) }, "Save samples") : null,
    h("button", { type: "button", onclick: () => void attempt(() => saveForExcel(result)) }, "Save for Excel")));
  into.scrollIntoView({ block: "start" });  // in a frame that is not seen nothing is drawn
}

/** The tables of a result. */
async function saveForExcel(result: string): Promise<void> {
  const name = result === planFile ? "turns.xlsx" : "lengths.xlsx";
  const { code, err, files } = await run(["export", result, "--to", "xlsx", "-o", name], { [result]: job.outputs[result]! });
  if (code !== 0) throw new Error(err);
  save(name, files[name]!);
}

/** Runs a command whose outputs the job keeps. Exit code 1 comes with a result, unless there is none. */
async function command(work: Work, words: string[]): Promise<{ out: string; warnings: string[] }> {
  work.showCommand(shown(words));
  const { code, out, err, files } = await run(words, filesOf(), work);
  // What further options let the program write is no part of the job.
  for (const [name, bytes] of Object.entries(files)) {
    if (isMade(name)) job.outputs[name] = bytes;
    else save(name, bytes);
  }
  changed();
  work.showOutput(out, err);
  if (code !== 0 && Object.keys(files).length === 0) throw new Error(inFields(err.trim()) || `the program ended with ${code}`);
  return { out, warnings: [...err.matchAll(/^taut: warning: (.*)$/gm)].map(([, warning]) => inFields(warning!)) };
}

/** Another program's net, with what is set for it now. */
async function importNet(work: Work): Promise<void> {
  const name = named("net");
  if (name === undefined || netName() === name) return;
  await command(work, ["import", name, ...roleWords(job, "import"), "-o", importedFile, ...wordsOf(importSettings, job.settings)]);
}

const lastSurvey = (): string | undefined => [...job.inputs].filter(([, { role }]) => role === "later").at(-1)?.[0] ?? named("survey");

/** Options of inspect that give the last survey, and what is set of it. */
function surveyWords(survey: string, taken: string[]): string[] {
  const control = named("control");
  const noise = job.settings["--noise"] === "estimate" ? {} : { "--noise": job.settings["--noise"] ?? "" };  // from a fit alone
  return ["--survey", survey, ...(control ? ["--control", control] : []),
    ...wordsOf(identifySettings.filter(({ option }) => taken.includes(option)), { ...job.settings, "--noise": "", ...noise }),
    ...readingWords(wordsOf(identifySettings.filter(({ isWords }) => isWords), job.settings))];
}

async function read(work: Work): Promise<string> {
  await importNet(work);
  const survey = lastSurvey();
  const { out, warnings } = await command(work, ["inspect", netName(), ...(survey === undefined ? [] : surveyWords(survey, ["--noise", "--unit", "--frame", "--offset"]))]);
  const nodes = Number(/^net .*: (\d+) free node/m.exec(out)?.[1] ?? 0);
  byId("size").textContent = nodes > manyNodes
    ? `This net has ${nodes} free nodes. In a browser it may take minutes and more memory than there is. taut for Linux does the same with the same files, and faster.` : "";
  return [...(survey === undefined ? ["The survey is still missing."] : []), ...warnings.map((warning) => `Warning: ${warning}.`)].join(" ");
}

interface Suggestions {
  quantity: string;
  mean_tension: number | null;
  std: number;
  steps: { kind: string; id: string; expected?: number | null; measurement_std?: number | null; remaining_std: number }[];
  left_out: string[];
}

/** Which measurements besides the survey would show most. */
async function suggest(work: Work): Promise<string> {
  const survey = lastSurvey();
  if (survey === undefined) throw new Error("There is no survey yet: drop its file.");
  await importNet(work);
  byId("suggestions").replaceChildren();
  const forces = named("forces");
  const { out } = await command(work, ["inspect", netName(), ...surveyWords(survey, ["--noise", "--unit", "--frame", "--offset", "--prior", "--uncertain"]),
    ...(forces ? ["--forces", forces, ...wordsOf(forceSettings, job.settings)] : []), ...wordsOf(suggestSettings, { ...job.settings, "--suggest": job.settings["--suggest"] || "mean-tension" }), "--json"]);
  const { quantity, mean_tension: mean, std, steps, left_out } = (JSON.parse(out) as { survey: { suggestions: Suggestions } }).survey.suggestions;
  const [factor, unit] = quantity === "form" ? [1e3, "mm"] : mean ? [100 / mean, "%"] : [1e-3, "kN"];
  const amount = (value: number | null | undefined, kind: string): string =>
    value == null ? "–" : kind === "frequency" ? `${value.toPrecision(3)}\u00a0Hz` : ["load-cell", "load"].includes(kind) ? `${(value / 1e3).toPrecision(3)}\u00a0kN` : `${(1e3 * value).toPrecision(3)}\u00a0mm`;
  byId("suggestions").replaceChildren(plainTable("Measurements that would show most", ["measure", "at", "expected", "to within", `std left [${unit}]`],
    steps.map(({ kind, id, expected, measurement_std, remaining_std }) => [kind.replace("-", " "), id, amount(expected, kind), amount(measurement_std, kind), (factor * remaining_std).toPrecision(3)])),
  ...(steps.length === 0 ? ["Nothing that can be measured lowers it by 1 %."] : []).map((text) => h("p", {}, text)),
  ...(named("frequencies") ?? named("sag") ? ["The measured frequencies and sags are not taken into account."] : []).map((text) => h("p", { class: "quiet" }, text)),
  ...left_out.map((text) => h("p", { class: "quiet" }, `Not suggested: ${text}.`)));
  return `Standard deviation of the ${quantity.replace("-", " ")} now: ${(factor * std).toPrecision(3)} ${unit}${unit === "%" ? " of the mean tension" : ""}.`;
}

const ticks = (): number => (job.notes.strokes ?? []).filter((stroke) => stroke !== null).length;

/** A plan or lengths that are made anew know nothing of turns without a survey after them. */
const mayForgetTicks = (): boolean => ticks() === 0 || confirm(`${counted(ticks(), "turn")} ticked off, and no survey after them: this would start from the net before these turns. They stay among the files, as turned.csv. Go on?`);

/** Forgets results from lengths or turns on. Turns that were ticked off stay, as a file that is not used. */
function forget(from: "lengths" | "turns"): void {
  const count = job.inputs.size;
  fileMade(job, "none");
  if (job.inputs.size > count) showFiles();
  for (const name of from === "lengths" ? [resultFile, planFile, turnsFile] : [planFile, turnsFile]) delete job.outputs[name];
  for (const id of from === "lengths" ? ["lengths", "turns"] : ["turns"]) byId(id).replaceChildren();
  showMade();
}

async function identify(work: Work): Promise<string> {
  netName();
  const survey = named("survey");
  if (survey === undefined) throw new Error("There is no survey yet: drop its file.");
  if (!mayForgetTicks()) throw new Cancelled();
  forget("lengths");
  planning.clear();
  const epochs = epochWords(job);
  job.madeWith = { [resultFile]: settingsNow(ofLengthSettings) };
  await importNet(work);
  const { out, warnings } = await command(work, ["identify", netName(), survey, ...epochs, ...roleWords(job, "identify"), ...(named("forces") ? wordsOf(forceSettings, job.settings) : []), ...wordsOf(identifySettings, job.settings), "-o", resultFile]);
  await showReport(byId("lengths"), resultFile, work.signal);
  return [/^Checks: \w+\./m.exec(out)?.[0] ?? "", ...warnings.map((warning) => `Warning: ${warning}.`)].join(" ");
}

async function plan(work: Work): Promise<string> {
  if (!job.outputs[resultFile]) throw new Error("Identify first: a plan starts from the lengths.");
  if (!mayForgetTicks()) throw new Cancelled();
  forget("turns");
  job.madeWith = { ...job.madeWith, [planFile]: settingsNow([...ofLengthSettings, planSettings]) };
  const { warnings } = await command(work, ["plan", netName(), resultFile, ...roleWords(job, "plan"), ...wordsOf(planSettings, job.settings), "-o", planFile, "--csv", turnsFile]);
  await showReport(byId("turns"), planFile, work.signal);
  showMade();
  return [planOutcome(), ...warnings.map((warning) => `Warning: ${warning}.`)].join(" ");
}

function planOutcome(): string {
  const { turns, warnings } = madePlan(job);
  return warnings?.[0] ?? `${counted(turns.length, "turn")}.`;
}

const reading = new Work("Read again", read);
const suggesting = new Work("Suggest measurements", suggest);
const identifying = new Work("Identify", identify);
const planning = new Work("Plan", plan);

function showFiles(): void {
  const list = [...job.inputs].map(([name, input]) => h("li", {},
    h("code", {}, name),
    h("select", {
      "aria-label": `What ${name} is`,
      onchange: ({ target }: Event) => {
        if (mayForgetAll()) { setRole(job, name, (target as HTMLSelectElement).value as Role); filesChanged(); } else { showFiles(); }
      },
    }, ...Object.entries(roles).map(([role, { label }]) => h("option", { value: role, selected: role === input.role }, label))),
    h("button", { type: "button", onclick: () => { if (input.role === "none" || mayForgetAll()) { job.inputs.delete(name); filesChanged(); } } }, "Remove")));
  byId("files").replaceChildren(...list);
  const net = named("net");
  byId("force-settings").hidden = named("forces") === undefined;
  byId("import").hidden = net === undefined || !isForeign(net, job.inputs.get(net)!.bytes);
}

/** What comes after the turns: how many are ticked off, and the surveys after them. */
function showMade(): void {
  const { turns } = madePlan(job);
  const later = epochsOf(job).epochs.map(({ survey, turned }) =>
    turned ? `${survey} was surveyed after what ${turned} says was turned.` : `${survey} counts as surveyed with nothing turned before it: where something was, drop a file of it, too.`);
  const now = turns.length > 0
    ? `${ticks()} of ${turns.length} turns are ticked off in the list above. Turn, survey again, and drop the next survey here: what is ticked off counts as turned before it.`
    : job.outputs[planFile] ? "The plan turns nothing." : later.length > 0 ? "Identify again." : "Make a plan first. Its list of turns is ticked off in its report.";
  byId("made").textContent = [...later, now].join(" ");
}

/** Ends what belongs to other files. */
let ofFiles = new AbortController();

/** The files that are used: those for plans alone, or those that lengths depend on. */
const used = (isForPlans: boolean): unknown[] =>
  [...job.inputs].filter(([, { role }]) => role !== "none" && (roles[role].command === "plan") === isForPlans).flatMap(([name, { role, bytes }]) => [name, role, bytes]);

/** Those of the last results. */
let ofLengths: unknown[] = [];
let ofPlans: unknown[] = [];

const areSame = (now: unknown[], before: unknown[]): boolean => now.length === before.length && now.every((one, i) => one === before[i]);

/** Results of other files are gone. */
function filesChanged(): void {
  const [lengths, plans] = [used(false), used(true)];
  const [hasSameLengths, hasSamePlans] = [lengths.length > 0 && areSame(lengths, ofLengths), areSame(plans, ofPlans)];
  [ofLengths, ofPlans] = [lengths, plans];
  if (hasSameLengths) {
    if (!hasSamePlans) {
      forget("turns");
      planning.clear();
    }
    showFiles();
    changed();
    return;
  }
  ofFiles.abort();
  ofFiles = new AbortController();
  forget("lengths");
  job.outputs = {};
  byId("suggestions").replaceChildren();
  for (const work of [reading, suggesting, identifying, planning]) work.clear();
  showFiles();
  changed();
  if (named("net") !== undefined) void reading.start();
}

/** Does something with files, and shows why it failed. */
async function attempt(work: () => Promise<void>): Promise<void> {
  const problem = byId("problem");
  problem.textContent = "";
  try {
    await work();
  } catch (error) {
    if (error instanceof Cancelled) return;
    problem.textContent = error instanceof Error ? error.message : String(error);
  }
}

async function take(files: Iterable<File>, isNext: boolean): Promise<void> {
  const read: [string, Uint8Array][] = [];
  for (const file of files) {
    const bytes = await contentOf(file);
    const opened = readJob(file.name, bytes);
    if (opened) return mayForgetAll() ? open(opened) : undefined;
    read.push([file.name, bytes]);
  }
  // What was turned comes before the survey after it.
  const isTurned = ([name, bytes]: [string, Uint8Array]): boolean => guessedRole(name, bytes, job) === "turned";
  for (const [name, bytes] of [...read.filter(isTurned), ...read.filter((one) => !isTurned(one))]) addFile(job, name, bytes, isNext);
  filesChanged();
  const unused = [...job.inputs].filter(([, { role, bytes }]) => role === "none" && read.some(([, one]) => one === bytes)).map(([name]) => name);
  if (unused.length > 0) throw new Error(`${unused.join(", ")}: not used yet. Choose in the list what it is.`);
}

async function open(opened: Job): Promise<void> {
  // What begins anew on its files forgets results, and what was written on them.
  job = { ...opened, outputs: {}, notes: {} };
  delete job.madeWith;
  showSettings();
  filesChanged();
  const { outputs } = opened;
  Object.assign(job, { outputs, notes: opened.notes, madeWith: opened.madeWith });
  const { signal } = ofFiles;
  try {
    // Of another plan.
    if (job.notes.strokes?.length !== madePlan(job).turns?.length) delete job.notes.strokes;
    if (outputs[resultFile]) {
      await showReport(byId("lengths"), resultFile, signal);
      identifying.showOutcome(`Checks: ${(JSON.parse(text(outputs[resultFile])) as Identification).trust?.verdict ?? "not made"}.`);
    }
    if (outputs[planFile]) {
      await showReport(byId("turns"), planFile, signal);
      planning.showOutcome(planOutcome());
    }
  } catch (error) {
    if (!signal.aborted) job.outputs = {};  // they are not what the program writes
    throw error;
  }
  showMade();
  markStale();
}

/** The built-in net, and a survey of it as it might be built. */
async function example(): Promise<void> {
  if (!mayForgetAll()) return;
  const { files: net } = await run(["example", "hilo-quarter", "-o", netFile]);
  const { files: built } = await run(["form", netFile, "--prior", "uniform:5mm", "--seed", "7", "-o", "built.csv"], net);
  const { files: survey } = await run(["survey", netFile, "built.csv", "--noise", "0.5mm", "--seed", "2", "-o", "survey.csv"], { ...net, ...built });
  job = newJob();
  Object.assign(job.settings, { "--noise": "0.5mm", "--prior": "uniform:5mm", "--draws": "200", "--tension": "0.05kN..20kN", "--turn": "5mm", "--step": "1/4", "--thread": "right" });
  for (const [name, bytes] of Object.entries({ ...net, ...survey })) addFile(job, name, bytes);
  showSettings();
  filesChanged();
}

function showSettings(): void {
  const fields = (settings: Setting[], values: Record<string, string>): HTMLElement => settingFields(settings, values, () => {
    changed();
    markStale();
    if (settings === suggestSettings) suggesting.markStale(byId("suggestions").hasChildNodes());
  });
  byId("import").replaceChildren(h("p", { class: "quiet" }, "The net is another program's. What its file does not say:"), fields(importSettings, job.settings));
  byId("force-settings").replaceChildren(fields(forceSettings, job.settings));
  byId("identify-settings").replaceChildren(fields(identifySettings, job.settings));
  byId("suggest-settings").replaceChildren(fields(suggestSettings, job.settings));
  byId("plan-settings").replaceChildren(fields(planSettings, job.settings));
}

/** A place for files: they are picked, or dropped on it. */
function dropPlace(id: string, title: string, hint: string): HTMLElement {
  const picker = h("input", { type: "file", multiple: true, id: `${id}-pick`, onchange: ({ target }: Event) => {
    const input = target as HTMLInputElement;
    const files = [...(input.files ?? [])];
    input.value = "";  // so that the same file can be picked again
    void attempt(() => take(files, id === "drop-next"));
  } });
  const place = h("label", { id, class: "drop", for: `${id}-pick` }, h("strong", {}, title), h("span", {}, hint), picker);
  for (const type of ["dragenter", "dragover"]) place.addEventListener(type, (event) => { event.preventDefault(); place.classList.add("over"); });
  for (const type of ["dragleave", "drop"]) place.addEventListener(type, () => place.classList.remove("over"));
  place.addEventListener("drop", (event) => { event.preventDefault(); const files = [...(event.dataTransfer?.files ?? [])]; void attempt(() => take(files, id === "drop-next")); });
  return place;
}

/** Whether results may be forgotten. */
const mayForgetAll = (): boolean => job.outputs[resultFile] === undefined || confirm("The results of this job, and what is ticked off, would be forgotten. Go on?");

function startAnew(): void {
  if (!mayForgetAll()) return;
  job = newJob();
  showSettings();
  filesChanged();
}

function build(): void {
  byId("app").replaceChildren(
    section("inputs", "1. Files", dropPlace("drop", "Drop a net and a survey here", "or pick files. They stay on this machine."), h("p", { id: "problem", class: "problem", role: "alert" }), h("ul", { id: "files" }), h("div", { id: "import", hidden: true }),
      h("div", { class: "buttons" },
        h("button", { type: "button", id: "example", onclick: () => void attempt(example) }, "Load the example"),
        h("button", { type: "button", id: "save-job", onclick: () => save("taut-job.json", jobText(job)) }, "Save this job"),
        h("button", { type: "button", id: "new-job", onclick: startAnew }, "New job")),
      h("p", { id: "kept", class: "quiet", role: "status" })),
    section("read", "2. What taut read", reading.element, h("p", { id: "size", class: "status", role: "status" }),
      h("details", { id: "suggest" }, h("summary", {}, "What else to measure, to know more of forces or form"), h("div", { id: "suggest-settings" }), suggesting.element, h("div", { id: "suggestions" }))),
    section("identification", "3. Lengths", h("div", { id: "identify-settings" }), h("div", { id: "force-settings", hidden: true }), identifying.element, h("div", { id: "lengths" })),
    section("planning", "4. Turns", h("div", { id: "plan-settings" }), planning.element, h("div", { id: "turns" })),
    section("next", "5. As made, and the next survey", h("p", { id: "made", role: "status" }), dropPlace("drop-next", "Drop the next survey here", "All surveys together determine the lengths; the next plan starts from the net as it is now.")));
  reading.expand();
  showSettings();
  showMade();
}

async function start(): Promise<void> {
  try {
    build();
    await module;
    const kept = await keptJob();
    if (kept && kept.inputs.size > 0) await attempt(() => open(kept));
    document.body.dataset.ready = "true";
  } catch (error) {
    byId("app").prepend(h("p", { class: "failure", role: "alert" }, `taut cannot run in this browser: ${error instanceof Error ? error.message : String(error)}`));
  }
}

Object.assign(window, { taut: { run, Cancelled } });
void start();
