#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Compiles all sources of the libraries and the program for macOS on ARM, by the Clang and Apple's headers of the C
# library that the Python package ziglang carries. Nothing is linked, and nothing can be run here: it shows that the
# sources need nothing of Linux; MPI and the Python module are left out. After make build, whose compilation it repeats.
# Usage: scripts/check_macos.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/cross.sh build/macos

headers() { # place
    copy_headers "$1/include"
    touch "$1/include/features.h" # of glibc, which Debian's configuration of HDF5 asks for
    local name
    for name in cblas.h openblas_config.h metis.h nlopt.h nlopt.hpp oneapi tbb pugiconfig.hpp pugixml.hpp minizip zlib.h zconf.h suitesparse hdf5; do
        local found
        for found in /usr/include/$name /usr/include/*/openblas-pthread/$name /usr/include/*/$name; do
            [[ ! -e "$found" ]] || { ln -s "$found" "$1/include/$name" && break; }
        done
    done
}

prepare_zig
root="$(place headers < <(made_of))"
keep headers "$root"
build/venv/app/bin/python - "$zig/zig" "$root/include" <<'END'
import concurrent.futures, json, os, pathlib, re, shlex, subprocess, sys

zig, headers = sys.argv[1:]
build = pathlib.Path("build/release").resolve()
units = [
    unit
    for unit in json.loads((build / "compile_commands.json").read_text())
    if not re.search("/tests/|verify_interface|viewer_page|print_schema|/benchmarks/|/examples/|/python/|taut-mpi", unit["directory"] + unit["command"])
]
ours = (str(build.parents[1]), str(build))


# Boost before 1.81 takes what C++17 removed, unless it is told so.
older_boost = ["-DBOOST_NO_CXX98_FUNCTION_BASE"]


def compile(index, unit):
    words = shlex.split(unit["command"])
    words = [f"-I{word}" if before == "-isystem" else word for before, word in zip(words, words[1:])]
    kept = [word for word in words if word.startswith(("-D", "-std=", *(f"-I{folder}" for folder in ours)))]
    command = [zig, "c++", "-target", "aarch64-macos", "-fno-sanitize=all", "-w", "-O0", *kept, *older_boost,
               *(f"-isystem{headers}/{folder}" for folder in ["", "hdf5/serial", "suitesparse", "minizip"]), "-c", unit["file"], "-o", f"build/macos/{index}.o"]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True)
    return unit["file"], done.returncode, done.stderr


failed = 0
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for file, code, errors in pool.map(compile, range(len(units)), units):
        if code:
            failed += 1
            print(f"{file}:\n{errors[:4000]}", file=sys.stderr)
print(f"macOS on ARM: {len(units) - failed} of {len(units)} compiled")
sys.exit(bool(failed or not units))
END
