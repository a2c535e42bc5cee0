# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Calls of the system, and of malloc, that fail: each of a run in turn. Needs strace and a C compiler."""

from __future__ import annotations

import os
import random
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path
from queue import SimpleQueue

from sandbox import Finding, Sandbox, judge

#: What a disk or a system refuses, and in which words.
CALLS = {
    "write": "ENOSPC", "pwrite64": "ENOSPC", "fsync": "EIO", "rename": "EACCES", "linkat": "ENOSPC",
    "openat": "EMFILE", "mmap": "ENOMEM", "mkdir": "EACCES", "read": "EIO", "unlink": "EACCES",
    "clone3": "EAGAIN",
}  # fmt: skip

#: Commands that write: words, what they read, what they may write. Of the smallest net, as each call fails in turn.
WRITERS = {
    "sample": (["sample", "tiny.json", "-n", "3", "-o", "out.h5", "--quiet"], ("tiny.json",), ("out.h5", "out.h5.partial")),
    "reproduce": (
        ["reproduce", "--net", "tiny.json", "--samples", "5", "--validation", "1", "-o", "study", "--keep", "--quiet"],
        ("tiny.json",), ("study/",),
    ),
    "import": (["import", "tiny_compas.json", "-o", "out.json", "--axial-stiffness", "100kN"], ("tiny_compas.json",), ("out.json",)),
    "export": (["export", "tiny.json", "--to", "compas", "-o", "out.json"], ("tiny.json",), ("out.json",)),
}  # fmt: skip

FAIL_MALLOC = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <stdio.h>
#include <sys/syscall.h>
#include <unistd.h>
/* The n-th call of malloc, and those after it as many as TIMES, find no memory. The program has a
   malloc of its own, which asks __libc_malloc. */
static atomic_long calls;
static long first = -1, times = 1;
static void* (*real)(size_t);
__attribute__((constructor)) static void begin(void) {
    real = dlsym(RTLD_NEXT, "__libc_malloc");
    const char* n = getenv("FAIL_MALLOC");
    const char* t = getenv("FAIL_MALLOC_TIMES");
    if (t) times = atol(t);
    if (n) first = atol(n);
    atomic_store(&calls, 0);
}
static void count(void) {
    if (getenv("COUNT_MALLOC")) {
        FILE* file = fopen(getenv("COUNT_MALLOC"), "w");
        if (file) { fprintf(file, "%ld\n", atomic_load(&calls)); fclose(file); }
    }
}
void _Exit(int code) {
    count();
    syscall(SYS_exit_group, code);
    __builtin_unreachable();
}
void* __libc_malloc(size_t size) {
    if (!real) real = dlsym(RTLD_NEXT, "__libc_malloc");
    long n = atomic_fetch_add(&calls, 1) + 1;
    if (first >= 0 && n >= first && n < first + times) return 0;
    return real(size);
}
"""


def can_inject() -> str:
    """Why calls cannot be made to fail here; empty where they can."""
    if shutil.which("strace") is None:
        return "strace is not installed"
    tried = subprocess.run(["strace", "-o", "/dev/null", "true"], capture_output=True, check=False)
    return "" if tried.returncode == 0 else "strace may not trace here"


def _prepare(sandbox: Sandbox, originals: Path, reads: tuple[str, ...], writes: tuple[str, ...]):
    sandbox.reset()
    for name in reads:
        shutil.copyfile(originals / name, sandbox.folder / name)
    for name in writes:
        if not name.endswith(("/", ".partial", ".h5")):
            sandbox.write(name, b"old")


@cache
def _calls(sandbox: Sandbox, originals: Path, command: str) -> dict[str, range]:
    """Which of a run's calls may fail, by their numbers: of mmap those after the loader's, which ends without a word."""
    words, reads, writes = WRITERS[command]
    _prepare(sandbox, originals, reads, writes)
    log = sandbox.folder.parent / f"trace-{sandbox.folder.name}"
    traced = ",".join([*CALLS, "munmap"])
    sandbox.run(*words, wrap=["strace", "-f", "-o", str(log), "-e", f"trace={traced}"])
    trace = log.read_text(errors="replace")
    made = re.findall(r"^\d+ +(\w+)\(", trace, re.MULTILINE)
    # Its last act is to give back its list of libraries.
    cache = re.search(r"/ld\.so\.cache.*?mmap\([^\n]*= (0x\w+)", trace, re.DOTALL)
    loader = trace[: trace.index(f"munmap({cache[1]},")] if cache else ""
    first = {"mmap": loader.count(" mmap(") + 1}
    return {call: range(first.get(call, 1), made.count(call) + 1) for call in CALLS if call in made}


def _hold(sandbox: Sandbox, originals: Path, command: str, keywords: dict, what: str):
    words, reads, writes = WRITERS[command]
    _prepare(sandbox, originals, reads, writes)
    run = sandbox.run(*words, **keywords)
    # What the loader says before the program begins.
    if run.code == 127 or b"error while loading" in run.err:
        return
    try:
        judge(run, writes)
    except Finding as finding:
        raise Finding(f"{what} in {finding}") from None


def fail_call(sandbox: Sandbox, originals: Path, command: str, call: str, n: int):
    """The n-th of a call fails, from 1."""
    inject = f"inject={call}:error={CALLS[call]}:when={n}"
    wrap = ["strace", "-f", "-o", "/dev/null", "-e", f"trace={call}", "-e", inject]
    _hold(sandbox, originals, command, {"wrap": wrap}, f"{call} {n} fails")


@cache
def _library(folder: Path) -> Path:
    source, library = folder / "fail_malloc.c", folder / "fail_malloc.so"
    source.write_text(FAIL_MALLOC)
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", library, source, "-ldl"], check=True)
    return library


@cache
def _malloc_count(sandbox: Sandbox, originals: Path, command: str) -> int:
    words, reads, writes = WRITERS[command]
    _prepare(sandbox, originals, reads, writes)
    count = sandbox.folder.parent / "count"
    library = _library(originals.parent)
    sandbox.run(*words, environment={"LD_PRELOAD": str(library), "COUNT_MALLOC": str(count)})
    return int(count.read_text())


def fail_malloc(sandbox: Sandbox, originals: Path, command: str, n: int, times: int):
    """The n-th call of malloc finds no memory, and some after it."""
    environment = {
        "LD_PRELOAD": str(_library(originals.parent)),
        "FAIL_MALLOC": str(n), "FAIL_MALLOC_TIMES": str(times),
    }  # fmt: skip
    _hold(sandbox, originals, command, {"environment": environment}, f"malloc {n} ({times}) fails")


def faults(rng: random.Random, sandbox: Sandbox, originals: Path):
    """One call of a run fails."""
    command = rng.choice(list(WRITERS))
    if rng.random() < 0.5:
        # Those before main() are the libraries'.
        n = rng.randint(500, _malloc_count(sandbox, originals, command))
        fail_malloc(sandbox, originals, command, n, rng.choice([1, 1, 10, 10**9]))
        return
    calls = _calls(sandbox, originals, command)
    call = rng.choice(list(calls))
    fail_call(sandbox, originals, command, call, rng.choice(calls[call]))


#: Calls of malloc that fail in turn, at most: a run makes tens of thousands.
MOST_MALLOCS = 6_000
LAST_MALLOCS = 60  # of a command: while its output takes its place


def every_fault(sandbox: Sandbox, originals: Path) -> dict[str, tuple[int, list[str]]]:
    """Each call of each command fails in turn, of malloc every few: of each kind how many, and what was found."""
    mallocs = {command: _malloc_count(sandbox, originals, command) for command in WRITERS}
    stride = -(-sum(mallocs.values()) // MOST_MALLOCS)
    of_malloc = f"one of {stride} calls of malloc, and each of the last {LAST_MALLOCS}"
    work: dict[str, list] = {"each call of the system": [], of_malloc: []}
    for command in WRITERS:
        for call, numbers in _calls(sandbox, originals, command).items():
            work["each call of the system"] += [(fail_call, command, call, n) for n in numbers]
        work[of_malloc] += [
            (fail_malloc, command, n, 1)
            for n in range(1, mallocs[command] + 1)
            if (n - 1) % stride == 0 or n > mallocs[command] - LAST_MALLOCS
        ]
    free = SimpleQueue()
    for index in range(os.cpu_count() or 1):
        folder = sandbox.folder.parent / f"work-{index}"
        folder.mkdir()
        free.put(Sandbox(Path(sandbox.program), folder))

    def one(job) -> str:
        own = free.get()
        try:
            job[0](own, originals, *job[1:])
        except Finding as finding:
            return str(finding)
        finally:
            free.put(own)
        return ""

    result = {}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for kind, jobs in work.items():
            result[kind] = (len(jobs), [found for found in pool.map(one, jobs) if found])
    return result
