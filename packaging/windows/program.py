# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""`taut` on Windows: the program lies in the package, beside the libraries that both need."""

import subprocess
import sys
from pathlib import Path


def main() -> int:
    with subprocess.Popen([Path(__file__).with_name("taut.exe"), *sys.argv[1:]]) as program:
        while True:
            try:
                return program.wait()
            except KeyboardInterrupt:  # which the program has got, too
                continue
