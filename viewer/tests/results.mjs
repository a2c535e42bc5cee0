// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Makes results of every kind with the program, and reports of them, in a temporary folder.

import { execFileSync, spawnSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const program = process.env.TAUT_PROGRAM;
/** What the program says to words that it refuses; null where it takes them. */
export function refusalOf(...words) {
  const { status, stderr } = spawnSync(program, words, { cwd: folder, encoding: "utf8" });
  return status === 0 ? null : stderr;
}

export const folder = mkdtempSync(join(tmpdir(), "taut-viewer-"));

function taut(...words) {
  return execFileSync(program, words, { cwd: folder, encoding: "utf8" });
}

export function write(name, result) {
  writeFileSync(join(folder, `${name}.json`), JSON.stringify(result));
}

/** The report of a result in the folder: its path and the result. */
export function report(name) {
  taut("report", `${name}.json`, "-o", `${name}.html`);
  return { page: join(folder, `${name}.html`), result: JSON.parse(readFileSync(join(folder, `${name}.json`), "utf8")) };
}

/** A plan; one that cannot keep its limits is written, too, and the program ends with 1. */
function plan(name, ...words) {
  const { status, stderr } = spawnSync(program, ["plan", "net.json", ...words, "-o", `${name}.json`, "--quiet"], { cwd: folder, encoding: "utf8" });
  if (status !== 0 && status !== 1) throw new Error(stderr);
}

/** Plans in quarter turns by two crews, without limits that can be kept, without draws or pitch, and without a turn. */
function makePlans() {
  taut("form", "net.json", "--prior", "uniform:5mm", "--seed", "3", "-o", "built.csv");
  taut("survey", "net.json", "built.csv", "--noise", "0.2mm", "--seed", "2", "-o", "site.csv");
  const identify = ["identify", "net.json", "site.csv", "--noise", "0.2mm", "--prior", "uniform:5mm", "--quiet", "--draws"];
  taut(...identify, "50", "-o", "site.json");
  taut(...identify, "0", "-o", "drawless.json");
  // Target 8, a hand's breadth too high.
  const raised = readFileSync(join(folder, "site.csv"), "utf8").replace(/^(8,[^,]*,[^,]*,)([^,]*)/m, (_, before, z) => before + (Number(z) + 0.1));
  writeFileSync(join(folder, "raised.csv"), raised);
  taut("identify", "net.json", "raised.csv", "--noise", "0.2mm", "--prior", "uniform:5mm", "--quiet", "--draws", "0", "-o", "raised.json");
  plan("plan", "site.json", "--tension", "0.05kN..20kN", "--turn", "5mm", "--step", "1/4", "--crews", "2", "--thread", "left");
  plan("infeasible", "site.json", "--tension", "1N..200N", "--turn", "5mm", "--step", "1/4");
  plan("unsure", "drawless.json");
  plan("to_tensions", "site.json", "--target-tension", "1kN:1%");
  plan("idle", "site.json", "--tolerance", "50mm");
  return ["plan", "infeasible", "unsure", "to_tensions", "idle", "raised"];
}

/** Simulated jobs of two rounds; one job of one round; and the same where nothing could be planned. */
function makeJobs() {
  const control = ["control", "net.json", "--prior", "uniform:2mm", "--noise", "0.2mm", "--tension", "0.05kN..20kN", "--draws", "50", "--quiet"];
  taut(...control, "--rounds", "2", "--trials", "4", "-o", "jobs");
  taut(...control, "--rounds", "1", "--trials", "1", "-o", "job");
  const failed = JSON.parse(readFileSync(join(folder, "job/control.json"), "utf8"));
  for (const { rounds, states } of failed.strategies) {
    const { normal_rmse } = states[0];
    Object.assign(states[1], { normal_rmse, turned: 0, failed: true });
    Object.assign(rounds[1], { normal_rmse, turned: 0, failed: 1 });
  }
  write("failed", failed);
  return ["jobs/control", "job/control", "failed"];
}

/** What a survey with troubles gives: gross errors, hidden nodes, slack edges, targets of no node. */
function troubled(identification) {
  const result = structuredClone(identification);
  result.survey.residuals.forEach((r, i) => (r.standardised = [Math.sin(i), Math.cos(3 * i), Math.sin(7 * i)]));
  Object.assign(result.survey, {
    outliers: [{ node: 8, id: "8", distance: 0.0512, statistic: 5.25 }], outlier_threshold: 4.5, noise_ratio: 1.47,
    used: result.net.free_nodes - 2, missing: 2, missing_nodes: [9, 10],
    unmatched: [{ id: "T-900" }, { id: "<b>T-901</b>" }],
  });
  Object.assign(result.survey.residuals.find((r) => r.node === 8), { dx: 0, dy: 0.03, dz: 0.04 });
  Object.assign(result.diagnostics.noise, { ratio: 1.47, std: 0.1 });
  Object.assign(result.edges[0], { status: "slack", length_deviation: 0.08, lower: 0.0632, upper: 0.1 });
  result.edges[1].status = "unobserved";
  return result;
}

/** Names that would do harm where they were taken for markup. */
function hostile(identification) {
  const result = structuredClone(identification);
  const attack = "<img src=x onerror=\"window.harmed=1\"></script><script>window.harmed=1</script><!--";
  result.net.name = result.cable_net.name = attack;
  result.cable_net.node_ids = result.cable_net.nodes.map((_, i) => `${attack}${i}`);
  result.cable_net.edge_ids = result.cable_net.edges.map((_, e) => `=${attack}${e}`);
  for (const edge of result.edges) edge.id = result.cable_net.edge_ids[edge.edge];
  result.method = attack;
  return result;
}

/** Results that hold every key of the schema. */
function copyFullResults() {
  return ["study", "identification", "comparison", "plan", "control"].map((kind) => {
    const name = `full_${kind}`;
    copyFileSync(new URL(`../../tests/data/results/${name}.json`, import.meta.url), join(folder, `${name}.json`));
    return name;
  });
}

export function makeReports() {
  taut("example", "hypar:5x6", "-o", "net.json");
  const run = ["reproduce", "--net", "net.json", "--prior", "uniform:2mm", "--quiet"];
  taut(...run, "--samples", "60", "--validation", "5", "-o", "study", "--keep");
  taut(...run, "--samples", "30", "--validation", "1", "-o", "one");
  taut("form", "net.json", "-o", "survey.csv");
  taut("identify", "net.json", "survey.csv", "--model", "study/model.h5", "-o", "plain.json", "--quiet");
  taut("survey", "net.json", "survey.csv", "--noise", "0.2mm", "--frame", "random", "--seed", "3", "-o", "moved.csv");
  taut("identify", "net.json", "moved.csv", "--noise", "0.2mm", "--prior", "uniform:2mm", "--prior-exact", "-o", "moved.json", "--quiet");
  const plain = JSON.parse(readFileSync(join(folder, "plain.json"), "utf8"));
  const bare = structuredClone(plain);
  for (const key of ["residuals", "missing_nodes"]) delete bare.survey[key];
  for (const key of ["tension", "date", "command", "program", "length_prior", "frame"]) delete bare[key];
  write("bare", bare);
  write("troubled", troubled(plain));
  write("hostile", hostile(plain));
  taut("compare", "net.json", "-o", "comparison", "--prior", "uniform:2mm", "--noise", "0,0.1mm,0.5mm", "--training", "30,60", "--surveys", "4", "--quiet");
  return Object.fromEntries(["study/results", "one/results", "plain", "moved", "bare", "troubled", "hostile", "comparison/comparison", ...makePlans(), ...makeJobs(), ...copyFullResults()].map((name) => [name.split("/")[0], report(name)]));
}
