#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Pins the newest versions of the Python packages that our scripts use, and of all that these need, in
# scripts/requirements/*.txt; of those that have a part in a wheel, or come before, with their hashes.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/venv.sh uv
for name in uv app build wheel windows lint docs test; do
    oldest=3.11
    [[ "$name" != windows ]] || oldest=3.12
    [[ "$name" != build ]] || oldest=3.9  # of the wheels
    options=(--quiet --upgrade --universal --python-version "$oldest" --no-annotate --no-header)
    [[ "$name" =~ ^(docs|test)$ ]] || options+=(--generate-hashes)
    sources=("scripts/requirements/$name.in")
    [[ "$name" != test ]] || sources+=(pyproject.toml --extra test)
    build/venv/uv/bin/uv pip compile "${options[@]}" "${sources[@]}" --output-file "scripts/requirements/$name.txt"
done
