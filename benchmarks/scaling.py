# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""How `taut-mpi sample` scales over processes of one machine: two tables of docs/performance.md.

    PATH=$PWD/build/release/apps/taut:$PWD/build/release/apps/taut-mpi:$PATH \
        /usr/bin/python3 benchmarks/scaling.py [--net hilo-quarter] [--samples 2000] [--repeat 3] [--write]

Strong: the same samples over more processes of one thread. Weak: as many samples for each process. Beside the time
stands the processor time of all processes, which shows what the sharing itself costs also where the machine is busy
with other work. Each number is the least of the repetitions, which take turns.
"""

import argparse
import os
import resource
import subprocess
import time

from page_block import heading, show
from simulation import temporary_folder

PROCESSES = [1, 2, 3, 4]
OPEN_MPI = {
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
}


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def measured(words, folder):
    """Wall and processor time of a command [s]."""
    begin, used = time.monotonic(), processor_seconds()
    subprocess.run(words, cwd=folder, check=True, capture_output=True, env={**os.environ, **OPEN_MPI})
    return time.monotonic() - begin, processor_seconds() - used


def by_threads(threads, samples):
    return ["taut", "sample", "net.json", "-n", str(samples), "--threads", str(threads), "-o", "data.h5"]


def by_processes(processes, samples):
    return ["mpiexec", "-n", str(processes), "taut-mpi", "sample", "net.json", "-n", str(samples), "--threads", "1",
            "-o", "data.h5"]


def least(runs, repeat, folder):
    """The least wall and processor time of each run."""
    times = [[measured(words, folder) for words in runs] for _ in range(repeat)]
    return [tuple(map(min, zip(*of_run))) for of_run in zip(*times)]


def lines(options):
    with temporary_folder() as folder:
        subprocess.run(["taut", "example", options.net, "-o", "net.json"], cwd=folder, check=True, capture_output=True)
        runs = [(f"`taut`, {n} thread{'s' * (n > 1)}", by_threads(n, options.samples)) for n in (1, 2)]
        runs += [(f"`taut-mpi`, {n}", by_processes(n, options.samples)) for n in PROCESSES]
        found = least([words for _, words in runs], options.repeat, folder)
        yield (f"{options.samples} samples of `{options.net}` on {os.cpu_count()} cores, by `/usr/bin/python3 benchmarks/scaling.py "
               f"--samples {options.samples} --repeat {options.repeat} --write`:\n")
        yield from heading("processes | time [s] | processor time [s] | of one thread's")
        for (label, _), (wall, used) in zip(runs, found):
            yield f"| {label} | {wall:.2f} | {used:.2f} | {100 * used / found[0][1]:.0f} % |"
        share = options.samples // 2
        found = least([by_processes(n, n * share) for n in PROCESSES], options.repeat, folder)
        yield ""
        yield from heading(f"processes, {share} samples each | time [s] | processor time for each process [s]")
        for n, (wall, used) in zip(PROCESSES, found):
            yield f"| {n} | {wall:.2f} | {used / n:.2f} |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--net", default="hilo-quarter")
    parser.add_argument("--samples", type=int, default=2000)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--write", action="store_true", help="put the tables into docs/performance.md")
    show("performance.md", __file__, lines(parser.parse_args()))


if __name__ == "__main__":
    main()
