#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Holds docs/theory.md and the code to each other: every equation that the page names is named in a
source, every name in a source stands on the page, and every file that the page names is there."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ROOMS = ("adjustment", "estimation", "gp", "identification", "numerics", "statics", "survey")


def main():
    page = (ROOT / "docs/theory.md").read_text(encoding="utf-8")
    tags = re.findall(r"\\tag\{([^}]+)\}", page)
    problems = [
        f"docs/theory.md: (({tag})) is there twice" for tag in set(tags) if tags.count(tag) > 1
    ]
    problems += [
        f"docs/theory.md: **({tag})** names no place" for tag in tags if f"**({tag})**" not in page
    ]
    for file in re.findall(r"`((?:src|include|scripts)/[\w/.]+)`", page):
        if not (ROOT / file).exists():
            problems.append(f"docs/theory.md: {file} is not there")
    named = {}
    for top in ("src", "include/taut"):
        for room in ROOMS:
            for file in sorted((ROOT / top / room).glob("*.[hc]pp")):
                text = file.read_text(encoding="utf-8")
                comments = " ".join(re.findall(r"//+(.*)", text))
                for tag in tags:
                    if f"({tag})" in comments:
                        named.setdefault(tag, file)
                for other in re.findall(
                    r"docs/theory\.md[,:]? \(([a-z -]+)\)", re.sub(r"\s*\n\s*///?\s*", " ", text)
                ):
                    if other not in tags:
                        problems.append(
                            f"{file.relative_to(ROOT)}: ({other}) is not in docs/theory.md"
                        )
    problems += [f"docs/theory.md: no source names ({tag})" for tag in tags if tag not in named]
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
