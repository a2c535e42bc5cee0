#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Runs every property test (RapidCheck) of a build with one seed, fresh unless it is given, and says
# which, so that a failure can be repeated: scripts/properties.sh [SEED]. BUILD=build/debug takes
# another build than build/release.
set -euo pipefail
cd "$(dirname "$0")/.."
seed=${1:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
build=${BUILD:-build/release}
echo "properties: seed $seed, to be repeated by: scripts/properties.sh $seed"

failed=()
for folder in tests/*/; do
    room=$(basename "$folder")
    # RC_GTEST_PROP(Suite, Name, and a TEST_F(Suite, Name) that is nothing but a check.
    names=$(find "$folder" -name 'test_*.cpp' -exec perl -0ne '
        print "$1.$2:" while /\bRC_GTEST_PROP\(\s*(\w+),\s*(\w+)/g;
        print "$1.$2:" while /\bTEST_F\(\s*(\w+),\s*(\w+)\)\s*\{\s*EXPECT_TRUE\(rc::check/g' {} +)
    if [ -n "$names" ]; then
        RC_PARAMS="seed=$seed" "$build/tests/$room/test_$room" --gtest_brief=1 --gtest_filter="$names" ||
            failed+=("$room")
    fi
done
if [ ${#failed[@]} -gt 0 ]; then
    echo "properties: FAILED in ${failed[*]} with seed $seed" >&2
    exit 1
fi
echo "properties: passed with seed $seed"
