#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes a survey with all that a survey can have wrong at once, as worst_case.csv.

Usage: taut example hilo-quarter -o net.json
       taut form net.json --prior uniform:5mm --seed 7 -o form.csv
       make_worst_case.py form.csv [FOLDER]

A German table in Latin-1: decimal commas, millimetres, columns in another order and more of them,
lines of text, a station, points without coordinates, every tenth point measured twice, a grid's own
frame, every fourth target under a name of the surveyor's. Noise of 0.5 mm on every coordinate. Five
targets are wrong: 30 and 41 have each other's name, 97, 150 and 233 were knocked off by 50 mm.
"""

import csv
import math
import random
import sys
from pathlib import Path

FREE = 300
NOISE = 0.5e-3
SWAPPED = {"30": "41", "41": "30"}
KNOCKED = {"97": (0.0, 0.0, 0.05), "150": (0.03, 0.04, 0.0), "233": (-0.03, 0.0, -0.04)}


def in_grid(x, y, z):
    """Turned about the plumb line and moved to where a national grid has it."""
    c, s = math.cos(0.6), math.sin(0.6)
    return c * x - s * y + 3456789.0, s * x + c * y + 5401234.0, z + 287.5


def comma(value):
    return f"{1e3 * value:.2f}".replace(".", ",")


def lines(points, dice):
    yield "Seilnetz Süd;;;;;;"
    yield "Aufmaß vom 3. Mai, Instrument 2;;;;;;"
    yield ""
    yield "Lfd. Nr.;Höhe [mm];Pkt-Nr;Rechtswert [mm];Hochwert [mm];Code;Bemerkung"
    number = 0
    for name, place in points:
        number += 1
        free = int(name) < FREE
        if free and number % 25 == 0:
            yield f"{number};;{name};;;Folie;verdeckt"
            continue
        if number == 30:
            yield f"{number};{comma(289.1)};S1;{comma(3456780.0)};{comma(5401230.0)};Stand;Standpunkt"
        shown = SWAPPED.get(name, name)
        own = free and number % 4 == 1 and name not in SWAPPED and name not in KNOCKED
        if own:
            shown = f"M{1000 + number}"
        off = KNOCKED.get(name, (0.0, 0.0, 0.0))
        for _ in range(2 if number % 10 == 0 else 1):
            x, y, z = in_grid(*(p + o + dice.gauss(0.0, NOISE) for p, o in zip(place, off)))
            yield f"{number};{comma(z)};{shown};{comma(x)};{comma(y)};Folie;"


def main():
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    with open(sys.argv[1], encoding="utf-8") as file:
        points = [(row["id"], tuple(float(row[axis]) for axis in "xyz"))
                  for row in csv.DictReader(file)]
    dice = random.Random(5)
    dice.shuffle(points)
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else Path(__file__).parent)
    text = "\r\n".join(lines(points, dice)) + "\r\n"
    (folder / "worst_case.csv").write_bytes(text.encode("latin-1"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
