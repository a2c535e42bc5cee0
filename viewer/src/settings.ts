// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { section } from "./dom";
import { counted, millimetres, number, percent, short } from "./format";
import { plainTable } from "./plain_table";
import { type Identification, leftOut, type PlannedTension, type Result } from "./result";

/** The prior of the length deviations as given, and as estimated from the survey. */
function priorWords(prior: Identification["prior"]): string {
  if (!prior) return "";
  if (prior.exact) return `${prior.nodes[0]?.prior ?? ""}, exact`;
  const found = `estimated, standard deviation ${millimetres(prior.std)} ± ${millimetres(prior.std_std)} mm`;
  const common = prior.common && prior.common.mean_std > 0 ? `; mean of all ${millimetres(prior.common.mean)} ± ${millimetres(prior.common.mean_std)} mm` : "";
  const turnbuckles = prior.common?.adjustable_std ? `; adjustable edges ${millimetres(prior.common.adjustable ?? 0)} ± ${millimetres(prior.common.adjustable_std)} mm longer (mean)` : "";
  const struts = prior.common?.struts_std ? `; struts ${millimetres(prior.common.struts ?? 0)} ± ${millimetres(prior.common.struts_std)} mm longer than that (mean)` : "";
  const runs = prior.common && prior.common.run_probability > 0.5 ? `; scales of cable runs ${(100 * prior.common.run_std).toPrecision(2)} %` : "";
  return `${prior.given ?? "none given"}; ${found}${common}${struts}${turnbuckles}${runs}; uniform with a probability of ${percent(prior.uniform_probability)} %; mixture of ${counted(prior.nodes.length, "prior")}`;
}

const mostLimits = 6;

/** "0.05 to 20 kN (664 edges)", each different pair of limits once. */
function limitWords(edges: PlannedTension[]): string {
  const counts = new Map<string, number>();
  for (const { limit_lower, limit_upper } of edges) {
    const words = limit_lower === null ? (limit_upper === null ? "none" : `up to ${short(limit_upper / 1e3)} kN`)
      : limit_upper === null ? `${short(limit_lower / 1e3)} kN or more` : `${short(limit_lower / 1e3)} to ${short(limit_upper / 1e3)} kN`;
    counts.set(words, (counts.get(words) ?? 0) + 1);
  }
  const all = [...counts].map(([words, count]) => `${words} (${counted(count, "edge")})`);
  return all.slice(0, mostLimits).join("; ") + (all.length > mostLimits ? `; ${all.length - mostLimits} others` : "");
}

/** Program, input and options of the result, and its run time. */
export function settingsSection(result: Result): HTMLElement {
  const rows: [string, string][] = [];
  const add = (name: string, value: unknown): void => {
    if (value !== undefined && value !== null && value !== "") rows.push([name, String(value)]);
  };
  add("program", result.program);
  add("date", result.date);
  add("command", result.command);
  add("net", result.net.name);
  add("net fingerprint", result.net.fingerprint);
  if (result.format === "taut-study" || result.format === "taut-comparison") add("prior of the length deviations", result.prior);
  if (result.format === "taut-identification") add("most probable prior of the length deviations", result.length_prior);
  if (result.format === "taut-identification") add("prior of the length deviations", priorWords(result.prior));
  if (result.format === "taut-study" || result.format === "taut-comparison") add("seed", result.seed);
  if (result.format === "taut-study") {
    const { samples, seconds } = result;
    add("samples", samples.total);
    add("training samples", samples.training);
    add("validation samples", samples.validation);
    add("samples with slack edges", samples.with_slack);
    add("samples not converged", samples.not_converged);
    add("identified forms not converged", result.forms_not_converged);
    for (const stage of ["sampling", "training", "identification", "total"] as const) add(stage === "total" ? "total time" : `time, ${stage}`, `${number(seconds[stage])} s`);
  }
  if (result.format === "taut-comparison" && result.samples) {
    add("samples", result.samples.total);
    add("samples not converged", result.samples.not_converged);
    add("surveys per case", result.samples.surveyed);
    add("surveys with slack edges", result.samples.surveyed_with_slack);
    add("total time", result.seconds && `${number(result.seconds.total)} s`);
  }
  if (result.format === "taut-identification") {
    add("method", result.method);
    add("standard deviation of a coordinate (a priori)", result.noise === undefined ? "" : `${short(1e3 * result.noise)} mm`);
    if (result.frame === null) add("frame of the survey", "the net's");
    add("surveyed free nodes", result.survey.used);
    add("free nodes not surveyed", result.survey.missing);
    for (const one of result.uncertain ?? []) {
      if (one.edge === undefined && one.node === undefined) {
        const unit = one.unit === "1" ? "%" : one.unit;
        const scale = one.unit === "1" ? 100 : 1;
        const note = one.observed ? "" : "; no measurement determines it";
        add(`uncertain: ${one.given}`, `${number(Math.abs(one.mean) > 1e-6 * one.std ? scale * one.mean : 0)} ${unit} from the design, standard deviation ${number(scale * one.std)} ${unit}${note}`);
      }
    }
    const single = new Map<string, number>();
    for (const one of result.uncertain ?? []) if (one.edge !== undefined || one.node !== undefined) single.set(one.given, (single.get(one.given) ?? 0) + (one.observed ? 1 : 0));
    for (const [given, observed] of single) add(`uncertain: ${given}`, `${observed} of them determined better than a priori`);
    for (const one of result.stretches ?? []) add(`cable that slides, edges ${one.ids[0]} to ${one.ids[one.ids.length - 1]}`, `${number(1e3 * one.length_deviation)} mm from the design, standard deviation ${number(1e3 * one.std)} mm; ${number(1e-3 * one.tension)} kN, standard deviation ${number(1e-3 * one.tension_std)} kN`);
    const hung = (result.epochs ?? []).flatMap(({ load }, k) => (load ? [`${number(load * 1e-3)} kN at survey ${k + 1}`] : []));
    if (hung.length > 0) add("known loads hung on the net", hung.join(", "));
    if (result.forces && result.forces.measurements > 0) add("force measurements", `${result.forces.measurements}, ${leftOut(result.forces.outliers)} excluded`);
    if (result.draws) add("posterior samples", `${result.draws.count}: ${result.draws.how}`);
    if (result.draws?.reason) add("no tensions, because", result.draws.reason);
    if (result.mean_tension) {
      const { mean, lower, upper } = result.mean_tension;
      add("mean tension", `${number(mean / 1e3)} kN (95 %: ${number(lower / 1e3)} to ${number(upper / 1e3)} kN)`);
    }
  }
  if (result.format === "taut-plan") {
    const { options } = result;
    add("required probability of the limits", `${short(100 * options.confidence)} %`);
    add("limits of tension", limitWords(result.tension.edges));
    add("actuator std", `${short(1e3 * options.actuator)} mm`);
    add("change of length by one turn", options.pitch === null ? "not given" : `${short(1e3 * options.pitch)} mm`);
    add("smallest step", options.step ? `${short(1e3 * options.step)} mm` : "");
    add("tolerance along the normal", options.tolerance === null ? "" : `${short(1e3 * options.tolerance)} mm`);
    add("thread", options.thread === null ? "not given" : `${options.thread}-hand`);
    add("posterior samples", result.draws);
    add("no posterior samples, because", result.no_draws_because);
  }
  if (result.format === "taut-control") {
    const { settings } = result;
    const kN = (newton: number): string => `${short(newton / 1e3)} kN`;
    add("prior of the length deviations", settings.prior);
    add("uncertain parameters", settings.uncertain?.join(", ") || "none");
    add("standard deviation of a surveyed coordinate", `${short(1e3 * settings.noise)} mm`);
    add("free nodes not surveyed", `${short(100 * settings.hidden)} %`);
    add("actuator std", `${short(1e3 * settings.actuator)} mm`);
    add("stroke limit of a turnbuckle from its design length", `±${short(1e3 * settings.stroke)} mm`);
    add("smallest step", settings.step === null ? "any" : `${short(1e3 * settings.step)} mm`);
    const most = settings.most_tension === null ? "" : `, max ${kN(settings.most_tension)}`;
    add("tension limits", (settings.least_tension > 0 ? `min ${kN(settings.least_tension)}` : "no cable slack") + most);
    add("required probability of the limits, on identified lengths", `${short(100 * settings.confidence)} %`);
    add("posterior samples of each identification", settings.draws);
    add("rounds", settings.rounds);
    add("jobs", settings.trials);
    add("seed", settings.seed);
  }
  return section("settings", "Settings", plainTable("Settings", ["setting", "value"], rows, ["", "text"]));
}
