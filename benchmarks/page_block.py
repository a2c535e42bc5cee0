#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Replaces a block of a page of docs/: what is between `<!-- by NAME -->` and `<!-- end -->`.

NAME is the script that makes the block. The prose around it belongs to the page alone.

Usage: page_block.py PAGE NAME < TEXT
"""

import re
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1] / "docs"


def replaced(text, name, block):
    """The text of a page with another block, which must be there once."""
    begin, end = f"<!-- by {name} -->\n", "<!-- end -->"
    found = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.DOTALL)
    text, count = found.subn(lambda _: f"{begin}\n{block.strip()}\n\n{end}", text)
    if count != 1:
        raise ValueError(f"the block '{name}' is there {count} times, expected once")
    return text


def put(page, name, block):
    """Replaces a block of docs/PAGE."""
    path = DOCS / page
    path.write_text(replaced(path.read_text(encoding="utf-8"), name, block), encoding="utf-8")


def name_of(script):
    return Path(script).resolve().relative_to(DOCS.parent).as_posix()


def by(script, more=""):
    """The line of a block that names the command which makes it."""
    return f"By `PATH=$PWD/build:$PATH /usr/bin/python3 {name_of(script)} --write`{more}:\n"


def heading(columns):
    """The first two lines of a table, for the titles of its columns as "a | b"."""
    return f"| {columns} |", "|" + "---|" * len(columns.split(" | "))


def count_given(default):
    """The first number among the arguments of the script."""
    return int(next((word for word in sys.argv[1:] if word.isdigit()), default))


def show(page, script, lines):
    """Prints the lines of a block as they come. With --write among the arguments of the script,
    they then replace its block of docs/PAGE."""
    kept = []
    for line in lines:
        print(line, flush=True)
        kept.append(line)
    if "--write" in sys.argv:
        put(page, name_of(script), "\n".join(kept))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    put(*sys.argv[1:], sys.stdin.read())
