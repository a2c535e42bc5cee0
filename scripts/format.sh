#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Formats our own C++ files in place.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/list_sources.sh | xargs clang-format-19 -i
