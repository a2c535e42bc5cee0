#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes epochs_reference.json: three surveys of a small net, between which edges were turned with and without play,
and the lengths that SciPy identifies from all of them at once, for tests/identification.

    /usr/bin/python3 tests/data/make_epochs_reference.py

Made with Debian 12's python3-scipy 1.10.1. One least squares problem over the lengths and the play of every turn, with
derivatives by differences of exact equilibria: there is no filter, no information matrix and no formula of the library.
"""

import json
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

from make_plan_reference import DENSITY, EDGES, FREE, STIFFNESS, S, T, equilibrium, form_found

LAW, NOISE, PLAY = 3e-3, 0.4e-3, 0.8e-3
# By epoch: strokes of the adjustable edges (by their order) and their play.
TURNS = [{}, {0: (8e-3, 0.0), 3: (-6e-3, PLAY)}, {3: (4e-3, PLAY), 5: (-7e-3, PLAY)}]
HIDDEN = [[2], [7, 8], []]


def main():
    design = form_found()
    spans = np.linalg.norm(design[S] - design[T], axis=1)
    nominal = spans / (1 + DENSITY * spans / STIFFNESS)
    interior = np.flatnonzero(FREE[S] & FREE[T])
    adjustable = np.flatnonzero(~(FREE[S] & FREE[T]))
    plays = [(k, j) for k, turned in enumerate(TURNS) for j, (_, play) in turned.items() if play > 0]

    def forms(unknowns):
        """Of all epochs; unknowns: deviations of interior edges, errors of the turns, both in their standard
        deviations."""
        lengths = nominal.copy()
        lengths[interior] += LAW * unknowns[:len(interior)]
        result, form = [], design
        for k, turned in enumerate(TURNS):
            for j, (stroke, _) in turned.items():
                lengths[adjustable[j]] += stroke
                if (k, j) in plays:
                    lengths[adjustable[j]] += PLAY * unknowns[len(interior) + plays.index((k, j))]
            form, _ = equilibrium(lengths, form)
            result.append(form)
        return result

    random = np.random.default_rng(11)
    truth = random.normal(size=len(interior) + len(plays))
    free = np.flatnonzero(FREE)
    surveyed = [np.setdiff1d(free, free[hidden]) for hidden in HIDDEN]
    surveys = [form + NOISE * random.normal(size=form.shape) for form in forms(truth)]

    def residuals(unknowns):
        misfits = [((form - survey)[seen] / NOISE).ravel()
                   for form, survey, seen in zip(forms(unknowns), surveys, surveyed)]
        return np.concatenate([*misfits, unknowns])

    found = least_squares(residuals, np.zeros(len(truth)), xtol=1e-12, ftol=1e-12, gtol=1e-12)
    rates = np.array([(residuals(found.x + step) - residuals(found.x - step)) / 2e-3
                      for step in 1e-3 * np.eye(len(found.x))]).T
    covariance = np.linalg.inv(rates.T @ rates)
    reference = {
        "nodes": design.tolist(), "supports": np.flatnonzero(~FREE).tolist(), "edges": EDGES.tolist(),
        "axial_stiffness": STIFFNESS, "nominal": nominal.tolist(), "law": LAW, "noise": NOISE,
        "epochs": [{"form": survey.tolist(), "surveyed": seen.tolist(),
                    "turned": [{"edge": int(adjustable[j]), "stroke": stroke, "std": play}
                               for j, (stroke, play) in turned.items()]}
                   for survey, seen, turned in zip(surveys, surveyed, TURNS)],
        "deviations": (LAW * found.x[:len(interior)]).tolist(),
        "stds": (LAW * np.sqrt(np.diag(covariance))[:len(interior)]).tolist(),
        "last_form": forms(found.x)[-1].tolist(),
    }
    path = Path(__file__).with_name("epochs_reference.json")
    path.write_text(json.dumps(reference, indent=1) + "\n")
    error = LAW * (found.x - truth)[:len(interior)]
    print(f"{path.name}: {len(interior)} lengths from {len(surveys)} surveys, RMSE {1e3 * np.sqrt((error**2).mean()):.3f} "
          f"mm, standard deviations {1e3 * min(reference['stds']):.3f} to {1e3 * max(reference['stds']):.3f} mm")


if __name__ == "__main__":
    main()
