#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Checks licence lines, rooms, format and clang-tidy. Fails when one of them does, after all of them.
set -euo pipefail
cd "$(dirname "$0")/.."

# A check that passed is skipped until a source of ours or the settings change.
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

# clang-tidy on the sources of the library and the program, some as one: what they include is read
# once, which takes most of the time. Names of other sources are then in sight, and may be shadowed.
clang_tidy() {
    local folder=build/tidy checks="-bugprone-suspicious-include,-clang-diagnostic-shadow" checked seen file stamp
    cmake --log-level=WARNING --preset release -B "$folder" -DCMAKE_UNITY_BUILD_BATCH_SIZE=24 -DTAUT_WARNINGS_AS_ERRORS=OFF \
        -DTAUT_BUILD_TESTS=OFF -DTAUT_BUILD_EXAMPLES=OFF -DTAUT_BUILD_BENCHMARKS=OFF || return 1
    mapfile -t checked < <(printf '%s\n' "${sources[@]}" | grep --invert-match '^python/')
    seen=$(cat .clang-tidy "${checked[@]}" <(printf '%s\n' "$checks" "${checked[@]}") | sha256sum)
    mkdir -p $stamps
    /usr/bin/python3 -c 'import json, sys; [print(entry["file"]) for entry in json.load(sys.stdin)]' \
        <"$folder/compile_commands.json" | grep --invert-match --extended-regexp 'viewer|result_schema|verify_interface' |
        while IFS= read -r file; do
            stamp=$stamps/$(echo "$seen $file" | sha256sum | cut -c 1-32)
            [[ -e $stamp ]] || printf '%s\0%s\0' "$file" "$stamp"
        done | xargs --null --no-run-if-empty --max-args=2 --max-procs="$(nproc)" \
        bash -c 'set -o pipefail
            clang-tidy-19 --quiet -p "$0" --checks="$1" "$2" 2>&1 | { grep -v "warnings generated\.$" || true; } \
                && touch "$3"' "$folder" "$checks"
}

step "licence lines" check_licence_lines
step "rooms" /usr/bin/python3 scripts/check_rooms.py
step "rooms, self-test" /usr/bin/python3 scripts/check_rooms.py --self-test
step "theory" /usr/bin/python3 scripts/check_theory.py
step "format" clang-format-19 --dry-run --Werror "${sources[@]}"
step "Python" scripts/python.sh lint
step "names and bugs" clang_tidy
exit $status
