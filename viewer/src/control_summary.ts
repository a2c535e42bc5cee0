// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { counted, millimetres, number, percent } from "./format";
import type { Control, ControlRound, ControlStrategy } from "./result";
import { nameOf, netWords, priorWords, type Summary } from "./summary_words";

type Name = ControlStrategy["strategy"];

const on: Record<Name, string> = {
  "true lengths": "on the true lengths",
  identified: "on identified lengths",
  design: "on the design lengths",
  "design, once": "on the design lengths in the first round only",
};

const lastOf = (strategy: ControlStrategy): ControlRound => strategy.rounds.at(-1)!;
const builtOf = (control: Control): ControlRound => control.strategies[0]!.rounds[0]!;
const failuresOf = (strategy: ControlStrategy): number => strategy.rounds.reduce((sum, round) => sum + round.failed, 0);
const roundsWords = ({ settings }: Control): string => counted(settings.rounds, "round");

/** The strategy that the page is about. */
const mainOf = (control: Control): ControlStrategy => control.strategies.find((s) => s.strategy === "identified") ?? control.strategies[0]!;

/** All others; with one round, "design" and "design, once" are the same. */
const othersOf = (control: Control): ControlStrategy[] =>
  control.strategies.filter((s) => s !== mainOf(control) && !(control.settings.rounds === 1 && s.strategy === "design, once"));

const plansOf = ({ settings }: Control, { strategy }: ControlStrategy): number => settings.trials * (strategy === "design, once" ? 1 : settings.rounds);

/** Whether all plans failed, so that nothing was turned. */
const isIdle = (control: Control, strategy: ControlStrategy): boolean => failuresOf(strategy) === plansOf(control, strategy);

function formSentence(control: Control): string {
  const main = mainOf(control);
  const [before, after] = [builtOf(control).normal_rmse, lastOf(main).normal_rmse];
  const others = othersOf(control).map((s, i) => `${millimetres(lastOf(s).normal_rmse)} mm ${i === 0 ? "when planned " : ""}${on[s.strategy]}${isIdle(control, s) ? " (nothing turned)" : ""}`);
  const beside = others.length > 0 ? ` For comparison: ${others.join("; ")}.` : "";
  if (isIdle(control, main)) return `No plan ${on[main.strategy]} succeeded: the nets stay as built, ${millimetres(before)} mm from their target (RMS along the normal).${beside}`;
  const verb = `${after <= before ? "bring" : "take"}${control.settings.rounds === 1 ? "s" : ""}`;
  return `${roundsWords(control)} of turns planned ${on[main.strategy]} ${verb} the nets from ${millimetres(before)} mm to ${millimetres(after)} mm from their target (RMS along the normal).${beside}`;
}

function limitSentence(control: Control): string {
  const broken = (round: ControlRound): string => (round.broken_trials === 0 ? "none" : String(round.broken_trials));
  const after = [mainOf(control), ...othersOf(control)].map((s, i) => {
    const last = lastOf(s);
    const by = last.broken_trials > 0 ? ` (by up to ${percent(last.worst_excess)} % of the limit)` : "";
    return `in ${broken(last)}${i === 0 ? " planned" : ""} ${on[s.strategy]}${by}`;
  });
  return `Of ${counted(control.settings.trials, "job")}, limits are broken in ${broken(builtOf(control))} as built; after ${roundsWords(control)} ${after.join(", ")}.`;
}

function workSentence(control: Control): string {
  const main = mainOf(control);
  const turned = main.rounds.slice(1).map((round) => millimetres(round.turned));
  const last = turned.length > 1 ? ` and ${turned.at(-1)} mm in the last` : "";
  const work = isIdle(control, main) ? "" : `Planned ${on[main.strategy]}, all strokes of a job sum to ${turned[0]} mm in the first round${last}. `;
  const failed = control.strategies.filter((s) => failuresOf(s) > 0);
  if (failed.length === 0) return `${work}No identification or plan failed.`;
  const counts = failed.map((s) => `${failuresOf(s)} of ${counted(plansOf(control, s), "time")} ${on[s.strategy]}`).join(", ");
  return `${work}Identification or plan failed ${counts}. Nothing was turned then; these jobs count as they stand.`;
}

export function ofControl(control: Control): Summary {
  const { settings } = control;
  const main = mainOf(control);
  const [before, after] = [builtOf(control), lastOf(main)];
  const failures = control.strategies.reduce((sum, s) => sum + failuresOf(s), 0);
  const others = control.strategies.filter((s) => s !== main).map((s) => on[s.strategy]).join(", ");
  const uncertain = settings.uncertain?.length ? `. Each net has its own values of the uncertain parameters (${settings.uncertain.join(", ")})` : "";
  return {
    title: "Simulated rounds of survey, plan and turning",
    done:
      `${counted(settings.trials, "simulated job")} on the net ${nameOf(control.net)}: ${netWords(control.net)}. Lengths of interior cables deviate ` +
      `${priorWords(settings.prior)} from the design${uncertain}. Each job has ${roundsWords(control)}: a survey, a plan ${on[main.strategy]}, and its turns.` + (others ? ` For comparison, the same jobs are planned ${others}.` : ""),
    sentences: [formSentence(control), limitSentence(control), workSentence(control)],
    figures: [
      { value: `${number(1e3 * before.normal_rmse, 2)} → ${number(1e3 * after.normal_rmse, 2)}`, unit: "mm", label: `normal deviation from the target, RMS, planned ${on[main.strategy]}` },
      { value: `${before.broken_trials} → ${after.broken_trials}`, unit: `of ${settings.trials}`, label: `jobs with a broken limit, planned ${on[main.strategy]}` },
      { value: `${number(after.least_tension / 1e3)} – ${number(after.most_tension / 1e3)}`, unit: "kN", label: `tension after the last round, all jobs, planned ${on[main.strategy]}` },
      { value: String(failures), unit: "", label: "failed plans, all strategies" },
    ],
  };
}
