# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Where the time of long commands goes: benchmarks/profile.md, and a flame graph of each as benchmarks/flames/NAME.svg.

    scripts/install_dependencies.sh profile
    PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/profiles.py [NAME]...

Each command runs twice: under `perf record`, which looks at its threads some hundred times a second, and under gdb, which
counts how often matrices are ordered, factorised, inverted and solved with. `inferno`, which draws the graphs, is built by
cargo. Names leave the other profiles as they are.
"""

import argparse
import collections
import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import time

from page_block import heading
from simulation import temporary_folder

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "benchmarks" / "profile.md"
FLAMES = ROOT / "benchmarks" / "flames"
NUMBERS = FLAMES / "profiles.json"
INFERNO = ROOT / "build" / "inferno"
VERSION_OF_INFERNO = "0.11.21"
PLAIN = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}

# What a sample of the stack is at, by the innermost function that one of these names.
KERNELS = {
    "factorisation": r"SupernodalFactor::(factorize|eliminate)|SparseCholesky::by_supernodes",
    "inverse": r"SupernodalFactor::(invert|selected_inverse)|SaddlePointFactor::(covariance|read_covariance|variance)",
    "solves": r"SupernodalFactor::solve|SaddlePointFactor::solve|SparseCholesky::solve",
    "ordering": r"METIS|libmetis|SupernodalFactor::SupernodalFactor|elimination_order|taut::supernodes",
    "eigendecomposition": r"symmetric_eigen|dsyev|dsytrd|dlaed",
}
# Where none of these is around it.
PRODUCTS = {
    "matrix products": r"dgemm|dsyrk|dtrsm|dtrmm|taut::(multiply|product|gram)\b",
}
MEMORY = (
    r"^(malloc|free|_int_malloc|_int_free|realloc|calloc|cfree|operator new|operator delete|malloc_consolidate"
    r"|unlink_chunk|sysmalloc|systrim|__libc_malloc|__default_morecore|taut::app::|page_fault|asm_exc_page_fault"
    r"|clear_page|__memset)"
)
# What a sample works for, by the innermost one.
PURPOSES = {
    "posterior samples": r"add_draws|draw_by_|fit_perturbed|balanced_draw|hamiltonian|shifted_by_determinant|draw_posterior",
    "tests": r"explain|outliers|boundary_tests|score_of|tests_without|detectable|hypothes|trust_of",
    "prior integration": r"propagate_prior|mixture_over|hyperprior|length_likelihoods|marginal|epoch_evidence",
    "files": r"taut::(read|write)_|nlohmann|JsonValue|parse_json|AtomicFile|hdf5|H5",
}
# The kernels of OpenBLAS keep no frames: who called them is not seen.
UNKNOWN = "not known"
# What gdb counts.
COUNTED = {
    "orderings": "taut::SupernodalFactor::SupernodalFactor(std::vector",
    "factorisations": "taut::SupernodalFactor::factorize(",
    "inverses": "taut::SupernodalFactor::selected_inverse(",
    "solves": "taut::SupernodalFactor::solve(",
}

ON_SITE = ["--prior", "uniform:1mm", "--method", "map"]


def surveyed(net, prior, *survey):
    return [
        ["example", net, "-o", "net.json"],
        ["form", "net.json", "--prior", prior, "-o", "site.csv"],
        ["survey", "net.json", "site.csv", *survey, "-o", "survey.csv"],
    ]


NOISY = surveyed("hypar:160x160", "uniform:1mm", "--noise", "0.5mm", "--drop", "10%")
PAPER = surveyed("hilo-quarter", "uniform:5mm", "--noise", "0.5mm")
# Name: what it is, the commands before it, the command, samples of the stack each second.
PROFILES = {
    "map": (
        "`identify` by map, `hypar:160x160`, 0.5 mm, a tenth hidden, no draws",
        NOISY,
        ["identify", "net.json", "survey.csv", *ON_SITE, "--draws", "0", "-o", "r.json"],
        99,
    ),
    "draws": (
        "the same with its 40 posterior samples",
        NOISY,
        ["identify", "net.json", "survey.csv", *ON_SITE, "-o", "r.json"],
        49,
    ),
    "exact": (
        "`identify`, exact survey, `hypar:300x300`",
        surveyed("hypar:300x300", "uniform:1mm"),
        ["identify", "net.json", "survey.csv", "-o", "r.json"],
        99,
    ),
    "built-in": (
        "`identify`, built-in net, 0.5 mm, the default call",
        PAPER,
        ["identify", "net.json", "survey.csv", "-o", "r.json"],
        199,
    ),
    "epoch": (
        "a second survey of the built-in net",
        [
            *PAPER,
            [
                "survey",
                "net.json",
                "site.csv",
                "--noise",
                "0.5mm",
                "--seed",
                "2",
                "-o",
                "second.csv",
            ],
        ],
        ["identify", "net.json", "survey.csv", "--epoch", "second.csv", "-o", "r.json"],
        199,
    ),
    "plan": (
        "`plan` of the built-in net",
        [*PAPER, ["identify", "net.json", "survey.csv", "-o", "r.json"]],
        ["plan", "net.json", "r.json", "-o", "plan.json"],
        199,
    ),
    "reproduce": ("`reproduce`, whole", [], ["reproduce", "-o", "study"], 199),
}


def run(words, folder):
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, env=PLAIN)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: {done.stderr[-2000:]}")
    return done.stdout


def inferno():
    """Built once, from crates.io."""
    if not (INFERNO / "bin" / "inferno-flamegraph").exists():
        run(
            [
                "cargo",
                "install",
                "--quiet",
                "--locked",
                "--root",
                INFERNO,
                f"inferno@{VERSION_OF_INFERNO}",
            ],
            ROOT,
        )
    return INFERNO / "bin"


def samples_of(script):
    """Of perf's text: the time and thread of each sample, and its functions, the innermost first."""
    for block in script.strip().split("\n\n"):
        head, *frames = block.splitlines()
        found = re.match(r"\s*\S.*?\s+(\d+)\s+([\d.]+):", head)
        if found:
            yield (
                float(found[2]),
                int(found[1]),
                [line.strip().split(" ", 1)[-1] for line in frames],
            )


def first_match(functions, patterns, otherwise="other"):
    return next(
        (
            name
            for function in functions
            for name, pattern in patterns.items()
            if re.search(pattern, function)
        ),
        otherwise,
    )


def shares(script, rate):
    """Parts of the samples, and the part of the time in which one thread alone worked."""
    kernels, purposes = collections.Counter(), collections.Counter()
    threads_at = collections.defaultdict(set)
    count = in_memory = 0
    for at, thread, functions in samples_of(script):
        count += 1
        kernels[first_match(functions, KERNELS, first_match(functions, PRODUCTS))] += 1
        is_known = any("taut::" in function for function in functions)
        purposes[first_match(functions, PURPOSES, "fits, the rest" if is_known else UNKNOWN)] += 1
        in_memory += bool(functions and re.search(MEMORY, functions[0]))
        threads_at[int(at * rate / 2)].add(thread)  # two periods: each busy thread is seen
    alone = sum(len(threads) == 1 for threads in threads_at.values())
    part = {
        "samples": count,
        "memory": in_memory / count,
        "one thread alone": alone / len(threads_at),
    }
    return (
        part,
        {k: n / count for k, n in kernels.items()},
        {k: n / count for k, n in purposes.items()},
    )


def counted(program, words, folder):
    """How often the program calls each of COUNTED; None for one that is not found."""
    symbols = run(["nm", "-C", program], ROOT)
    places = {}
    for name, start in COUNTED.items():
        known = re.search(
            rf"^(\w+) [Tt] {re.escape(start)}[^\n]*(?<!cold\])$", symbols, re.MULTILINE
        )
        places[name] = known and known[1]
    script = ["set pagination off", "set breakpoint pending off", "starti"]
    for address in filter(None, places.values()):
        script.append(f"break *($base + 0x{address})")
    number = sum(map(bool, places.values()))
    script += [f"ignore {k + 1} 1000000000" for k in range(number)] + [
        "continue",
        "info breakpoints",
    ]
    # Where the program lies, is known when it has started.
    base = (
        "python import gdb; "
        "m = next(l for l in gdb.execute('info proc mappings', to_string=True).splitlines() if l.rstrip().endswith('/taut')); "
        "gdb.execute('set $base = ' + m.split()[0])"
    )
    script.insert(3, base)
    arguments = [word for line in script for word in ("-ex", line)]
    text = run(["gdb", "-batch", *arguments, "--args", program, *words], folder)
    blocks = re.split(r"\n(?=\d+\s+breakpoint)", text[text.rfind("\nNum ") :])[1:]
    hits = [
        int(found[1]) if (found := re.search(r"already hit (\d+) time", block)) else 0
        for block in blocks
    ]
    of_found = iter(hits)
    return {name: next(of_found) if place else None for name, place in places.items()}


def profiled(name):
    what, before, words, rate = PROFILES[name]
    program = (ROOT / "build" / "taut").resolve()
    with temporary_folder() as folder:
        for command in before:
            run([program, *command, "--quiet"], folder)
        words = [*words, "--quiet"]
        begin = time.monotonic()
        run([program, *words], folder)
        seconds = time.monotonic() - begin
        counts = counted(program, [*words[:-2], "again.json", *words[-1:]], folder)
        run(["rm", "-rf", "study"], folder)
        run(
            [
                "perf",
                "record",
                "--quiet",
                "-e",
                "cpu-clock",
                "-F",
                str(rate),
                "--call-graph",
                "dwarf,32768",
                "-o",
                "perf.data",
                program,
                *words,
            ],
            folder,
        )
        script = run(["perf", "script", "--no-inline", "-i", "perf.data"], folder)
        (folder / "stacks").write_text(script)
        folded = run([inferno() / "inferno-collapse-perf", "stacks"], folder)
        (folder / "folded").write_text(folded)
        svg = run(
            [
                inferno() / "inferno-flamegraph",
                "--minwidth",
                "0.5",
                "--title",
                what.replace("`", ""),
                "--truncate-text-right",
                "folded",
            ],
            folder,
        )
    FLAMES.mkdir(exist_ok=True)
    (FLAMES / f"{name}.svg").write_text(svg)
    of_all, kernels, purposes = shares(script, rate)
    return {
        "seconds": seconds,
        "date": str(datetime.date.today()),
        "counts": counts,
        **of_all,
        "kernels": kernels,
        "purposes": purposes,
    }


def percent(part):
    return f"{100 * part:.0f} %" if part >= 0.005 else ""


def page(found):
    yield "# Where the time goes"
    yield ""
    yield "By `PATH=$PWD/build:$PATH /usr/bin/python3 benchmarks/profiles.py`, on two cores. A share is that of the samples of the"
    yield "stacks of all threads. Each sample counts once in the second table, for what it is at, and once in the third, for what"
    yield "it works for: the innermost function decides. The kernels of OpenBLAS show no callers, so what factorisations, inverses"
    yield "and eigendecompositions do by them stands mostly under matrix products, and for what is not known."
    yield ""
    of = {name: found[name] for name in PROFILES if name in found}
    yield from heading(
        "work | seconds | one thread alone | memory management | orderings | factorisations | inverses | solves"
    )
    for name, one in of.items():
        counts = " | ".join("" if n is None else f"{n:,}" for n in map(one["counts"].get, COUNTED))
        yield (
            f"| [{PROFILES[name][0]}](flames/{name}.svg) | {one['seconds']:.2f} | {percent(one['one thread alone'])} | "
            f"{percent(one['memory'])} | {counts} |"
        )
    for title, key, columns in [
        ("at", "kernels", [*KERNELS, *PRODUCTS, "other"]),
        ("for", "purposes", [*PURPOSES, "fits, the rest", UNKNOWN]),
    ]:
        yield ""
        yield from heading(" | ".join([title, *columns]))
        for name, one in of.items():
            yield (
                f"| {PROFILES[name][0]} | "
                + " | ".join(percent(one[key].get(column, 0.0)) for column in columns)
                + " |"
            )


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*", choices=[*PROFILES, []], default=[])
    names = parser.parse_args().names or list(PROFILES)
    found = json.loads(NUMBERS.read_text()) if NUMBERS.exists() else {}
    for name in names:
        found[name] = profiled(name)
        print(name, found[name], flush=True)
        NUMBERS.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n")
        PAGE.write_text("\n".join(page(found)) + "\n")


if __name__ == "__main__":
    main()
