// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

import { h, section } from "./dom";
import { fixed } from "./format";
import { plainTable } from "./plain_table";
import type { Control, ControlRound } from "./result";

/** All rounds, as the program prints them. */
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
    plainTable("All rounds, by the lengths that were planned on",
      ["planned on", "round", "3D, mean [mm]", "3D, max [mm]", "normal, mean [mm]", "normal, max [mm]", "normal, RMS [mm]",
        "tension, min [kN]", "tension, max [kN]", "limits broken", "excess, max [%]", "strokes [mm]", "failed plans"],
      [row("as built", control.strategies[0]!.rounds[0]!), ...rows]),
    h("p", { class: "quiet" }, "3D and normal deviations are from the target. Means are over nodes and jobs; minima and maxima are those of any job. “Design, once” does not change after its round. ",
      "The required probability of keeping limits applies only to plans on identified lengths; the others have no uncertainty."));
}
