// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The way of a site visit: files, what taut read, lengths, turns.

import { byId, h, section } from "../src/dom";
import { contentOf, guessedRole, isForeign, type Job, jobText, newJob, readJob, type Role } from "./job";
import { Cancelled, module, run } from "./program";
import { fields, identifySettings, importSettings, planSettings, shown, wordsOf } from "./settings";
import { Work } from "./work";

const netFile = "net.json";
const resultFile = "result.json";
const planFile = "plan.json";
const turnsFile = "turns.csv";

let job: Job = newJob();
const text = (bytes: Uint8Array | undefined): string => new TextDecoder().decode(bytes);

function save(name: string, content: Uint8Array | string): void {
  const link = h("a", { href: URL.createObjectURL(new Blob([content as BlobPart])), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

const named = (role: Role): string | undefined => [...job.inputs].find(([, input]) => input.role === role)?.[0];

/** Everything that a command may read. */
const filesOf = (): Record<string, Uint8Array> => ({
  ...Object.fromEntries([...job.inputs].map(([name, { bytes }]) => [name, bytes])),
  ...job.outputs,
});

/** The net in taut's own format: the one that was dropped, or what it was imported to. */
function netName(): string {
  const name = named("net");
  if (name === undefined) throw new Error("There is no net yet: drop its file, or load the example.");
  return isForeign(name, job.inputs.get(name)!.bytes) ? netFile : name;
}

/** The report of a result in a frame of its own, which can reach neither this page nor anything else. */
async function showReport(into: HTMLElement, result: string): Promise<void> {
  const { code, stderr, files } = await run(["report", result, "-o", "report.html"], { [result]: job.outputs[result]! });
  const report = files["report.html"];
  if (code !== 0 || !report) throw new Error(stderr);
  into.replaceChildren(
    h("iframe", { srcdoc: text(report), sandbox: "allow-scripts allow-downloads allow-modals", title: `Report of ${result}` }),
    h("div", { class: "buttons no-print" },
      h("button", { type: "button", onclick: () => save(result.replace(/json$/, "html"), report) }, "Save report"),
      h("button", { type: "button", onclick: () => save(result, job.outputs[result]!) }, "Save result"),
      result === planFile ? h("button", { type: "button", onclick: () => save(turnsFile, job.outputs[turnsFile]!) }, "Save list of turns") : null));
  into.scrollIntoView({ block: "start" });  // in a frame that is not seen nothing is drawn
}

/** Runs a command whose outputs the job keeps. Exit code 1 comes with a result, unless there is none. */
async function command(work: Work, words: string[]): Promise<void> {
  work.showCommand(shown(words));
  const { code, stdout, stderr, files } = await run(words, filesOf(), work);
  Object.assign(job.outputs, files);
  work.showOutput(stdout, stderr);
  if (code !== 0 && Object.keys(files).length === 0) throw new Error(stderr.trim() || `the program ended with ${code}`);
}

async function read(work: Work): Promise<void> {
  const name = named("net");
  if (name !== undefined && netName() !== name) {
    await command(work, ["import", name, "-o", netFile, ...wordsOf(importSettings, job.settings)]);
  }
  const survey = named("survey");
  const taken = ["--noise", "--unit", "--frame", "--offset"];
  const words = survey === undefined ? [] : ["--survey", survey, ...wordsOf(identifySettings.filter(({ option }) => taken.includes(option)), job.settings)];
  await command(work, ["inspect", netName(), ...words]);
}

async function identify(work: Work): Promise<void> {
  const survey = named("survey");
  if (survey === undefined) throw new Error("There is no survey yet: drop its file.");
  for (const name of [resultFile, planFile, turnsFile]) delete job.outputs[name];
  for (const id of ["lengths", "turns"]) byId(id).replaceChildren();
  planning.clear();
  await command(work, ["identify", netName(), survey, ...wordsOf(identifySettings, job.settings), "-o", resultFile]);
  await showReport(byId("lengths"), resultFile);
}

async function plan(work: Work): Promise<void> {
  if (!job.outputs[resultFile]) throw new Error("Identify first: a plan starts from the lengths.");
  for (const name of [planFile, turnsFile]) delete job.outputs[name];
  byId("turns").replaceChildren();
  const target = named("target");
  const words = target === undefined ? [] : ["--target", target];
  await command(work, ["plan", netName(), resultFile, ...words, ...wordsOf(planSettings, job.settings), "-o", planFile, "--csv", turnsFile]);
  await showReport(byId("turns"), planFile);
}

const reading = new Work("Read again", read);
const identifying = new Work("Identify", identify);
const planning = new Work("Plan", plan);

const roles: Record<Role, string> = { net: "net", survey: "survey", target: "target form", none: "not used" };

function showFiles(): void {
  const list = [...job.inputs].map(([name, input]) => h("li", {},
    h("code", {}, name),
    h("select", {
      "aria-label": `What ${name} is`,
      onchange: ({ target }: Event) => { input.role = (target as HTMLSelectElement).value as Role; filesChanged(); },
    }, ...Object.entries(roles).map(([role, label]) => h("option", { value: role, selected: role === input.role }, label))),
    h("button", { type: "button", onclick: () => { job.inputs.delete(name); filesChanged(); } }, "Remove")));
  byId("files").replaceChildren(...list);
  const net = named("net");
  byId("import").hidden = net === undefined || !isForeign(net, job.inputs.get(net)!.bytes);
}

/** Results of other files are gone. */
function filesChanged(): void {
  job.outputs = {};
  for (const id of ["lengths", "turns"]) byId(id).replaceChildren();
  for (const work of [reading, identifying, planning]) work.clear();
  showFiles();
  if (named("net") !== undefined) void reading.start();
}

/** One role has one file: the last one. */
function add(name: string, bytes: Uint8Array): void {
  const role = guessedRole(name, bytes, named("net") !== undefined);
  for (const input of job.inputs.values()) if (input.role === role) input.role = "none";
  job.inputs.set(name, { role, bytes });
}

/** Does something with files, and shows why it failed. */
async function attempt(work: () => Promise<void>): Promise<void> {
  const problem = byId("problem");
  problem.textContent = "";
  try {
    await work();
  } catch (error) {
    problem.textContent = error instanceof Error ? error.message : String(error);
  }
}

async function take(files: Iterable<File>): Promise<void> {
  for (const file of files) {
    const bytes = await contentOf(file);
    const opened = readJob(file.name, bytes);
    if (opened) return open(opened);
    add(file.name, bytes);
  }
  filesChanged();
}

async function open(opened: Job): Promise<void> {
  job = opened;
  showSettings();
  const outputs = job.outputs;
  filesChanged();
  job.outputs = outputs;
  if (outputs[resultFile]) await showReport(byId("lengths"), resultFile);
  if (outputs[planFile]) await showReport(byId("turns"), planFile);
}

/** The built-in net, and a survey of it as it might be built. */
async function example(): Promise<void> {
  const { files: net } = await run(["example", "hilo-quarter", "-o", netFile]);
  const { files: built } = await run(["form", netFile, "--prior", "uniform:5mm", "--seed", "7", "-o", "built.csv"], net);
  const { files: survey } = await run(["survey", netFile, "built.csv", "--noise", "0.5mm", "--seed", "2", "-o", "survey.csv"], { ...net, ...built });
  job = newJob();
  Object.assign(job.settings, { "--noise": "0.5mm", "--prior": "uniform:5mm", "--draws": "200", "--tension": "0.05kN..20kN", "--turn": "5mm", "--step": "1/4", "--thread": "right" });
  for (const [name, bytes] of Object.entries({ ...net, ...survey })) add(name, bytes);
  showSettings();
  filesChanged();
}

function showSettings(): void {
  byId("import").replaceChildren(h("p", { class: "quiet" }, "The net is another program's. What its file does not say:"), fields(importSettings, job.settings));
  byId("identify-settings").replaceChildren(fields(identifySettings, job.settings));
  byId("plan-settings").replaceChildren(fields(planSettings, job.settings));
}

function build(): void {
  const picker = h("input", { type: "file", multiple: true, id: "pick", onchange: ({ target }: Event) => void attempt(() => take((target as HTMLInputElement).files ?? [])) });
  const drop = h("label", { id: "drop", for: "pick" }, h("strong", {}, "Drop a net and a survey here"), h("span", {}, "or pick files. They stay on this machine."), picker);
  for (const type of ["dragenter", "dragover"]) drop.addEventListener(type, (event) => { event.preventDefault(); drop.classList.add("over"); });
  for (const type of ["dragleave", "drop"]) drop.addEventListener(type, () => drop.classList.remove("over"));
  drop.addEventListener("drop", (event) => { event.preventDefault(); const files = [...(event.dataTransfer?.files ?? [])]; void attempt(() => take(files)); });

  byId("app").replaceChildren(
    section("inputs", "1. Files", drop, h("p", { id: "problem", class: "problem", role: "alert" }), h("ul", { id: "files" }), h("div", { id: "import", hidden: true }),
      h("div", { class: "buttons" },
        h("button", { type: "button", id: "example", onclick: () => void attempt(example) }, "Load the example"),
        h("button", { type: "button", id: "save-job", onclick: () => save("taut-job.json", jobText(job)) }, "Save this job"))),
    section("read", "2. What taut read", reading.element),
    section("identification", "3. Lengths", h("div", { id: "identify-settings" }), identifying.element, h("div", { id: "lengths" })),
    section("planning", "4. Turns", h("div", { id: "plan-settings" }), planning.element, h("div", { id: "turns" })));
  showSettings();
}

async function start(): Promise<void> {
  try {
    build();
    await module;
    document.body.dataset.ready = "true";
  } catch (error) {
    byId("app").prepend(h("p", { class: "failure", role: "alert" }, `taut cannot run in this browser: ${error instanceof Error ? error.message : String(error)}`));
  }
}

Object.assign(window, { taut: { run, Cancelled } });
void start();
