# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Draws, as SVG, how many edges are slack over the predicted probability, from the file of the convergence study.

    /usr/bin/python3 benchmarks/reliability.py trials/trials.json > docs/images/slack_reliability.svg
"""

import json
import math
import sys

SIZE, MARGIN = 360, 56


def place(told, found):
    return MARGIN + told * SIZE, MARGIN / 2 + (1 - found) * SIZE


def bins_of(document):
    """(edges, sum of told, slack) by bin, over all nets."""
    sums = {}
    for net in document["nets"]:
        for one in net["slack_reliability"]:
            edges, told, slack = sums.get((one["above"], one["up_to"]), (0, 0.0, 0))
            sums[one["above"], one["up_to"]] = (edges + one["edges"], told + one["edges"] * (one["told"] or 0.0),
                                                slack + one["slack"])
    return [bin for _, bin in sorted(sums.items()) if bin[0] > 0]


def main():
    bins = bins_of(json.load(open(sys.argv[1], encoding="utf-8")))
    width, height = SIZE + 2 * MARGIN, SIZE + 2 * MARGIN
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
          'font-family="sans-serif" font-size="13">')
    print(f'<rect width="{width}" height="{height}" fill="white"/>')
    for tick in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0):
        x, bottom = place(tick, 0.0)
        left, y = place(0.0, tick)
        print(f'<path d="M{x:.1f} {bottom:.1f}V{bottom - SIZE:.1f}M{left:.1f} {y:.1f}H{left + SIZE:.1f}" stroke="#ddd"/>')
        print(f'<text x="{x:.1f}" y="{bottom + 18:.1f}" text-anchor="middle">{100 * tick:.0f}</text>')
        print(f'<text x="{left - 8:.1f}" y="{y + 4:.1f}" text-anchor="end">{100 * tick:.0f}</text>')
    (x0, y0), (x1, y1) = place(0, 0), place(1, 1)
    print(f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" stroke="#888" stroke-dasharray="5 4"/>')
    for edges, told, slack in bins:
        mean, share = told / edges, slack / edges
        spread = math.sqrt(max(mean * (1 - mean), 1e-12) / edges)
        x, y = place(mean, share)
        _, low = place(mean, max(0.0, share - spread))
        _, high = place(mean, min(1.0, share + spread))
        print(f'<path d="M{x:.1f} {low:.1f}V{high:.1f}" stroke="#0072b2" stroke-width="2"/>')
        print(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="#0072b2"/>')
        if 0.03 < mean < 0.97:
            print(f'<text x="{x + 9:.1f}" y="{y + 5:.1f}" fill="#444">{edges:,} edges</text>')
    middle = MARGIN + SIZE / 2
    print(f'<text x="{middle}" y="{height - MARGIN / 2:.0f}" text-anchor="middle">predicted probability of being slack [%]</text>')
    print(f'<text transform="rotate(-90 18 {MARGIN / 2 + SIZE / 2})" x="18" y="{MARGIN / 2 + SIZE / 2}" '
          'text-anchor="middle">edges that are slack [%]</text>')
    print("</svg>")


if __name__ == "__main__":
    main()
