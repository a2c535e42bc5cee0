#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds the API reference of the public headers in build/reference. Fails on any warning of Doxygen:
# a class, function, enumeration or field without a comment, a name in a comment that is not there.
set -euo pipefail
cd "$(dirname "$0")/.."

rm -rf build/reference
mkdir -p build/reference
version=$(sed -n 's/.*project(taut.* VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
{
    cat docs/reference/Doxyfile
    echo "PROJECT_NUMBER = $version"
} | doxygen - 2>build/reference.log

if [ -s build/reference.log ]; then
    cat build/reference.log >&2
    echo "reference.sh: Doxygen warns" >&2
    exit 1
fi
echo "build/reference/index.html"
