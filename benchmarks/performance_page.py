# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""The tables of docs/performance.md that scripts/bench.sh measures, from what it left in a folder.

Usage: /usr/bin/python3 benchmarks/performance_page.py FOLDER [--write]
"""

import datetime
import json
import math
import pathlib
import platform
import re
import statistics
import subprocess
import sys

from page_block import show


def medians(file):
    """Name -> (median real time in ms, counters) of a Google Benchmark output."""
    rows = {}
    for row in json.loads(file.read_text())["benchmarks"]:
        if row.get("aggregate_name") == "median" and not row.get("error_occurred"):
            scale = {"ms": 1.0, "s": 1e3, "us": 1e-3, "ns": 1e-6}[row["time_unit"]]
            name = row["run_name"].removesuffix("/real_time").removesuffix("/iterations:1")
            rows[name.removesuffix("/iterations:2")] = (row["real_time"] * scale, row)
    return rows


def growth(file):
    """Work -> sizes and times [ms] of benchmarks/bench_growth.cpp."""
    found = {}
    for row in json.loads(file.read_text())["benchmarks"]:
        if row.get("run_type") == "iteration" and not row.get("error_occurred"):
            sizes, times = found.setdefault(row["name"].split("/")[0], ([], []))
            sizes.append(row["size"])
            times.append(row["real_time"])
    return found


def exponent(sizes, times):
    """b of the time a size^b, by least squares of the logarithms."""
    logarithms = ([math.log(value) for value in values] for values in (sizes, times))
    return statistics.linear_regression(*logarithms).slope


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor() or "unknown processor"


def main():
    folder = pathlib.Path(sys.argv[1])

    def load(name):
        return json.loads((folder / name).read_text())

    rows = {}
    for name in ("statics", "learning", "identification", "factorisation", "adjustment", "threads", "roofline"):
        rows |= medians(folder / f"{name}.json")
    header = pathlib.Path("include/taut/gp/fit.hpp").read_text()
    decomposed = int(re.search(r"most_decomposed = (\d+)", header).group(1))
    grown = growth(folder / "growth.json")
    memory = load("memory.json")
    low_rank = {row["name"]: row for row in load("low_rank.json")["benchmarks"]}
    study = load("reproduce.json")
    whole = load("reproduce_process.json")
    large = load("hypar300_process.json")
    large_identified = load("hypar300_identify_process.json")
    opened = load("opening.json")
    peer = load("sklearn.json")
    planned = load("plan.json")
    plan_process = load("plan_process.json")
    plan_peer = load("scipy_plan.json")
    cores = len(__import__("os").sched_getaffinity(0))
    compiler = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=True)
    seconds = study["seconds"]
    training = study["methods"]["gp_as_in_paper"]["training_seconds"]  # that of the peer's model
    per_output = peer["seconds"] / (training / study["net"]["interior_edges"])

    def ms(name):
        return f"{rows[name][0]:.3g} ms"

    def steps(name):
        return f"{rows[name][1]['newton_steps']:.2g}"

    def cone_rows():
        """Table rows of the cone program; none where taut was built without Clarabel."""
        newton = rows["solve_from_nominal_form"][0]
        return "".join(
            f"| the same by the paper's SOCP, Clarabel, {form} form | {ms(name)}: "
            f"{rows[name][0] / newton:.0f} times Newton's | {steps(name)} |\n"
            for form in ("quadratic", "paper")
            if (name := f"solve_cone_program/{form}") in rows
        )

    def hilo_row():
        """Table row of the real HiLo net; none where its file is not there."""
        if "solve_hilo" not in rows:
            return ""
        return (
            "| real HiLo net (800 free nodes, docs/real-nets.md), +-5 mm, from the nominal form | "
            f"{ms('solve_hilo')} | {steps('solve_hilo')} |\n"
        )

    def factorisation_rows():
        """Table rows of each factorisation beside its peers; none of a peer that was not built."""
        works = {
            "stiffness": "stiffness, factor and one solution",
            "saddle_point": "saddle-point matrix, factor and one solution",
            "covariance": "the same, entries of the inverse after the factor",
        }
        peers = {
            "taut": "taut",
            "nodal": "taut, node by node: of nets of less than 5,000 free nodes",
            "supernodal": "taut, in supernodes: of larger ones",
            "eigen_ldlt": "Eigen SimplicialLDLT",
            "eigen_lu": "Eigen SparseLU",
            "mumps": "MUMPS",
        }

        def cell(work, peer, side):
            own = rows[f"{work}_taut/{side}"][0]
            ratio = "" if peer == "taut" else f" ({rows[f'{work}_{peer}/{side}'][0] / own:.2g})"
            return f" {ms(f'{work}_{peer}/{side}')}{ratio} |"

        return "".join(
            f"| {title} | {peers[peer]} |"
            + "".join(cell(work, peer, side) for side in (0, 30, 100))
            + "\n"
            for work, title in works.items()
            for peer in peers
            if f"{work}_{peer}/0" in rows
        )

    def thread_rows():
        works = {
            "equilibria": "equilibrium, +-5 mm, from the nominal form",
            "map": "maximum a posteriori, 0.5 mm",
            "processes": "processes trained on 200 samples, 0.5 mm",
        }

        def rate(work, threads):
            return rows[f"{work}/real_time/threads:{threads}"][1]["items_per_second"]

        return "".join(
            f"| {title} | {rate(work, 1):.3g} /s | {rate(work, 2):.3g} /s | "
            f"{rate(work, 2) / rate(work, 1):.2f} |\n"
            for work, title in works.items()
        )

    def roofline_rows():
        """Table rows of each part: what it needs, and which share of the machine's peak it reaches."""
        parts = {
            "stiffness_of_the_builtin_net/threads:1": "stiffness of the built-in net, factor",
            "form_of_the_builtin_net/threads:1": "form of the built-in net from the linear prediction",
            "stiffness_of_hypar_300/threads:0": "stiffness of `hypar:300x300`, factor",
            "sensitivities_of_the_builtin_net/threads:0": "sensitivities to the lengths of the built-in net",
            "selected_inverse_of_hypar_100/threads:0": "selected inverse over `hypar:100x100`",
            "squared_distances_of_950_forms/threads:0": "distances of 950 forms",
            "correlations_of_950_forms/threads:0": "correlations of 950 forms",
            "eigendecomposition_of_950/threads:0": "eigendecomposition, n = 950",
            "prediction_of_536_lengths/threads:0": "lengths of one form, 536 processes",
            "hdf5_of_1000_samples/threads:1": "HDF5 of 1000 samples, with its digest",
        }
        lines = []
        for name, title in parts.items():
            kind, unit, machine = (
                ("flops", "Gflop", "dgemm") if "flops" in rows[name][1] else ("bytes", "GB", "triad")
            )
            threads = name.rsplit("/", 1)[1]
            peak = rows[f"{machine}/{threads}"][1][kind]
            reached = rows[name][1][kind]
            cores_used = "one" if threads.endswith("1") else "all"
            lines.append(
                f"| {title} | {cores_used} | {rows[name][1]['needed'] / 1e9:.3g} {unit} | {ms(name)} | "
                f"{reached / 1e9:.3g} {unit}/s | {100 * reached / peak:.0f} % |\n"
            )
        return "".join(lines)

    def peak(name):
        row = rows[name][1]
        return f"{row['flops'] / 1e9:.3g} Gflop/s" if "flops" in row else f"{row['bytes'] / 1e9:.3g} GB/s"

    def growth_rows():
        works = {
            "form": ("form of `hypar`, symbolic work included", "free nodes"),
            "train": ("536 processes trained, built-in net", "samples"),
            "identify": ("`map` of `hypar`, 0.5 mm, no posterior samples", "interior edges"),
        }
        lines = []
        for work, (title, unit) in works.items():
            power = f"{exponent(*grown[work]):.2f}"
            for size, time in zip(*grown[work], strict=True):
                lines.append(f"| {title} | {size:,.0f} {unit} | {time / 1e3:.3g} s | {power} |\n")
                title = power = ""
        return "".join(lines)

    def memory_rows():
        """Table rows of the largest memory of each command."""

        def mib(row):
            return f"{row['bytes'] / 2**20:.0f} MiB"

        lines = []
        for group, size in (("nets", "net"), ("samples", "samples")):
            commands = list(dict.fromkeys(row["command"] for row in memory[group]))
            for command in commands:
                runs = [row for row in memory[group] if row["command"] == command]
                cells = ", ".join(
                    f"{mib(run)} (`{run[size]}`)" if size == "net" else f"{mib(run)} ({run[size]:,} samples)"
                    for run in runs
                )
                lines.append(f"| `{command}`{' --model' if size == 'samples' and command == 'identify' else ''} | {cells} |\n")
        lines += [f"| `{run['command']}` | {mib(run)} |\n" for run in memory["studies"]]
        return "".join(lines)

    def low_rank_rows():
        return "".join(
            f"| {way} | {int(name.split('/')[1]):,} | {row['real_time']:.3g} s | {row['squared_error_mm2']:.3g} mm^2 | "
            f"{row['mean_std_mm']:.3g} mm | {row['approximation_error_mm']:.2g} mm |\n"
            for prefix, way in (("by_decompositions", "decompositions"), ("by_low_rank", "low rank"))
            for name, row in low_rank.items()
            if name.startswith(prefix)
        )

    def report_rows():
        nets = ("built-in net, `reproduce`", "`hypar:300x300`, `identify`")
        return "".join(
            f"| {net} | {page['mebibytes']:.1f} MiB | {page['seconds']:.2f} s | "
            f"{page['context_seconds']:.2f} s | "
            f"{page['frame_milliseconds']:.0f} ms |\n"
            for net, page in zip(nets, opened, strict=True)
        )

    page = f"""By `make bench` on {datetime.date.today()}: {cores} cores of {processor()},
{compiler.stdout.splitlines()[0]}, {study['program']}. Medians of three repetitions; the whole
processes were run once. Times depend on the machine; ratios are taken within one run.

## Equilibrium, one core

| solve | time | Newton or interior point steps |
|---|---|---|
| built-in net, +-5 mm, from the nominal form | {ms('solve_from_nominal_form')} | {steps('solve_from_nominal_form')} |
| the same from the linear prediction | {ms('solve_from_linear_prediction')} | {steps('solve_from_linear_prediction')} |
{cone_rows()}{hilo_row()}| `hypar:30x30`, +-1 % of the spacing, symbolic work included | {ms('solve_hypar/30')} | {steps('solve_hypar/30')} |
| `hypar:100x100`, likewise | {ms('solve_hypar/100')} | {steps('solve_hypar/100')} |
| `hypar:300x300` (90,000 free nodes), likewise | {ms('solve_hypar/300')} | {steps('solve_hypar/300')} |

The process that solves `hypar:300x300` holds at most {large['peak_kib'] / 2**20:.2f} GiB.

## Learning, all cores, the paper's counts

| work | time |
|---|---|
| sample 1000 forms (+-5 mm) | {ms('sample_1000_forms')} |
| one eigendecomposition, n = 950 | {ms('one_kernel_spectrum')} |
| train 536 processes on 950 samples | {ms('train_536_processes')} |
| estimate the 536 lengths of one form | {ms('estimate_lengths_of_one_form')} |
| identify from one survey with 0.5 mm of noise, gross errors looked for | {ms('identify_by_processes_from_a_noisy_survey')} |

## More samples than are decomposed

Beyond {decomposed:,} samples the processes are trained by low rank ([theory](theory.md#processes-on-many-samples)). The table compares
both ways on the same samples (`benchmarks/bench_low_rank.cpp`). Errors and standard deviations are those of the lengths of 500 forms
outside the training set. The last column is the bound of the loss that `taut train` reports.

| by | samples | time | mean squared error | standard deviation | bound of the loss |
|---|---|---|---|---|---|
{low_rank_rows()}
## Identification, built-in net, standard deviations included

| method | survey's noise | time |
|---|---|---|
| force balance | none | {ms('balance/0')} |
| force balance | 0.5 mm | {ms('balance/5')} |
| maximum a posteriori | none | {ms('map/0')} |
| maximum a posteriori | 0.1 mm | {ms('map/1')} |
| maximum a posteriori | 0.5 mm | {ms('map/5')} |
| maximum a posteriori | 2 mm | {ms('map/20')} |
| maximum a posteriori, `hypar:30x30` | as in `bench_identification.cpp` | {ms('map_of_hypar/30')} |

`taut identify` on an exact survey of `hypar:300x300` (179,400 interior edges), from file to file:
{large_identified['seconds']:.0f} s and {large_identified['peak_kib'] / 2**20:.1f} GiB.

## Turns, built-in net

| work | time |
|---|---|
| plan, limits held for the estimate | {ms('plan/0/0')} |
| plan, limits held with 95 % over 200 posterior samples | {ms('plan/200/0')} |
| the same in quarter turns of 5 mm | {ms('plan/200/1')} |
| order for three crews, every step in exact equilibrium | {ms('order_of_plan')} |
| lengths from two surveys at once | {ms('two_epochs')} |
| one job: survey, identification, plan, turns, by all four strategies of `taut control` | {ms('control')} |

SciPy {plan_peer['scipy']}'s SLSQP with exact derivatives (`benchmarks/peers/scipy_plan.py`) makes the same plan from the same identified
net: {plan_peer['seconds']:.2f} s to a normal RMS of {1e3 * plan_peer['normal_rmse']:.3f} mm; `taut plan`, from file to file and with the order, {plan_process['seconds']:.2f} s to
{1e3 * planned['form']['planned']['normal_rmse']:.3f} mm: {plan_peer['seconds'] / plan_process['seconds']:.1f} times as fast.

## A program with threads of its own

Each thread calls taut, one thread a call (`with_threads(1, ...)`), on the built-in net (`bench_threads`). The ratio is that of the calls a
second by two threads and by one:

| work | one thread | two threads | ratio |
|---|---|---|---|
{thread_rows()}
## Factorisations, one core

`bench_factorisation`, without the symbolic work. In brackets: the time over that of taut.

| work | by | built-in net | `hypar:30x30` | `hypar:100x100` |
|---|---|---|---|---|
{factorisation_rows()}
## What the machine can

Peaks, measured in the same run: products of large matrices {peak('dgemm/threads:1')} on one core, {peak('dgemm/threads:0')}
on all; memory (STREAM's triad) {peak('triad/threads:1')} and {peak('triad/threads:0')}. `benchmarks/bench_roofline.cpp` counts what each
part needs at least. The last column is the share of the peak that it reaches. Two parts cannot reach it: columns of small nets are too
short for dense products, and half of an eigendecomposition is products of a matrix and a vector, which memory bounds.

| part | cores | needs | time | reaches | of the peak |
|---|---|---|---|---|---|
{roofline_rows()}
## How cost grows

All cores, each run once (`benchmarks/bench_growth.cpp`). The exponent b of time = a size^b is fitted to all sizes of a curve.

![Time over size, with the fitted powers](images/growth.svg)

| work | size | time | exponent |
|---|---|---|---|
{growth_rows()}
## Memory

The largest resident memory of each command (`benchmarks/memory.py`). Rows with samples are for the built-in net, studies for their default
numbers of samples. `--memory 8GiB` sets a limit ([command-line.md](command-line.md#memory)).

| command | memory |
|---|---|
{memory_rows()}
## Reports

Time from opening the file in a new browser until the page answers, and time of a frame while the net turns. Medians of Chromium without a
graphics card (`viewer/tests/opening.mjs`).

| report | size | interactive after | of that, the browser's start of WebGL | a frame |
|---|---|---|---|---|
{report_rows()}
## The paper's experiment as one process

`taut reproduce --keep`: {whole['seconds']:.2f} s and {whole['peak_kib'] / 2**20:.2f} GiB in all;
sampling {seconds['sampling']:.2f} s, training {seconds['training']:.2f} s, identification
{seconds['identification']:.2f} s.

## Against scikit-learn

`benchmarks/peers/sklearn_one_output.py` trains one of the 536 outputs on the same 950 samples with
scikit-learn {peer['sklearn']} (constant x RBF + white kernel, one start).

| | time | outputs | a single output |
|---|---|---|---|
| taut | {training:.2f} s | {study['net']['interior_edges']} | {1e3 * training / study['net']['interior_edges']:.2f} ms |
| scikit-learn | {peer['seconds']:.2f} s | 1 | {1e3 * peer['seconds']:.0f} ms |

taut needs {training / peer['seconds']:.2f} times the time of scikit-learn's one output for all {study['net']['interior_edges']}: an output is {per_output:.0f} times as fast."""
    show("performance.md", __file__, [page])


if __name__ == "__main__":
    main()
