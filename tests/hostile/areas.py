# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""What is done to the program: one function an area, one case a seed."""

from __future__ import annotations

import json
import os
import random
import resource
import shutil
import signal
import subprocess
from contextlib import suppress
from pathlib import Path

import numpy as np
from inputs import COMMANDS, HUGE, changed, changed_bytes, changed_words
from nets import out_of_balance, random_net, to_json
from sandbox import Finding, Sandbox, judge

#: Nobody's.
UNPRIVILEGED = 65534


def _prepared(sandbox: Sandbox, originals: Path) -> None:
    """The folder with an example of each input."""
    sandbox.reset()
    for path in originals.iterdir():
        shutil.copyfile(path, sandbox.folder / path.name)


def inputs(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Files that are almost right."""
    _prepared(sandbox, originals)
    words, reads, writes = rng.choice(COMMANDS)
    name = rng.choice(reads)
    sandbox.write(name, changed(rng, name, sandbox.read(name)))
    judge(sandbox.run(*words), tuple(writes))


def arguments(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Command lines that are almost right."""
    _prepared(sandbox, originals)
    words, reads, writes = rng.choice(COMMANDS)
    words = changed_words(rng, words)
    # What the words name may be written; what the command reads may not.
    named = tuple(w for w in words if w not in reads)
    beside = [f"{w}.partial" for w in named] + [
        f"{w.removesuffix('.json')}_draws.h5" for w in named
    ]
    folders = [f"{w}/" for w in named]
    judge(sandbox.run(*words), (*writes, *named, *beside, *folders))


#: A command that reads HDF5, the file that it reads, and the output that shows whether all was read as written.
READERS = [
    (["identify", "net.json", "survey.csv", "--model", "model.h5", "-o", "out.json", "--draws", "0", "--quiet"], "model.h5", "out.json"),
    (["train", "data.h5", "-o", "out.h5", "--quiet"], "data.h5", "out.h5"),
    (["plan", "net.json", "result.json", "-o", "out.json"], "result_draws.h5", "out.json"),
]  # fmt: skip


def _content(data: bytes, name: str) -> object:
    """A result without the time when it was made."""
    if not name.endswith(".json"):
        return data
    document = json.loads(data)
    for key in ("date", "seconds", "command"):
        document.pop(key, None)
    return document


_expected: dict[str, object] = {}


def damage(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Damaged HDF5: refused, or read as it was."""
    words, name, result = rng.choice(READERS)
    _prepared(sandbox, originals)
    if name not in _expected:
        run = sandbox.run(*words)
        judge(run, ("out.json", "out.h5", "out_draws.h5"))
        _expected[name] = _content(sandbox.read(result), result)
        _prepared(sandbox, originals)
    data = bytearray(sandbox.read(name))
    if rng.random() < 0.8:
        data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    else:
        data = bytearray(changed_bytes(rng, bytes(data)))
    if bytes(data) == sandbox.read(name):
        return
    sandbox.write(name, bytes(data))
    run = sandbox.run(*words)
    judge(run, ("out.json", "out.h5", "out_draws.h5"))
    if run.code == 0 and _content(sandbox.read(result), result) != _expected[name]:
        raise Finding(f"damage of {name} changed the result: {run}")


def limits(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Too little memory, too small files, too few open files."""
    _prepared(sandbox, originals)
    words, _, writes = rng.choice(COMMANDS)
    which = rng.choice([resource.RLIMIT_AS, resource.RLIMIT_FSIZE, resource.RLIMIT_NOFILE])
    most = {
        resource.RLIMIT_AS: rng.choice([150, 200, 250, 300, 400, 600, 1000]) << 20,
        resource.RLIMIT_FSIZE: rng.choice([0, 1, 100, 4096, 100_000]),
        resource.RLIMIT_NOFILE: rng.choice([3, 4, 5, 6, 8, 12]),
    }[which]
    run = sandbox.run(*words, limits={which: most})
    # The loader's and the system's own word comes before the program begins.
    if run.code == 127 and (b"error while loading shared libraries" in run.err):
        return
    judge(run, tuple(writes))


def huge(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Files of up to 300 MB: read, or refused, in bounded memory and time."""
    name, head, part, end = rng.choice(HUGE)
    _prepared(sandbox, originals)
    size = rng.choice([20, 100, 200, 300]) * 1_000_000
    sandbox.write(name, head + part * (size // len(part)) + end)
    words, _, writes = rng.choice([command for command in COMMANDS if name in command[1]])
    run = sandbox.run(*words)
    sandbox.write(name, b"")
    run.before[name] = run.after[name] = b""
    judge(run, tuple(writes))


def full_disk(rng: random.Random, sandbox: Sandbox, originals: Path):
    """A file system without room: outputs are old or new."""
    if os.getuid() != 0:
        return
    words, _, writes = rng.choice([command for command in COMMANDS if command[2]])
    sandbox.reset()
    needed = sum(path.stat().st_size for path in originals.iterdir()) // 1024 + 200
    room = needed + rng.choice([0, 4, 20, 60, 200, 1000])
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", f"size={room}k", "tmpfs", sandbox.folder], check=False
    )
    if mounted.returncode != 0:
        return
    try:
        for path in originals.iterdir():
            shutil.copyfile(path, sandbox.folder / path.name)
        for name in writes:
            if not name.endswith("/"):
                sandbox.write(name, b"old")
        run = sandbox.run(*words)
        judge(run, tuple(writes))
        if b"No space left" in run.err and not any(
            name.rstrip("/").encode() in run.err for name in writes
        ):
            raise Finding(f"the file for which there is no room is not named: {run}")
    finally:
        subprocess.run(["umount", sandbox.folder], check=True)


def streams(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Standard streams that are closed, full, or read by nobody."""
    _prepared(sandbox, originals)
    words, _, writes = rng.choice([*COMMANDS, (["--help"], [], []), (["form", "--help"], [], [])])
    full = open("/dev/full", "wb")  # noqa: SIM115
    choice = rng.randrange(5)
    keywords = [
        {"stdout": full}, {"stderr": full}, {"closed": (1,)}, {"closed": (2,)}, {"closed": (0, 1, 2)},
    ][choice]  # fmt: skip
    with full:
        run = sandbox.run(*words, **keywords)
    # Of a run whose standard error nobody can read no line is seen.
    if choice in (1, 3, 4):
        line = b"taut: error: the work is done and its files are written, but standard output cannot be\n"
        run.err = {0: b"", 2: line if choice == 4 else b"taut: error: \n"}.get(run.code, run.err)
    if choice in (0, 2) and run.code == 0:
        raise Finding(f"standard output could not be written, and no message says so: {run}")
    judge(run, tuple(writes))


def kills(rng: random.Random, sandbox: Sandbox, originals: Path):
    """A signal at any time: outputs are old or new, and nothing else is left."""
    _prepared(sandbox, originals)
    words, _, writes = rng.choice([*COMMANDS, (
        ["reproduce", "--net", "net.json", "--samples", "30", "--validation", "3", "-o", "study", "--keep", "--quiet"], [], ["study/"],
    )])  # fmt: skip
    for name in writes:
        if rng.random() < 0.5 and not name.endswith("/"):
            sandbox.write(name, b"old")
    sent = rng.choice([signal.SIGINT, signal.SIGTERM, signal.SIGKILL, signal.SIGHUP])
    run = sandbox.run(*words, kill=(rng.uniform(0.0, 0.25), sent))
    # A run that is killed while a file takes its place may leave its temporary name: the next run names it.
    left = [name for name in run.after if name.endswith(".tmp")]
    if sent == signal.SIGKILL and left:
        err = sandbox.run(*words).err
        for name in left:
            if os.fsencode(name) not in err:
                raise Finding(f"{name} was left, and no message names it: {run}")
            del run.after[name]
    judge(run, tuple(writes), killed=sent)


def links(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Links, folders, pipes and odd names where files are expected."""
    _prepared(sandbox, originals)
    words, reads, writes = rng.choice([c for c in COMMANDS if c[2]])
    target = rng.choice([*writes[:1], *reads[:1]])
    path = sandbox.folder / target.rstrip("/")
    is_output = target in writes
    if path.exists():
        path.unlink()
    kind = rng.choice(
        ["dangling", "folder", "pipe", "loop", "elsewhere", "unreadable", "read-only"]
    )
    leads_to = []
    user = None
    if kind == "dangling":
        path.symlink_to("nowhere/there" if rng.random() < 0.5 else "other")
        leads_to = ["other", "other/", "nowhere/there/"]
    elif kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        # Nobody writes to it: what reads it would wait for ever, as every program does.
        if not is_output:
            return
        os.mkfifo(path)
    elif kind == "loop":
        path.symlink_to(target)
    elif kind == "elsewhere":
        (sandbox.folder / "inner").mkdir()
        if not is_output:
            shutil.copyfile(originals / target, sandbox.folder / "inner" / "file")
        path.symlink_to("inner/file")
        leads_to = ["inner/file", "inner/file/"]
    elif kind in ("unreadable", "read-only") and os.getuid() == 0:
        if not is_output:
            shutil.copyfile(originals / target, path)
            path.chmod(0o000 if kind == "unreadable" else 0o444)
        user = UNPRIVILEGED  # who may not write into the folder either
    before = {p.name for p in sandbox.folder.iterdir()}
    run = sandbox.run(*words, user=user)
    judge(run, (*writes, *(leads_to if is_output else ())))
    if path.name in before and not os.path.lexists(path):
        raise Finding(f"{path.name} ({kind}) is gone: {run}")


def names(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Files of odd names."""
    _prepared(sandbox, originals)
    name = rng.choice(["a b.json", "-dash.json", "new\nline.json", "\x1b[31mred.json", "ü" * 60, "x" * 255, "x" * 300, "\udcff.json", ".json", "tab\t.json", "'quoted'.json"])  # fmt: skip
    prefix = "./" if name.startswith("-") else ""
    with suppress(OSError):
        shutil.copyfile(originals / "net.json", sandbox.folder / name)
    judge(sandbox.run("form", prefix + name, "-o", "out.csv"), ("out.csv",))
    judge(sandbox.run("example", "hypar:3x4", "-o", prefix + name), (name,))


def locales(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Another language, time zone, or home changes no number."""
    words, _, writes = rng.choice(COMMANDS)
    _prepared(sandbox, originals)
    plain = sandbox.run(*words)
    _prepared(sandbox, originals)
    environment = {
        "LC_ALL": rng.choice(["C", "de_DE.UTF-8", "tr_TR.UTF-8", "C.UTF-8", "nonsense"]),
        "TZ": rng.choice(["UTC", "Asia/Kolkata", "Nowhere/There", ":/etc/passwd"]),
        "HOME": "/nonexistent", "TMPDIR": "/nonexistent",
        "OPENBLAS_NUM_THREADS": rng.choice(["1", "64", "x"]), "OMP_NUM_THREADS": rng.choice(["1", "8"]),
    }  # fmt: skip
    other = sandbox.run(*words, environment=environment)
    judge(other, tuple(writes))
    for name in writes:
        contents = [_content(one.after.get(name, b"{}"), name) for one in (plain, other)]
        if not name.endswith("/") and contents[0] != contents[1]:
            raise Finding(f"{name} depends on the environment {environment}: {other}")


def concurrent(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Several runs that write one file: it is one of theirs."""
    _prepared(sandbox, originals)
    sizes = [rng.randint(2, 12) for _ in range(rng.randint(2, 4))]
    expected = []
    for size in sizes:
        judge(
            sandbox.run("example", f"hypar:{size}x{size}", "-o", "expected.json"),
            ("expected.json",),
        )
        expected.append(sandbox.read("expected.json"))
    running = [
        subprocess.Popen(
            [sandbox.program, "example", f"hypar:{size}x{size}", "-o", "one.json"],
            cwd=sandbox.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
        ) for size in sizes
    ]  # fmt: skip
    for process in running:
        _, err = process.communicate(timeout=60)
        if process.returncode != 0:
            raise Finding(f"of {sizes} at once one failed: {err!r}")
    sandbox.runs += len(sizes)
    if sandbox.read("one.json") not in expected:
        raise Finding(f"of {sizes} at once the file is none of theirs")
    left = [p.name for p in sandbox.folder.iterdir() if ".tmp" in p.name]
    if left:
        raise Finding(f"left: {left}")


def physics(rng: random.Random, sandbox: Sandbox, originals: Path):
    """Random nets: an independent computation confirms the forms."""
    del originals
    sandbox.reset()
    net = random_net(rng)
    sandbox.write("net.json", to_json(net))
    run = sandbox.run("form", "net.json", "--json", "-o", "out.csv")
    judge(run, ("out.csv",))
    if run.code == 2:
        if net["name"] != "far":
            raise Finding(f"refused: {run}")
        return
    if run.code == 1:
        if b"no equilibrium" not in run.err:
            raise Finding(f"failed without a word on equilibrium: {run}")
        return
    result = json.loads(run.out)
    form = np.array(result["form"])
    left, tension_sum, rounding, slack = out_of_balance(net, form)
    taut_count = len(net["edges"]) - len(result["slack_edges"])
    tension = result["mean_tension"]
    load = np.abs(net.get("loads", [[0.0]])).max()
    scale = max(tension, load, 1e-9 * float(np.mean(net["axial_stiffness"])))
    if left > 1e-6 * scale + 2 * rounding:
        raise Finding(
            f"{result['status']}, but {left:.3g} N are left beside {tension:.3g} N: {run}"
        )
    if abs(tension * taut_count - tension_sum) > (1e-6 * scale + 2 * rounding) * len(net["edges"]):
        raise Finding(
            f"tensions of {tension * taut_count:.6g} N in all, which are {tension_sum:.6g} N: {run}"
        )
    energy, gap = abs(result["energy"]), result["duality_gap"]
    # What rounding leaves of the forces, the certificate may have slack edges bear: at their slack a newton.
    if result["status"] == "converged" and gap > 1e-6 * energy + 1e-12 * scale + rounding * slack:
        raise Finding(f"converged, but {gap:.3g} J above the lowest of {energy:.3g} J: {run}")


AREAS = {
    one.__name__: one
    for one in (inputs, arguments, damage, huge, limits, full_disk, streams, kills, links, names, locales, concurrent, physics)
}  # fmt: skip
