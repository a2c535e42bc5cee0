#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds the API reference of the public headers in build/reference. Fails on any warning of Doxygen:
# a class, function or enumeration without a comment, a name in a comment that is not there. A field
# may go without: where its name and the comment of its struct tell all, another would repeat them.
set -euo pipefail
cd "$(dirname "$0")/.."

rm -rf build/reference
mkdir -p build/reference
version=$(sed -n 's/.*project(taut.* VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
{
    cat docs/reference/Doxyfile
    echo "PROJECT_NUMBER = $version"
} | doxygen - 2>build/reference.log

if grep --invert-match "(variable) of \(struct\|class\) .* is not documented" build/reference.log >&2; then
    echo "reference.sh: Doxygen warns" >&2
    exit 1
fi
echo "build/reference/index.html"
