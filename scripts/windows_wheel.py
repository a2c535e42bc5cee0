#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Makes the wheel for Windows out of one for this machine: another module, and the program with its libraries.

Usage: windows_wheel.py WHEEL MODULE PROGRAM TAG FOLDER   of MODULE and all in the folder PROGRAM, into FOLDER;
                                                          TAG: of the wheel, such as cp312-abi3-win_amd64
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

PACKAGING = Path(__file__).resolve().parents[1] / "packaging/windows"


def main(wheel, module, program, tag, folder):
    def run(*arguments):
        subprocess.run([sys.executable, "-m", "wheel", *arguments], check=True, stdout=subprocess.DEVNULL)

    with tempfile.TemporaryDirectory() as temporary:
        run("unpack", wheel, "--dest", temporary)
        unpacked = next(Path(temporary).iterdir())
        package, info = unpacked / "taut", next(unpacked.glob("*.dist-info"))
        for file in package.glob("_taut*.so"):
            file.unlink()
        shutil.rmtree(next(unpacked.glob("*.data")) / "scripts")
        for file in (module, PACKAGING / "program.py", *sorted(Path(program).glob("*.*"))):
            shutil.copy(file, package)
        (info / "entry_points.txt").write_text("[console_scripts]\ntaut = taut.program:main\n", encoding="utf-8")
        text = (info / "WHEEL").read_text(encoding="utf-8")
        (info / "WHEEL").write_text(re.sub("^Tag: .*$", f"Tag: {tag}", text, flags=re.MULTILINE), encoding="utf-8")
        run("pack", unpacked, "--dest-dir", folder)


if __name__ == "__main__":
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    main(*sys.argv[1:])
