# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against an Excel file that taut and an independent program, openpyxl, read differently."""

import numpy as np
import openpyxl
import pytest
import taut


def workbook(columns):
    """The columns as a sheet behind a cover."""
    book = openpyxl.Workbook()
    book.active.append(["Survey of the net"])
    sheet = book.create_sheet("points")
    sheet.append(["id", "x [m]", "y [m]", "z [m]", "sx [m]", "sy [m]", "sz [m]"])
    for row in zip(*columns.values(), strict=True):
        sheet.append([row[0], *map(float, row[1:])])
    return book


def test_a_sheet_is_the_survey_to_all_digits_that_openpyxl_writes(net, columns, tmp_path):
    workbook(columns).save(tmp_path / "survey.xlsx")
    of_sheet = taut.read_survey(net, tmp_path / "survey.xlsx")
    of_columns = taut.read_survey(net, columns)
    assert of_sheet.form == pytest.approx(of_columns.form, rel=1e-15, abs=0.0)  # %.16g
    assert np.array_equal(of_sheet.noise_std, of_columns.noise_std)
    assert of_sheet.notes[0] == "read as Excel sheet 'points', in m by the file"


def test_the_list_of_turns_opens_as_numbers(found, tmp_path):
    plan = taut.plan(found, stroke=0.02, turn=2e-3, step=0.25, thread="right")
    plan.save(tmp_path / "plan.json", csv=tmp_path / "turns.csv")
    assert taut.write_xlsx(tmp_path / "plan.json", tmp_path / "turns.xlsx") == plan.warnings
    sheet = openpyxl.load_workbook(tmp_path / "turns.xlsx")["turns"]
    # Warnings stand above the table.
    lines = (tmp_path / "turns.csv").read_text().splitlines()[len(plan.warnings) :]
    rows = list(sheet.iter_rows(values_only=True))[len(plan.warnings) :]
    assert ",".join(rows[0]) == lines[0]
    assert len(rows) == len(lines)
    for row, line in zip(rows[1:], lines[1:], strict=True):
        for cell, field in zip(row, line.split(","), strict=True):
            assert cell == (field or None) or cell == pytest.approx(float(field), abs=5.001e-4)
    head = len(plan.warnings) + 1
    assert (sheet.freeze_panes, sheet.print_title_rows) == (f"A{head + 1}", f"${head}:${head}")
    assert (sheet.page_setup.orientation, sheet.page_setup.paperSize) == ("landscape", 9)


def test_edges_and_nodes_open_as_tables(net, found, tmp_path):
    found.save(tmp_path / "result.json")
    taut.write_xlsx(tmp_path / "result.json", tmp_path / "result.xlsx")
    book = openpyxl.load_workbook(tmp_path / "result.xlsx")
    assert book.sheetnames == ["edges", "nodes"]
    rows = {row[0]: row for row in book["edges"].iter_rows(values_only=True)}
    for edge, deviation in zip(found.edge, found.length_deviation, strict=True):
        assert rows[int(edge)][5] == pytest.approx(1e3 * deviation, rel=1e-12)
    nodes = list(book["nodes"].iter_rows(min_row=2, values_only=True))
    assert np.array([row[2:5] for row in nodes]) == pytest.approx(np.array(found.form), abs=1e-12)
    net.save(tmp_path / "net.json")
    with pytest.raises(ValueError, match="format: is 'taut-net'"):
        taut.write_xlsx(tmp_path / "net.json", tmp_path / "net.xlsx")
