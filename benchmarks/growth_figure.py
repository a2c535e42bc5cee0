# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Draws how cost grows, from what bench_growth measured.

Usage: /usr/bin/python3 benchmarks/growth_figure.py GROWTH_JSON SVG
"""

import math
import pathlib
import sys

import matplotlib
import matplotlib.ticker
from performance_page import exponent, growth

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

TITLES = {
    "form": ("Form of hypar", "free nodes"),
    "train": ("536 processes trained", "samples"),
    "identify": ("map of hypar, 0.5 mm", "interior edges"),
}


def main():
    curves = growth(pathlib.Path(sys.argv[1]))
    # The same file for the same numbers.
    plt.rcParams.update({"svg.hashsalt": "taut", "font.size": 9, "svg.fonttype": "none"})
    figure, axes = plt.subplots(1, len(TITLES), figsize=(9.0, 3.0), constrained_layout=True)
    for axis, (work, (title, unit)) in zip(axes, TITLES.items(), strict=True):
        sizes, times = curves[work][0], [time / 1e3 for time in curves[work][1]]
        power = exponent(sizes, times)
        log_a = sum(math.log(t) - power * math.log(s) for s, t in zip(sizes, times, strict=True))
        a = math.exp(log_a / len(sizes))
        axis.loglog(sizes, times, "o", color="#1f6f8b", label="measured")
        axis.loglog(sizes, [a * s**power for s in sizes], "-", color="#9aa5ab", label=f"size$^{{{power:.2f}}}$")
        axis.set(title=title, xlabel=unit)
        # Of a narrow range Matplotlib labels the ticks between, one over the other.
        named = (0, len(sizes) // 2, len(sizes) - 1)
        axis.set_xticks(sizes, [f"{size:,.0f}" if k in named else "" for k, size in enumerate(sizes)])
        axis.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
        axis.legend(frameon=False)
        axis.grid(True, which="major", color="#e3e7e9")
    axes[0].set_ylabel("time [s]")
    figure.savefig(sys.argv[2], metadata={"Date": None})


if __name__ == "__main__":
    main()
