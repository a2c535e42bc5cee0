// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { plainTable } from "./details";
import { h, section } from "./dom";
import { fixed } from "./format";
import type { Control, ControlRound } from "./result";

/** The rounds as the program tells them in the terminal. */
export function roundsSection(control: Control): HTMLElement {
  const { settings } = control;
  const kN = (newton: number): string => fixed(newton / 1e3, 2);
  const row = (name: string, round: ControlRound): (string | number)[] => [
    name, round.round,
    fixed(1e3 * round.mean, 2), fixed(1e3 * round.max, 1),
    fixed(1e3 * round.normal_mean, 2), fixed(1e3 * round.normal_max, 1), fixed(1e3 * round.normal_rmse, 2),
    kN(round.least_tension), kN(round.most_tension),
    `${round.broken_trials}/${settings.trials}`, round.broken_trials > 0 ? fixed(100 * round.worst_excess, 1) : "–",
    fixed(1e3 * round.turned, 1), round.failed,
  ];
  const rows = control.strategies.flatMap((s) =>
    s.rounds.slice(1, s.strategy === "design, once" ? 2 : undefined).map((round) => row(s.strategy, round)));
  return section("rounds", "All rounds",
    plainTable("All rounds, by what was planned on",
      ["planned on", "round", "from target, mean [mm]", "from target, max [mm]", "along normal, mean [mm]", "along normal, max [mm]", "along normal, RMS [mm]",
        "least tension [kN]", "most tension [kN]", "limits broken", "by at most [%]", "strokes [mm]", "not planned"],
      [row("as built", control.strategies[0]!.rounds[0]!), ...rows]),
    h("p", { class: "quiet" }, "Means are over nodes and jobs; largest distances, tensions and excess those of any job. “Design, once” stays as it is after its round. ",
      "The confidence with which limits are to hold applies to plans on identified lengths: the others know nothing of how sure they are."));
}
