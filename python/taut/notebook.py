# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""How a net and its results show themselves in a notebook, without loading anything."""

from __future__ import annotations

import html

import numpy as np

from taut import _taut


def result_html(result) -> str:
    """The report of an identification or a plan, inside the cell."""
    if not _taut.has_report_viewer():
        return f"<pre>{html.escape(repr(result))}</pre>"
    page = html.escape(_taut._report_html(result.to_json()), quote=True)
    return (
        f'<iframe srcdoc="{page}" sandbox="allow-scripts allow-downloads" '
        'style="width:100%;height:720px;border:1px solid #ccc" '
        f'title="{html.escape(repr(result), quote=True)}"></iframe>'
    )


def _seen_from_the_side(nodes):
    """Places on the page of an axonometric drawing: x to the right, y to the back, z up."""
    azimuth, height = np.radians(-35.0), np.radians(35.0)
    x, y, z = (nodes - nodes.mean(axis=0)).T
    right = x * np.cos(azimuth) - y * np.sin(azimuth)
    back = x * np.sin(azimuth) + y * np.cos(azimuth)
    return np.column_stack([right, -(z * np.cos(height) + back * np.sin(height))])


def net_html(net) -> str:
    """A drawing of the net: supports as dots, adjustable edges in colour."""
    places = _seen_from_the_side(np.asarray(net.nodes))
    low, extent = places.min(axis=0), np.ptp(places, axis=0)
    scale = 640.0 / max(extent.max(), 1e-9)
    places = (places - low) * scale + 12.0
    width, height = extent * scale + 24.0
    edges = np.asarray(net.edges)

    def path(which):
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
