#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Lists our own C++ files, one a line.
set -euo pipefail
cd "$(dirname "$0")/.."
find include src apps tests examples benchmarks python \( -name '*.hpp' -o -name '*.cpp' \) -type f | sort
