#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Draws docs/images/rooms.svg: which room includes which, as the sources are. A line that follows
from others is left out. With --check it fails where the picture is not up to date.

Usage: room_picture.py [--check]
"""

import sys
from pathlib import Path

from check_rooms import INCLUDE, MAY_INCLUDE, resolve, room_of

ROOT = Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs/images/rooms.svg"
LIBRARIES = {
    "core": ("#dbe9f6", "platform numerics net gp statics design survey sampling estimation identification"),
    "adjustment": ("#fde3c8", "adjustment study"),
    "io": ("#dff0d8", "files interchange io results"),
    "report": ("#eadcf2", "report"),
    "c": ("#f6dbe0", "c"),
}
# Where a room stands in its row, from the left.
LANES = {
    "platform": 2, "numerics": 2, "gp": 0, "net": 2, "files": 4, "survey": 1, "statics": 2, "design": 3, "sampling": 2,
    "interchange": 4, "estimation": 1, "identification": 0, "adjustment": 1, "io": 3, "study": 2, "results": 3, "report": 3, "c": 2,
}
WIDTH, HEIGHT, STEP_X, STEP_Y, MARGIN = 116, 30, 138, 56, 12


def includes():
    """Room -> the rooms that its sources and headers include."""
    found = {room: set() for room in MAY_INCLUDE}
    for top in ("include", "src"):
        for file in sorted((ROOT / top).rglob("*.[hc]pp")):
            path = file.relative_to(ROOT).as_posix()
            for line in file.read_text(encoding="utf-8").splitlines():
                match = INCLUDE.match(line)
                target = match and resolve(path, *match.groups())
                rooms = (room_of(path), target and room_of(target))
                if all(room in found for room in rooms) and rooms[0] != rooms[1]:
                    found[rooms[0]].add(rooms[1])
    return found


def reduced(found):
    """The lines that do not follow from others, and the row of each room."""
    above, rows = {}, {}
    for room in MAY_INCLUDE:  # rooms above come first
        above[room] = set(found[room]).union(*(above[one] for one in found[room]))
        rows[room] = 1 + max((rows[one] for one in found[room]), default=-1)
    pairs = [
        (room, one)
        for room in MAY_INCLUDE
        for one in MAY_INCLUDE
        if one in found[room] and not any(one in above[other] for other in found[room])
    ]
    return pairs, rows


def drawn():
    pairs, rows = reduced(includes())
    colours = {room: colour for colour, rooms in LIBRARIES.values() for room in rooms.split()}
    width = 2 * MARGIN + 4 * STEP_X + WIDTH
    height = 2 * MARGIN + max(rows.values()) * STEP_Y + HEIGHT + 34

    def corner(room):
        return MARGIN + LANES[room] * STEP_X, MARGIN + rows[room] * STEP_Y

    lines = [
        "<!-- By scripts/room_picture.py from the includes of the sources. -->",
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        'font-family="sans-serif" font-size="13">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
    ]
    for room, one in pairs:
        (x, y), (x_above, y_above) = corner(room), corner(one)
        lines.append(
            f'<path d="M{x_above + WIDTH // 2} {y_above + HEIGHT}L{x + WIDTH // 2} {y}" stroke="#777"/>'
        )
    for room in MAY_INCLUDE:
        x, y = corner(room)
        lines += [
            f'<rect x="{x}" y="{y}" width="{WIDTH}" height="{HEIGHT}" rx="4" fill="{colours[room]}" stroke="#555"/>',
            f'<text x="{x + WIDTH // 2}" y="{y + 20}" text-anchor="middle">{room}</text>',
        ]
    for number, (library, (colour, _)) in enumerate(LIBRARIES.items()):
        x, y = MARGIN + number * STEP_X, height - MARGIN - 14
        lines += [
            f'<rect x="{x}" y="{y}" width="14" height="14" fill="{colour}" stroke="#555"/>',
            f'<text x="{x + 20}" y="{y + 12}">taut::{library}</text>',
        ]
    return "\n".join([*lines, "</svg>"]) + "\n"


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    if not sys.argv[1:]:
        PICTURE.write_text(drawn(), encoding="utf-8")
    elif not PICTURE.exists() or PICTURE.read_text(encoding="utf-8") != drawn():
        print(f"{PICTURE.relative_to(ROOT)}: not as the includes are: run scripts/room_picture.py")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
