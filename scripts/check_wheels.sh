#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Installs the wheels of scripts/wheels.sh on bare systems of Debian and identifies and plans there, from Python and by
# the program. As root, since debootstrap makes the systems, in build/systems; they have Python and nothing else.
# Usage: scripts/check_wheels.sh [SUITE...], by default bullseye bookworm trixie sid: glibc 2.31 and later
set -euo pipefail
cd "$(dirname "$0")/.."
(($# > 0)) || set -- bullseye bookworm trixie sid
scripts/venv.sh uv

for suite in "$@"; do
    system="$PWD/build/systems/$suite"
    if [[ ! -e "$system/made" ]]; then
        debootstrap --variant=minbase --include=python3 "$suite" "$system" http://deb.debian.org/debian >/dev/null
        touch "$system/made"
    fi
    version="$(chroot "$system" python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')"
    rm -rf "$system/opt/taut"
    build/venv/uv/bin/uv pip install --quiet --python-version "$version" --python-platform x86_64-manylinux_2_28 \
        --only-binary :all: --target "$system/opt/taut" --find-links build/python/wheels taut
    cp packaging/check_wheel.py "$system/opt"
    echo "$suite: glibc $(chroot "$system" ldd --version | sed -n '1s/.* //p'), Python $version"
    # bin/taut would call the Python of this machine.
    # shellcheck disable=SC2016 # of the inner shell
    unshare --mount sh -c 'mount -t proc proc "$1/proc" && exec chroot "$1" env PYTHONPATH=/opt/taut \
        PATH="/opt/taut/taut.scripts:$PATH" python3 /opt/check_wheel.py' sh "$system"
done
