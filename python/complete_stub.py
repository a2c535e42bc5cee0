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
    # Arguments: dicts of other values and keys than these would be refused, unless literal.
    r"(?<!-> )\bdict\[str \| (?:int \| )?None, ": "Mapping[Any, ",
    r"(?<!-> )\bdict\[": "Mapping[",
    r"(def support_(?:stiffness|place)\(self\)) -> dict": r"\1 -> dict[int, numpy.typing.NDArray]",
    r"(def (?:edge_status|status|warnings)\(self\)) -> list(?!\[)": r"\1 -> list[str]",
    r"(def predict\(.*\)) -> tuple": r"\1 -> tuple[numpy.typing.NDArray, numpy.typing.NDArray]",
    r"(def _net_of_compas\(.*\)) -> tuple": r"\1 -> tuple[CableNet, dict[str, Any]]",
    r"(def load\(.*\)) -> tuple": r"\1 -> tuple[THIS, CableNet]",
    r"(def control\(.*\)) -> object": r"\1 -> dict[str, Any]",
    r"(def to_dataframe\(.*\)) -> object": r"\1 -> pandas.DataFrame",
    r"(def _repr_html_\(.*\)) -> object": r"\1 -> str",
    r"(def to_compas\(.*\)) -> object": r"\1 -> Any",
    r"\bdict(?!\[|\w)": "dict[str, Any]",
    r"\blist(?!\[|\w)": "list[Any]",
    r"\btuple(?!\[|\w)": "tuple[Any, ...]",
    r"\bnumpy\.typing\.NDArray(?!\[)": "numpy.typing.NDArray[numpy.float64]",
    r"\bos\.PathLike(?!\[)": "os.PathLike[str]",
    r"^import os$": "import os\nfrom typing import Any",
    r"^import numpy\.typing$": "import numpy.typing\nimport pandas",
}

#: The overload of a constructor that takes its arguments, and the one for all others.
ONE_THAT_REFUSES = re.compile(
    r" *@overload\n( *def __init__(?:.*\n)+?)\n *@overload\n *def __init__\(self, \*args.*\n"
)


def completed(stub: str) -> str:
    """Changes imports and signatures, never a docstring."""
    stub = ONE_THAT_REFUSES.sub(r"\1", stub)
    stub = re.sub(r"^from typing import overload\n", "", stub, flags=re.MULTILINE)
    lines = stub.split("\n")
    unused = set(COMPLETED)
    this = ""
    for k, line in enumerate(lines):
        if of_class := re.match(r"class (\w+)", line):
            this = of_class[1]
        if re.match(r" *def .*:( \.\.\.)?$|import ", line):
            for pattern, text in COMPLETED.items():
                lines[k], count = re.subn(pattern, text.replace("THIS", this), lines[k])
                unused -= {pattern} if count else set()
    if unused:
        raise SystemExit(f"complete_stub.py: {', '.join(unused)}: is nowhere in the stub")
    return "\n".join(lines)


if __name__ == "__main__":
    stub, output = map(Path, sys.argv[1:])
    output.write_text(completed(stub.read_text(encoding="utf-8")), encoding="utf-8")
