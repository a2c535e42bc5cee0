#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Checks that the links of README.md, CONTRIBUTING.md, CHANGELOG.md and docs/ work in a checkout:
each relative one points to a file that is there, and to a heading that is in it.

Usage: check_links.py [--self-test]
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from urllib.parse import unquote

BLOCK = re.compile(r"^( *)(```|~~~).*?^\1\2\s*?$", re.MULTILINE | re.DOTALL)
LINK = re.compile(
    r"""\]\(<?([^)\s>]+)[^)]*\)|^\[[^]]+\]:\s*(\S+)|<(?:img|a)\s[^>]*(?:src|href)=["']([^"']+)""",
    re.MULTILINE,
)
HEADING = re.compile(r"^#{1,6} +(.*?)(?: *\{#([\w-]+)\})? *#*$", re.MULTILINE)
ELSEWHERE = re.compile(r"[a-z][a-z0-9+.-]*:|//")


def without_blocks(text):
    """Text without blocks of code, each line where it was."""
    return BLOCK.sub(lambda block: "\n" * block.group().count("\n"), text)


def text_of(file):
    if file.suffix != ".ipynb":
        return without_blocks(file.read_text(encoding="utf-8"))
    cells = json.loads(file.read_text(encoding="utf-8"))["cells"]
    return "\n".join("".join(c["source"]) for c in cells if c["cell_type"] == "markdown")


def anchors(file):
    """The names of a page's headings, as the site and most viewers of a repository make them."""
    names, times = set(), {}
    for title, given in HEADING.findall(text_of(file)):
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", title).replace("`", "").lower()
        name = given or re.sub(r"\s+", "-", re.sub(r"[^\w\s-]", "", plain).strip())
        times[name] = times.get(name, 0) + 1
        names |= (
            {name}
            if times[name] == 1
            else {f"{name}_{times[name] - 1}", f"{name}-{times[name] - 1}"}
        )
    return names


def tracked(root):
    """What is in the checkout, folders too: not what a build has left there."""
    command = [
        "git",
        "-C",
        str(root),
        "ls-files",
        "--cached",
        "--others",
        "--exclude-standard",
        "-z",
    ]
    git = subprocess.run(command, capture_output=True, text=True, check=False)
    files = (
        git.stdout.split("\0")
        if git.returncode == 0
        else [str(f.relative_to(root)) for f in root.rglob("*")]
    )
    paths = {root / name for name in files if name and (root / name).exists()}
    return paths | {folder for path in paths for folder in path.parents}


def check(root):
    there = tracked(root)
    pages = [root / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    pages += sorted(
        f for f in there if f.suffix in (".md", ".ipynb") and root / "docs" in f.parents
    )
    problems = []
    for page in (page for page in pages if page in there):
        text = text_of(page)
        for match in LINK.finditer(text):
            link = next(filter(None, match.groups()))
            if ELSEWHERE.match(link):
                continue
            name, _, anchor = unquote(link).partition("#")
            target = (page.parent / name).resolve() if name else page
            where = f"{page.relative_to(root)}:{text.count(chr(10), 0, match.start()) + 1}"
            if target not in there:
                problems.append(f"{where}: link to '{link}', expected a file of the checkout")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                problems.append(f"{where}: link to '{link}', expected a heading of that name")
    return problems


def self_test():
    """Puts good and bad links into a throw-away tree; only the bad ones may be named."""
    cases = [
        ("[a](docs/page.md)", False),
        ("[a](docs/page.md#one-two)", False),
        ("[a](docs/page.md#given)", False),
        ("[a](docs/)", False),
        ("[a](https://taut.example/x)", False),
        ("```\n[a](nowhere.md)\n```", False),
        ("[a](docs/nowhere.md)", True),
        ("[a](docs/page.md#two)", True),
        ('<img src="docs/nowhere.png">', True),
        ("[a]: docs/nowhere.md", True),
    ]
    wrong = []
    for line, is_bad in cases:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            (root / "docs").mkdir()
            (root / "docs/page.md").write_text(
                "# One, `two`\n## Three {#given}\n", encoding="utf-8"
            )
            (root / "README.md").write_text(f"{line}\n", encoding="utf-8")
            if bool(check(root)) != is_bad:
                wrong.append(f"self-test: {line}: expected {'a problem' if is_bad else 'none'}")
    return wrong


def main():
    if sys.argv[1:] not in ([], ["--self-test"]):
        print(__doc__, file=sys.stderr)
        return 2
    problems = self_test() if sys.argv[1:] else check(Path(__file__).resolve().parents[1])
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
