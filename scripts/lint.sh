#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Checks licence lines, rooms, format, the viewer's types and imports, and by clang-tidy what has changed, or
# all with --all. Fails when one of them does, after all of them. Where all has passed, .ci/checked names the
# commit, which is to be committed: from then on what has changed since is looked at.
# Usage: scripts/lint.sh [--all]
set -euo pipefail
cd "$(dirname "$0")/.."

all=
[[ "${1:-}" != --all ]] || all=yes
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

# The commit that a source is compared with: where this branch left main, or, on main itself, the one whose
# whole tree --all last looked at. Nothing where neither is known.
compared_with() {
    local head base
    head=$(git rev-parse HEAD 2>/dev/null) || return 0
    base=$(git merge-base HEAD origin/main 2>/dev/null) || base=$head
    if [[ "$base" == "$head" ]]; then
        base=$(cat .ci/checked 2>/dev/null) || return 0
        git merge-base --is-ancestor "$base" HEAD 2>/dev/null || return 0
    fi
    echo "$base"
}

# Whether what decides how sources are looked at has changed since a commit.
settings_changed_since() {
    ! git diff --quiet "$1" -- .clang-tidy scripts/lint.sh CMakePresets.json cmake
}

# A source that includes the header, itself or by another header.
source_with() { # header
    local users user
    users=$(grep --recursive --files-with-matches --fixed-strings \
        "#include \"$(sed -E 's,^(include|src|apps/[^/]*)/,,' <<<"$1")\"" include src apps | sort) || true
    user=$(grep --max-count=1 '\.cpp$' <<<"$users") || user=$(head -n 1 <<<"$users")
    case "$user" in
        "" | *.cpp) echo "$user" ;;
        *) source_with "$user" ;;
    esac
}

# Sources that have changed since a commit, and for each header that has, one that includes it. Those for
# other systems are not compiled here.
changed_since() {
    local file
    { git diff --name-only --diff-filter=d "$1" && git ls-files --others --exclude-standard; } |
        grep --extended-regexp '^(src|apps|include)/.*pp$' |
        grep --invert-match --extended-regexp '(wasi|windows)\.cpp$' | sort --unique | while IFS= read -r file; do
        case "$file" in
            *.cpp) echo "$file" ;;
            *) source_with "$file" ;;
        esac
    done | sort --unique | sed '/^$/d'
}

# clang-tidy on the library and the program: on each source that has changed, or, where these are many or
# not known, or with --all, on all of them. Then some sources are taken as one: what they include is read once, which
# takes most of the time. Names of other sources are then in sight, and may be shadowed.
clang_tidy() {
    local folder=build/tidy checks="" base="" files=() unity=OFF
    [[ $all ]] || base=$(compared_with)
    if [[ "$base" ]]; then
        echo "lint: what has changed since ${base:0:10}"
        mapfile -t files < <(changed_since "$base")
        # So many, one by one, take longer than all.
        if ((${#files[@]} > 40)) || settings_changed_since "$base"; then
            base=""
        fi
    fi
    if [[ "$base" ]]; then
        ((${#files[@]} > 0)) || return 0
    else
        unity=ON
        checks="-bugprone-suspicious-include,-clang-diagnostic-shadow"
    fi
    cmake --log-level=WARNING --preset release -B "$folder" -DCMAKE_UNITY_BUILD=$unity -DCMAKE_UNITY_BUILD_BATCH_SIZE=24 \
        -DTAUT_WARNINGS_AS_ERRORS=OFF \
        -DTAUT_BUILD_TESTS=OFF -DTAUT_BUILD_EXAMPLES=OFF -DTAUT_BUILD_BENCHMARKS=OFF || return 1
    if [[ ! "$base" ]]; then
        mapfile -t files < <(/usr/bin/python3 -c \
            'import json, sys; [print(entry["file"]) for entry in json.load(sys.stdin)]' <"$folder/compile_commands.json" |
            grep --invert-match --extended-regexp 'viewer_page|verify_interface')
    fi
    printf '%s\0' "${files[@]}" | xargs --null --max-args=1 --max-procs="$(nproc)" \
        bash -c 'set -o pipefail
            clang-tidy-19 --quiet -p "$0" --checks="$1" "$2" 2>&1 | { grep -v "warnings generated\.$" || true; }' \
        "$folder" "$checks"
}

# Types and import circles of the report's viewer. Before the first build there is no schema to make types
# from; the test viewer.check does the same.
check_viewer() (
    [[ -f build/release/result.schema.json ]] || exit 0
    cd viewer || exit
    [[ -d node_modules/typescript && node_modules/.package-lock.json -nt package-lock.json ]] ||
        npm ci --ignore-scripts --no-audit --no-fund --loglevel=error || exit
    npm run --silent check
)

step "licence lines" check_licence_lines
step "rooms" /usr/bin/python3 scripts/check_rooms.py
step "rooms, self-test" /usr/bin/python3 scripts/check_rooms.py --self-test
step "picture of the rooms" /usr/bin/python3 scripts/room_picture.py --check
step "theory" /usr/bin/python3 scripts/check_theory.py
step "links" /usr/bin/python3 scripts/check_links.py
step "links, self-test" /usr/bin/python3 scripts/check_links.py --self-test
step "format" clang-format-19 --dry-run --Werror "${sources[@]}"
step "Python" scripts/python.sh lint
step "viewer" check_viewer
step "names and bugs" clang_tidy
if [[ $all && $status == 0 && -z "$(git status --porcelain)" ]]; then
    git rev-parse HEAD >.ci/checked
    echo "lint: .ci/checked names this commit: commit it"
fi
exit $status
