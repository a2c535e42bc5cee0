# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# For .ci/run and scripts/nightly.sh, which source it: `step COMMAND...` runs a command, says how long it
# took, and ends the run where it fails; `print_times` prints the table of all steps.
run_name=${run_name:-ci}
declare -a step_rows=()

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
