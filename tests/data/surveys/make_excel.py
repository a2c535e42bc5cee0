#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes the survey own.csv as an engineer's Excel file, excel.xlsx, by openpyxl, and the text that
its sheet stands for, excel.txt: each row on the line of its number.

A cover and a hidden sheet with another survey come first. The table starts in column B, below a title and
an empty row; its header has line breaks, and behind the coordinates is a date.

Usage: make_excel.py [FOLDER]
"""

import csv
import datetime
import sys
from pathlib import Path

from openpyxl import Workbook
from openpyxl.styles import Font


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent)
    with open(Path(__file__).parent / "own.csv", encoding="utf-8") as file:
        points = list(csv.DictReader(file))
    book = Workbook()
    cover = book.active
    cover.title = "Deckblatt"
    cover["A1"] = "Netz Süd"
    cover.append(["Stand", datetime.date(2026, 5, 3)])
    cover.append(["Blatt", 1, 2])
    old = book.create_sheet("alt")
    old.sheet_state = "hidden"
    sheet = book.create_sheet("Aufmaß & Lage")
    sheet["B1"] = 'Netz Süd, "Aufmaß"'
    sheet.merge_cells("B1:F1")
    header = ["Pkt-Nr", "Rechtswert\n[mm]", "Hochwert\n[mm]", "Höhe\n[mm]", "Datum"]
    for column, title in enumerate(header, 2):
        sheet.cell(3, column, title).font = Font(bold=True)
    lines = ['"Netz Süd, ""Aufmaß""",,,,', "",
             'Pkt-Nr,"Rechtswert [mm]","Hochwert [mm]","Höhe [mm]",Datum']
    for row, point in enumerate(points, 4):
        x, y, z = (round(1e4 * float(point[key])) / 10 for key in "xyz")
        values = [int(point["id"]), x, y, z]
        for column, value in enumerate(values, 2):
            sheet.cell(row, column, value).number_format = "0.0" if column > 2 else "0"
            old.cell(row, column, 0.5 if column > 2 else value)
        if row == 4:
            sheet.cell(row, 6, datetime.date(2026, 5, 3))
        lines.append(",".join(f"{value:g}" for value in values) + ("," if row > 4 else ",2026-05-03"))
    book.save(folder / "excel.xlsx")
    (folder / "excel.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
