# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes a stub of nanobind with what it leaves out of types: the entries of containers, and the
classes of packages that are only imported when they are used.

Usage: complete_stub.py STUB OUTPUT
"""

import re
import sys
from pathlib import Path

COMPLETED = {
    r"(def support_(?:stiffness|place)\(self\)) -> dict": r"\1 -> dict[int, numpy.typing.NDArray]",
    r"(def (?:edge_status|status|warnings)\(self\)) -> list(?!\[)": r"\1 -> list[str]",
    r"\bdict(?!\[|\w)": "dict[str, Any]",
    r"\blist(?!\[|\w)": "list[Any]",
    r"\btuple(?!\[|\w)": "tuple[Any, ...]",
    r"\bnumpy\.typing\.NDArray(?!\[)": "numpy.typing.NDArray[numpy.float64]",
    r"\bos\.PathLike(?!\[)": "os.PathLike[str]",
    r"(def to_dataframe\(.*\)) -> object": r"\1 -> pandas.DataFrame",
    r"(def _repr_html_\(.*\)) -> object": r"\1 -> str",
    r"(def to_compas\(.*\)) -> object": r"\1 -> Any",
    r"(def _net_of_compas\(.*) -> tuple\[Any, \.\.\.\]": r"\1 -> tuple[CableNet, dict[str, Any]]",
    r"(def load\(.*) -> tuple\[Any, \.\.\.\]": r"\1 -> tuple[Any, CableNet]",
}


def completed(stub: str) -> str:
    """Changes heads alone, which are lines that end a signature: no line of a docstring does."""
    lines = stub.splitlines(keepends=True)
    for k, line in enumerate(lines):
        if re.match(r" *def .*:( \.\.\.)?$", line):
            for pattern, text in COMPLETED.items():
                lines[k] = re.sub(pattern, text, lines[k])
    return re.sub("^import os$", "import os\nfrom typing import Any", "".join(lines), flags=re.M)


if __name__ == "__main__":
    stub, output = map(Path, sys.argv[1:])
    text = completed(stub.read_text(encoding="utf-8"))
    text = text.replace("import numpy.typing\n", "import numpy.typing\nimport pandas\n", 1)
    output.write_text(text, encoding="utf-8")
