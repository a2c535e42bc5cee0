#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Takes the pictures of README.md and docs/ anew, from reports of the program at build/taut,
# and from the app where `make app` has built it.
# Needs what the tests need: Chromium, and the viewer's npm packages.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/demo.sh build/pictures > /dev/null 2>&1
mkdir -p docs/images
cd viewer
[[ -d node_modules/playwright-core ]] || npm ci --ignore-scripts --no-audit --no-fund
node tests/pictures.mjs ../build/pictures/report.html ../build/pictures/plan.html ../docs/images
[[ ! -e ../build/app/taut.html ]] || node tests/app_pictures.mjs ../build/app/taut.html ../docs/images
