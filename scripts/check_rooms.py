#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Checks that each room includes only from the rooms that it may see, and that public headers show
nothing but the standard library, Eigen and taut.

Usage: check_rooms.py [--self-test]
"""

import posixpath
import re
import sys
import tempfile
from pathlib import Path

# In their order: a room includes only from rooms above it, and of these only from the named ones.
# docs/architecture.md says the same, and is held to it.
MAY_INCLUDE = {
    "platform": [],
    "numerics": ["platform"],
    "net": ["numerics"],
    "gp": ["numerics"],
    "statics": ["numerics", "net"],
    "design": ["numerics", "net", "statics"],
    "survey": ["numerics", "net"],
    "sampling": ["numerics", "net", "statics"],
    "estimation": ["numerics", "net", "statics", "survey", "sampling"],
    "identification": [
        "platform",
        "numerics",
        "net",
        "gp",
        "statics",
        "survey",
        "sampling",
        "estimation",
    ],
    "adjustment": [
        "numerics",
        "net",
        "statics",
        "survey",
        "sampling",
        "estimation",
        "identification",
    ],
    "study": [
        "numerics",
        "net",
        "gp",
        "statics",
        "design",
        "survey",
        "sampling",
        "estimation",
        "identification",
        "adjustment",
    ],
    "files": ["platform", "numerics"],
    "interchange": ["net", "statics", "design", "survey", "files"],
    "io": [
        "numerics",
        "net",
        "gp",
        "statics",
        "design",
        "survey",
        "sampling",
        "identification",
        "adjustment",
        "files",
        "interchange",
    ],
    "results": [
        "numerics",
        "net",
        "gp",
        "statics",
        "design",
        "survey",
        "sampling",
        "estimation",
        "identification",
        "adjustment",
        "study",
        "files",
        "interchange",
        "io",
    ],
    "report": ["files", "results"],
    "c": [
        "net",
        "statics",
        "design",
        "survey",
        "sampling",
        "identification",
        "adjustment",
        "files",
        "io",
        "results",
    ],
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def room_of(path):
    """The room of a repository path, None for what stands outside of all rooms (version, apps)."""
    for root in ("include/taut/", "src/"):
        if path.startswith(root):
            parts = path[len(root) :].split("/")
            return parts[0] if len(parts) > 1 else None
    return None


def resolve(path, quote, name):
    """The repository path that an include names, or None when it is not ours."""
    if name.startswith("taut/export/"):
        return None  # made by the build
    if name.startswith("taut/"):
        return "include/" + name
    if quote == '"':
        beside = posixpath.normpath(posixpath.join(posixpath.dirname(path), name))
        in_src = "src/" + name
        return in_src if name.split("/")[0] in MAY_INCLUDE else beside
    return None


def problem_with(path, quote, name):
    target = resolve(path, quote, name)
    room = room_of(path)
    is_public = path.startswith("include/")
    if target is None:
        if (
            is_public
            and ("/" in name or name.endswith(".h"))
            and not name.startswith(("Eigen/", "taut/export/"))
        ):
            return (
                f"public header includes <{name}>, allowed are the standard library, Eigen and taut"
            )
        return None
    if is_public and not target.startswith("include/"):
        return f"public header includes the private '{name}'"
    if path.startswith("apps/") and target.startswith("src/"):
        return f"the program includes the private '{name}', allowed are public headers"
    target_room = room_of(target)
    if room is None or target_room is None or target_room == room:
        return None
    if target_room not in MAY_INCLUDE:
        return f"'{name}' is in the unknown room '{target_room}'"
    if target_room not in MAY_INCLUDE[room]:
        allowed = ", ".join(MAY_INCLUDE[room]) or "no other room"
        return f"room '{room}' includes '{name}', allowed: {allowed}"
    return None


def check(root):
    """All broken rules under root, as 'file:line: message'."""
    problems = []
    for top in ("include", "src", "apps"):
        for file in sorted((root / top).rglob("*.[hc]pp")):
            path = file.relative_to(root).as_posix()
            room = room_of(path)
            if room is not None and room not in MAY_INCLUDE:
                problems.append(f"{path}:1: unknown room '{room}'")
                continue
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                match = INCLUDE.match(line)
                problem = match and problem_with(path, *match.groups())
                if problem:
                    problems.append(f"{path}:{number}: {problem}")
    return problems


def check_table(root):
    """Whether docs/architecture.md shows the same rooms in the same order, each with what it may
    include, and whether each includes only rooms above it."""
    problems = []
    rows = re.findall(
        r"^\| `(\w+)` \|.*\| ([\w`./, ]+) \| ([\w, ]*)\|$",
        (root / "docs/architecture.md").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
    shown = {
        room: [name.strip() for name in names.split(",") if name.strip()]
        for room, _, names in rows
    }
    problems += [
        f"docs/architecture.md: '{room}' has no '{name}' to read first"
        for room, first, _ in rows
        for name in re.findall(r"`([^`]+)`", first)
        if not (root / "src" / room / name).exists() and not (root / "include" / name).exists()
    ]
    if list(shown) != list(MAY_INCLUDE):
        problems.append(f"docs/architecture.md: rooms {list(shown)}, expected {list(MAY_INCLUDE)}")
    for room, names in MAY_INCLUDE.items():
        if shown.get(room, names) != names:
            problems.append(
                f"docs/architecture.md: '{room}' includes {shown[room]}, expected {names}"
            )
        above = list(MAY_INCLUDE)[: list(MAY_INCLUDE).index(room)]
        problems += [
            f"check_rooms.py: '{room}' may include '{name}', which is not above it"
            for name in names
            if name not in above
        ]
    return problems


def self_test():
    """Puts right and wrong includes into a throw-away tree; only the wrong ones may be named."""
    cases = [
        # file, include, is an error
        ("include/taut/statics/a.hpp", '"taut/net/cable_net.hpp"', False),
        ("include/taut/statics/b.hpp", "<Eigen/Core>", False),
        ("include/taut/statics/c.hpp", "<vector>", False),
        ("include/taut/statics/d.hpp", '"taut/version.hpp"', False),
        ("src/statics/e.cpp", '"statics/newton.hpp"', False),
        ("src/statics/f.cpp", '"newton.hpp"', False),
        ("src/statics/g.cpp", "<fmt/core.h>", False),
        ("src/report/h.cpp", '"taut/results/result_file.hpp"', False),
        ("apps/taut/i.cpp", '"taut/report/report.hpp"', False),
        ("apps/taut/j.cpp", '"units.hpp"', False),
        ("include/taut/net/k.hpp", '"taut/statics/energy.hpp"', True),
        ("include/taut/gp/l.hpp", "<taut/net/cable_net.hpp>", True),
        ("src/net/m.cpp", '"statics/newton.hpp"', True),
        ("src/net/n.cpp", '"../statics/newton.hpp"', True),
        ("src/report/o.cpp", '"taut/net/cable_net.hpp"', True),
        ("include/taut/net/p.hpp", "<nlohmann/json.hpp>", True),
        ("include/taut/net/q.hpp", "<hdf5.h>", True),
        ("include/taut/statics/r.hpp", '"statics/newton.hpp"', True),
        ("apps/taut/s.cpp", '"statics/newton.hpp"', True),
        ("src/attic/t.cpp", "<vector>", True),
        ("src/net/u.cpp", '"taut/attic/t.hpp"', True),
    ]
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for path, include, _ in cases:
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(f"#include {include}\n", encoding="utf-8")
        named = {problem.split(":")[0] for problem in check(root)}
    wrong = [case for case in cases if (case[0] in named) != case[2]]
    return [
        f"self-test: {path} with #include {include}: expected {'an error' if bad else 'none'}"
        for path, include, bad in wrong
    ]


def main():
    if sys.argv[1:] not in ([], ["--self-test"]):
        print(__doc__, file=sys.stderr)
        return 2
    root = Path(__file__).resolve().parent.parent
    problems = self_test() if sys.argv[1:] else check(root) + check_table(root)
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
