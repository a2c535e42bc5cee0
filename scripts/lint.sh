#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Checks licence lines, rooms, format and clang-tidy. Fails when one of them does, after all of them.
set -euo pipefail
cd "$(dirname "$0")/.."

# Its own configuration: clang cannot read the precompiled headers of gcc.
build=build/tidy
# clang-tidy takes seconds a file: one that passed is skipped until it, a header of ours or the
# settings change.
stamps=build/lint

mapfile -t sources < <(scripts/list_sources.sh)
status=0

step() {
    echo "lint: $1"
    shift
    "$@" || status=1
}

check_licence_lines() {
    local file bad=0
    for file in "${sources[@]}"; do
        if [[ "$(head -n 2 "$file")" != "// SPDX-FileCopyrightText: 2026 The taut authors"$'\n'"// SPDX-License-Identifier: MIT" ]]; then
            echo "$file:1: expected the two SPDX lines of the project"
            bad=1
        fi
    done
    return $bad
}

check_names_and_bugs() {
    cmake --log-level=WARNING --preset release -B $build -DTAUT_BUILD_TESTS=OFF \
        -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
    local file stamp common
    common=$(cat .clang-tidy $(printf '%s\n' "${sources[@]}" | grep '\.hpp$') | sha256sum)
    mkdir -p $stamps
    for file in "${sources[@]}"; do
        # What this configuration does not compile, clang-tidy cannot read.
        grep --quiet --fixed-strings "$PWD/$file\"" $build/compile_commands.json || continue
        stamp=$stamps/$(echo "$common" | cat - "$file" <(echo "$file") | sha256sum | cut -c 1-32)
        [[ -e $stamp ]] || printf '%s\0%s\0' "$file" "$stamp"
    done | xargs --null --no-run-if-empty --max-args=2 --max-procs="$(nproc)" \
        bash -c 'set -o pipefail
            clang-tidy-19 --quiet -p "$0" "$1" 2>&1 | { grep -v "warnings generated\.$" || true; } \
                && touch "$2"' $build
}

step "licence lines" check_licence_lines
step "rooms" /usr/bin/python3 scripts/check_rooms.py
step "rooms, self-test" /usr/bin/python3 scripts/check_rooms.py --self-test
step "format" clang-format-19 --dry-run --Werror "${sources[@]}"
step "clang-tidy" check_names_and_bugs
exit $status
