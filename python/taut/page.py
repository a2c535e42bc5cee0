# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The page for browsers, which the package carries."""

from __future__ import annotations

from importlib import metadata
from os import PathLike
from pathlib import Path

from taut import _taut


def app(output: str | PathLike[str] | None = None) -> Path:
    """taut as one HTML page, which works in a browser without a network, as `taut app`.

    Args:
        output: where to write it; by default it stays where the package keeps it.

    Returns:
        Where the page is.
    """
    for file in metadata.files("taut") or []:
        if file.name == "taut.html" and (page := Path(file.locate()).resolve()).exists():
            if output is None:
                return page
            _taut._copy_page(page, output)
            return Path(output)
    raise FileNotFoundError(
        "this taut was installed without its page for browsers, which `make app` in a checkout "
        "of taut builds, and `make wheel` puts into the package"
    )
