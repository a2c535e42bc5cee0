#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes station_reference.json: readings of three stations, and their least squares solution by
SciPy, for tests/survey.

    /usr/bin/python3 tests/data/make_station_reference.py

Made with Debian 12's python3-scipy 1.10.1. The residuals here are those of directions, zenith angles and distances
themselves; the covariance is that of all unknowns at once, less the rigid motions of all targets
that errors of the poses make.
"""

import json
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

GON = np.pi / 200
STATIONS = np.array([[0.0, 0.0, 0.0], [9.0, 2.0, 0.8], [4.0, -7.0, -0.5]])
ORIENTATIONS = np.array([0.0, 2.1, -0.7])
TARGETS = 24


def polar(place, pose):
    """Direction, zenith angle and distance of a prism from a station."""
    away = place - pose[:3]
    distance = np.linalg.norm(away)
    azimuth = np.arctan2(away[0], away[1])
    return np.array([azimuth + pose[3], np.arccos(away[2] / distance), distance])


def make_readings(random):
    targets = random.uniform([1, -6, -1], [8, 7, 4], (TARGETS, 3))
    # From all stations the first third; from the first and another the rest; some in two faces.
    readings = []
    for station in range(len(STATIONS)):
        pose = [*STATIONS[station], ORIENTATIONS[station]]
        for target in range(TARGETS):
            if station == 0 and target >= TARGETS - 2 or station > 0 and target % 3 and target % 2 == station - 1:
                continue
            for _ in range(2 if target % 7 == 0 else 1):
                height = 0.1 if target % 5 == 0 else 0.0
                exact = polar(targets[target] + [0, 0, height], pose)
                angle_std = (0.3 if station < 2 else 0.6) * 1e-3 * GON
                distance_std = 1e-3 + 1.5e-6 * exact[2]
                std = np.array([angle_std, angle_std, distance_std])
                direction, zenith, distance = exact + std * random.standard_normal(3)
                readings.append({
                    "station": station, "target": f"t{target}",
                    "direction": direction % (2 * np.pi), "zenith": zenith, "distance": distance,
                    "target_height": height, "angle_std": angle_std, "distance_std": distance_std})
    return readings


def without_motions(covariance, normal, places):
    """The part that is not by each target alone, with its rigid motions projected out."""
    alone = np.linalg.inv(normal)
    x, y, z = (places - places.mean(axis=0)).T
    zero = np.zeros_like(x)
    turns = np.stack([zero, z, -y, -z, zero, x, y, -x, zero], axis=1).reshape(-1, 3, 3)
    motions = np.concatenate([np.tile(np.eye(3), (len(places), 1)), turns.reshape(-1, 3)], axis=1)
    fit = np.linalg.solve(motions.T @ normal @ motions, motions.T @ normal)
    rest = np.eye(len(normal)) - motions @ fit
    return alone + rest @ (covariance - alone) @ rest.T


def solve(readings):
    names = list(dict.fromkeys(r["target"] for r in readings))
    count = [len({r["target"] for r in readings if r["station"] == s}) for s in range(len(STATIONS))]
    datum = int(np.argmax(count))
    others = [s for s in range(len(STATIONS)) if s != datum]

    def poses_of(x):
        poses = np.zeros((len(STATIONS), 4))
        poses[others] = x[:4 * len(others)].reshape(-1, 4)
        return poses

    def residuals(x):
        poses = poses_of(x)
        places = x[4 * len(others):].reshape(-1, 3)
        result = []
        for r in readings:
            prism = places[names.index(r["target"])] + [0, 0, r["target_height"]]
            e = polar(prism, poses[r["station"]]) - [r["direction"], r["zenith"], r["distance"]]
            e[0] = (e[0] + np.pi) % (2 * np.pi) - np.pi
            result.extend(e / [r["angle_std"], r["angle_std"], r["distance_std"]])
        return np.array(result)

    # From the truth, in the frame of the datum station.
    turn = ORIENTATIONS[datum]
    c, s = np.cos(turn), np.sin(turn)
    into = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    start = [[*(into @ (STATIONS[k] - STATIONS[datum])), ORIENTATIONS[k] - turn] for k in others]
    places = []
    for name in names:
        r = next(r for r in readings if r["target"] == name)
        k = r["station"]
        sine = np.sin(r["zenith"])
        azimuth = r["direction"] - ORIENTATIONS[k]
        place = STATIONS[k] + r["distance"] * np.array(
            [sine * np.sin(azimuth), sine * np.cos(azimuth), np.cos(r["zenith"])])
        places.append(into @ (place - STATIONS[datum]) - [0, 0, r["target_height"]])
    x0 = np.concatenate([np.ravel(start), np.ravel(places)])
    found = least_squares(residuals, x0, method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15)
    normal = found.jac.T @ found.jac
    first = 4 * len(others)
    covariance = np.linalg.inv(normal)
    covariance[first:, first:] = without_motions(
        covariance[first:, first:], normal[first:, first:], found.x[first:].reshape(-1, 3))
    redundancy = 3 * len(readings) - len(found.x)
    return {
        "datum": datum,
        "redundancy": redundancy,
        "noise_ratio": float(np.sqrt(2 * found.cost / redundancy)),
        "poses": poses_of(found.x).tolist(),
        "points": [{
            "target": name,
            "place": found.x[first + 3 * i:first + 3 * i + 3].tolist(),
            "covariance": covariance[first + 3 * i:first + 3 * i + 3,
                                     first + 3 * i:first + 3 * i + 3].ravel().tolist(),
        } for i, name in enumerate(names)],
    }


def main():
    readings = make_readings(np.random.default_rng(1))
    file = Path(__file__).with_name("station_reference.json")
    file.write_text(json.dumps({"readings": readings, **solve(readings)}, indent=1) + "\n",
                    encoding="utf-8")


if __name__ == "__main__":
    main()
