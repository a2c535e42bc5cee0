# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# For .ci/run and scripts/nightly.sh, which source it: `step COMMAND...` runs a command, says how long it
# took, and ends the run where it fails; `print_times` prints the table of all steps. `beside FUNCTION` runs
# the steps of a function at the same time as those that follow, until `join`: most of its steps take one
# core, and what compiles takes the other. What it prints is shown when it has ended.

# What an earlier run on this machine has compiled from the same text is taken from there, wherever the
# clone lies. CCACHE_DISABLE=1 compiles everything.
export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 CCACHE_MAXSIZE=5G
export CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_EXTRAFILES=$PWD/tests/sanitizer_ignorelist.txt

run_name=${run_name:-ci}
declare -a step_rows=()
lane=

step() {
    local start=$SECONDS
    echo "$run_name: $*"
    if ! "$@"; then
        echo "$run_name: FAILED after $((SECONDS - start)) s: $*" >&2
        print_times >&2
        exit 1
    fi
    step_rows+=("$(printf '%6d s  %s' $((SECONDS - start)) "$*")")
    echo "$run_name: passed in $((SECONDS - start)) s: $*"
}

print_times() {
    ((${#step_rows[@]} == 0)) || printf "$run_name: %s\n" "${step_rows[@]}"
}

beside() { # function
    lane=$(mktemp -d)
    set -m  # a process group of its own, which can be ended whole
    (
        step_rows=()
        trap 'printf "%s\n" "${step_rows[@]}" >"$lane/rows"' EXIT
        "$1"
    ) >"$lane/log" 2>&1 </dev/null &
    lane_process=$!
    set +m
    trap end_lane EXIT
}

# Where a step fails while others run beside it.
end_lane() {
    kill -- -"$lane_process" 2>/dev/null || true
    wait "$lane_process" 2>/dev/null || true
    cat "$lane/log"
    rm -rf "$lane"
}

join() {
    local status=0
    wait "$lane_process" || status=$?
    trap - EXIT
    cat "$lane/log"
    mapfile -t -O "${#step_rows[@]}" step_rows <"$lane/rows"
    rm -rf "$lane"
    if ((status != 0)); then
        echo "$run_name: FAILED in the steps that ran beside others" >&2
        print_times >&2
        exit 1
    fi
}
