#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes the licences of all foreign code that is compiled into the app, as JSON: packages, text.

Usage: app_licences.py ZIGLANG HDF5 RUST OUTPUT, the first three folders
"""

import json
import shutil
import sys
from pathlib import Path

from wheel_licences import (
    HEADERS,
    Notices,
    add_crates,
    add_debian_libraries,
    licence_files,
    text_of,
)


def main(zig, hdf5, rust, output):
    notices = Notices()
    add_debian_libraries(notices, HEADERS)
    notices.add("library", "libc++", text_of([zig / "lib/libcxx/LICENSE.TXT"]))
    notices.add("library", "wasi-libc", text_of(licence_files(zig / "lib/libc/wasi")))
    notices.add("library", "HDF5", text_of(licence_files(hdf5 / "installed/share")))
    add_crates(notices, shutil.which("cargo"))
    copyright = rust / "usr/share/doc/libstd-rust-web-dev/copyright"
    notices.add("library", "Rust's standard library", text_of([copyright]))
    texts = {}
    for entry in notices.index:
        _, name, file = entry.split("\t")
        texts.setdefault(file.removesuffix(".txt"), []).append(name)
    document = [{"packages": names, "text": notices.texts[file]} for file, names in texts.items()]
    output.write_text(json.dumps(document), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(*map(Path, sys.argv[1:]))
