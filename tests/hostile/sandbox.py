# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""A folder in which the program is run, and the contract that every run is held to."""

from __future__ import annotations

import json
import os
import re
import resource
import shutil
import subprocess
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

#: Of a run, beyond which it hangs [s]: where it waits, and where it works on a machine that may be busy. And which its
#: memory may not pass [bytes].
TIME_LIMIT = 60.0
BUSY_TIME_LIMIT = 600.0
MEMORY_LIMIT = 3 << 30

#: Exit codes: done, numerical failure, wrong input, interrupted.
EXIT_CODES = {0, 1, 2, 130}

NOT_A_NUMBER = re.compile(rb"(?<![\w./'-])-?(nan|inf)(?![\w./'-])", re.IGNORECASE)
#: Of a run that fails after outputs have taken their places.
TOLD_AS_WRITTEN = re.compile(rb"files are written, but standard output|\d+ of \d+ outputs are new")
CONTROL = re.compile(rb"[\x00-\x08\x0b-\x1f\x7f]")


class Finding(Exception):
    """A run that broke the contract."""


@dataclass
class Run:
    """What a run did."""

    command: list[str]
    code: int
    out: bytes
    err: bytes
    seconds: float
    memory: int
    before: dict[str, bytes]
    after: dict[str, bytes]

    def __str__(self):
        err = self.err.decode(errors="replace").strip()
        return f"{' '.join(map(repr, self.command))} -> {self.code}: {err[:300]}"


def _contents(folder: Path) -> dict[str, bytes]:
    """Files and links of a folder, and what they hold."""
    found = {}
    for root, folders, files in os.walk(folder):
        for name in files + [f for f in folders if os.path.islink(os.path.join(root, f))]:
            path = os.path.join(root, name)
            key = os.path.relpath(path, folder)
            if os.path.islink(path):
                found[key] = b"link to " + os.fsencode(os.readlink(path))
            elif os.path.isfile(path):
                try:
                    found[key] = Path(path).read_bytes()
                except PermissionError:
                    found[key] = b"not readable"
            else:
                found[key] = b"special"
    return found


def _is_working(process: int) -> bool:
    """Whether a thread of it, or of what it runs, has work to do rather than waits."""
    states = []
    for stat in Path("/proc").glob("[0-9]*/task/*/stat"):
        with suppress(OSError, IndexError):
            fields = stat.read_text().rsplit(")", 1)[1].split()
            own = stat.parts[2] == str(process) or fields[1] == str(process)
            states += [fields[0]] if own else []
    return "R" in states or "D" in states


class Sandbox:
    """Runs of the program in a folder of their own."""

    def __init__(self, program: Path, folder: Path):
        self.program = str(program)
        self.folder = folder
        self.runs = 0
        self._peak = 0  # of all runs so far: the system reports no other

    def _memory(self) -> int:
        """Of the last run, where it took more than all before it; else 0."""
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
        grown, self._peak = peak > self._peak, max(peak, self._peak)
        return peak if grown else 0

    def reset(self):
        """An empty folder."""
        for path in self.folder.iterdir():
            if path.is_dir() and not path.is_symlink():
                os.chmod(path, 0o700)
                shutil.rmtree(path)
            else:
                path.unlink()

    def write(self, name: str, content: bytes | str):
        """A file in the folder."""
        data = content.encode("utf-8", "surrogateescape") if isinstance(content, str) else content
        (self.folder / name).write_bytes(data)

    def read(self, name: str) -> bytes:
        """A file of the folder."""
        return (self.folder / name).read_bytes()

    def run(
        self,
        *words: str,
        limits: dict[int, int] | None = None,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        kill: tuple[float, int] | None = None,
        environment: dict[str, str] | None = None,
        wrap: list[str] | None = None,
        user: int | None = None,
        closed: tuple[int, ...] = (),
    ) -> Run:
        """Runs the program.

        Args:
            words: its arguments.
            limits: of resource.setrlimit.
            stdout, stderr: where these go, as of subprocess.
            kill: after how many seconds which signal is sent.
            environment: variables besides those of this process.
            wrap: what stands before the program.
            user: whose rights it has.
            closed: numbers of streams that are closed for it.
        """
        before = _contents(self.folder)

        def prepare():
            for which, most in (limits or {}).items():
                resource.setrlimit(which, (most, most))
            if user is not None:
                os.setgid(user)
                os.setuid(user)
            for stream in closed:
                os.close(stream)

        command = [*(wrap or []), self.program, *words]
        start = time.monotonic()
        process = subprocess.Popen(
            command,
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=stdout,
            stderr=stderr,
            env={**os.environ, **(environment or {})},
            # Without, the process is made faster.
            preexec_fn=prepare if limits or user is not None or closed else None,
        )
        try:
            if kill is not None:
                try:
                    process.wait(kill[0])
                except subprocess.TimeoutExpired:
                    process.send_signal(kill[1])
            while True:
                try:
                    out, err = process.communicate(timeout=TIME_LIMIT)
                    break
                except subprocess.TimeoutExpired:
                    if time.monotonic() - start > BUSY_TIME_LIMIT or not _is_working(process.pid):
                        raise
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            raise Finding(f"{command} hung for {time.monotonic() - start:.0f} s") from None
        self.runs += 1
        return Run(
            command=[str(word) for word in words],
            code=process.returncode,
            out=out or b"",
            err=err or b"",
            seconds=time.monotonic() - start,
            memory=self._memory(),
            before=before,
            after=_contents(self.folder),
        )


def is_half(name: str, data: bytes) -> bool:
    """Whether a file that the program wrote ends before its end."""
    if name.endswith(".json"):
        try:
            json.loads(data)
        except ValueError:
            return True
        return False
    if name.endswith((".h5", ".h5.partial")):  # its last line is the digest of all before it
        return re.search(rb"\ndigest fnv1a64 [0-9a-f]{16}\n$", data) is None
    if name.endswith(".html"):
        return not data.rstrip().endswith(b"</html>")
    if name.endswith(".csv"):
        rows = [line for line in data.split(b"\n") if not line.startswith(b"#")]
        # Names in quotes may hold commas.
        columns = {row.count(b",") for row in rows[:-1] if b'"' not in row}
        return rows[-1] != b"" or len(columns) > 1
    return name.endswith(".obj") and not data.endswith(b"\n")


def judge(run: Run, outputs: tuple[str, ...] = (), killed: int | None = None):
    """Holds a run to the contract.

    Args:
        outputs: files that it may write; a name that ends in "/" is a folder.
        killed: a signal that was sent to it, which it may have died of if nothing can be done.

    Raises:
        Finding: what is broken.
    """

    def broken(what: str):
        raise Finding(f"{what}: {run}")

    # A signal that comes before main() does what it does to every program.
    codes = EXIT_CODES | ({-killed} if killed is not None else set())
    if run.code not in codes:
        broken(f"exit code {run.code}")
    if run.code == 130 and killed is None:
        broken("interrupted by nobody")
    if run.memory > MEMORY_LIMIT:
        broken(f"{run.memory >> 20} MiB of memory")
    lines = run.err.splitlines()
    errors = [line for line in lines if line.startswith(b"taut: error: ")]
    strange = [line for line in lines if not re.match(rb"taut: (error|warning|note): ", line)]
    if strange:
        broken(f"standard error holds {strange[0][:200]!r}")
    if run.code != 0 and killed is None and len(errors) != 1:
        broken(f"{len(errors)} lines of error")
    if run.code == 0 and errors:
        broken("an error, but exit code 0")
    for name, text in (("output", run.out), ("error", run.err)):
        if CONTROL.search(text):
            broken(f"standard {name} holds a control character")
    if NOT_A_NUMBER.search(run.out):
        broken("standard output holds what is no number")
    may_change = {
        name for name in run.before.keys() | run.after.keys() for output in outputs
        if name == output or (output.endswith("/") and name.startswith(output))
    }  # fmt: skip
    for name in run.before.keys() | run.after.keys():
        old, new = run.before.get(name), run.after.get(name)
        if old == new:
            continue
        if name not in may_change or ".tmp" in name:
            broken(
                f"{name!r} {'appeared' if old is None else 'changed' if new is not None else 'is gone'}"
            )
        if run.code == 2 and killed is None and not TOLD_AS_WRITTEN.search(run.err):
            broken(f"{name!r} was written by a run that failed")
        if new is None:
            broken(f"{name!r} is gone")
        if not new.startswith(b"link to ") and is_half(name, new):
            broken(f"{name!r} is half written")
        if old is not None and old.startswith(b"link to "):
            broken(f"the link {name!r} was replaced")
        if name.endswith((".json", ".csv")) and NOT_A_NUMBER.search(new):
            broken(f"{name!r} holds what is no number")
