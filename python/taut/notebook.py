# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""How a net and its results show themselves in a notebook, without loading anything."""

from __future__ import annotations

import hashlib
import html
import json
import sys
import uuid
from typing import Any

import numpy as np
from numpy.typing import NDArray

from taut import _taut

#: Whether a notebook has the page of reports, 1.2 MB, once: in the first cell that shows a result.
#: Where cells cannot see each other, each has its own.
share_page: bool = not {"google.colab", "dbruntime"} & sys.modules.keys()

_holder = ("", "")  # the cell that holds the page, and a digest of that

_MARK = '<script type="application/json" id="result">'

#: As soon as the cell with the page is there: a notebook may show its cells in any order.
_SHOW = """
(function show() {
  const page = document.querySelector('iframe[data-taut-page="%(page)s"]');
  const frames = document.querySelectorAll('[id="%(frame)s"]');
  if (page) {
    const begin = page.srcdoc.indexOf(%(mark)s) + %(mark)s.length;
    const end = page.srcdoc.indexOf("\\u003c/script>", begin);
    for (const frame of frames) {
      frame.srcdoc = page.srcdoc.slice(0, begin) + %(data)s + page.srcdoc.slice(end);
    }
  } else if (frames.length > 0) {
    setTimeout(show, 500);
  }
})();
"""

_WAITING = (
    "<p>This report is shown with the page of the first one in the notebook. Where that is gone, "
    "restart the kernel and run all cells, or set taut.notebook.share_page = False.</p>"
)


def _frame(page: str, title: str, attribute: str = "") -> str:
    return (
        f'<iframe srcdoc="{html.escape(page, quote=True)}" {attribute} '
        'sandbox="allow-scripts allow-downloads" '
        'style="width:100%;height:720px;border:1px solid #ccc" '
        f'title="{html.escape(title, quote=True)}"></iframe>'
    )


def _in_script(text: str) -> str:
    return json.dumps(text).replace("<", "\\u003c")


def _cell() -> str | None:
    """The cell that runs: its name, or where the front end gives none, the number of the run."""
    ipython = sys.modules.get("IPython")
    shell: Any = ipython.get_ipython() if ipython else None
    kernel = getattr(shell, "kernel", None)
    if kernel is None or not share_page:
        return None
    try:
        return str(kernel.get_parent()["metadata"]["cellId"])
    except (AttributeError, KeyError, TypeError):
        return str(shell.execution_count)


def result_html(result: _taut.Identification | _taut.Plan) -> str:
    """The report of an identification or a plan, inside the cell."""
    if not _taut.has_report_viewer():
        return f"<pre>{html.escape(repr(result))}</pre>"
    return _frame(_taut._report_html(result.to_json()), repr(result))


def _shown_html(result: _taut.Identification | _taut.Plan) -> str:
    """The same, with the page of another cell where there is one."""
    global _holder
    cell = _cell()
    if cell is None or not _taut.has_report_viewer():
        return result_html(result)
    page = _taut._report_html(result.to_json())
    begin = page.index(_MARK) + len(_MARK)
    end = page.index("</script>", begin)
    digest = hashlib.sha256(page[end:].encode()).hexdigest()[:16]
    if cell == _holder[0] or digest != _holder[1]:
        _holder = (cell, digest)
        return _frame(page, repr(result), f'data-taut-page="{digest}"')
    frame = f"taut-{uuid.uuid4().hex}"
    script = _SHOW % {
        "page": digest,
        "frame": frame,
        "mark": _in_script(_MARK),
        "data": _in_script(page[begin:end]),
    }
    return _frame(_WAITING, repr(result), f'id="{frame}"') + f"<script>{script}</script>"


def mimebundle(result: Any, include: object = None, exclude: object = None) -> dict[str, str]:
    """What a notebook shows of a result: IPython's _repr_mimebundle_."""
    del include, exclude
    return {"text/html": _shown_html(result), "text/plain": repr(result)}


def _seen_from_the_side(nodes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Places on the page of an axonometric drawing: x to the right, y to the back, z up."""
    azimuth, height = np.radians(-35.0), np.radians(35.0)
    x, y, z = (nodes - nodes.mean(axis=0)).T
    right = x * np.cos(azimuth) - y * np.sin(azimuth)
    back = x * np.sin(azimuth) + y * np.cos(azimuth)
    return np.column_stack([right, -(z * np.cos(height) + back * np.sin(height))])


def net_html(net: _taut.CableNet) -> str:
    """A drawing of the net: supports as dots, adjustable edges in colour."""
    places = _seen_from_the_side(np.asarray(net.nodes))
    low, extent = places.min(axis=0), np.ptp(places, axis=0)
    scale = 640.0 / max(extent.max(), 1e-9)
    places = (places - low) * scale + 12.0
    width, height = extent * scale + 24.0
    edges = np.asarray(net.edges)

    def path(which: NDArray[Any]) -> str:
        return " ".join(
            "M{:.1f} {:.1f}L{:.1f} {:.1f}".format(*places[s], *places[t]) for s, t in edges[which]
        )

    dots = "".join(
        '<circle cx="{:.1f}" cy="{:.1f}" r="3"/>'.format(*places[k]) for k in net.supports
    )
    return (
        f"<figure style='margin:0'><svg viewBox='0 0 {width:.0f} {height:.0f}' "
        f"style='max-width:{width:.0f}px;width:100%' xmlns='http://www.w3.org/2000/svg'>"
        f"<path d='{path(net.interior_edges)}' stroke='#5b6b7b' fill='none'/>"
        f"<path d='{path(net.adjustable_edges)}' stroke='#d9480f' stroke-width='1.5' fill='none'/>"
        f"<g fill='#1f2933'>{dots}</g></svg>"
        f"<figcaption>{html.escape(repr(net))}: adjustable edges in orange, supports as dots"
        "</figcaption></figure>"
    )
