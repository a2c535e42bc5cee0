# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Guards against a wheel that hands on the code of others without their licences."""

import importlib.util
import shutil
import zipfile
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "scripts" / "wheel_licences.py"
spec = importlib.util.spec_from_file_location("wheel_licences", SCRIPT)
wheel_licences = importlib.util.module_from_spec(spec)
spec.loader.exec_module(wheel_licences)

INFO = "taut-1.dist-info"
THERE = f"{INFO}/licenses/third-party"
BLAS = "taut.libs/libscipy_openblas-0123abcd.so"
GOOD = {
    BLAS: "code",
    f"{THERE}/INDEX.txt": f"{BLAS}\tOpenBLAS\tOpenBLAS.txt\n",
    f"{THERE}/OpenBLAS.txt": "Copyright",
    f"{INFO}/METADATA": "Name: taut\nLicense-File: third-party/OpenBLAS.txt\n\nLong text\n",
}
CURL = "taut.libs/libcurl-0123abcd.so.4"
DLL = "taut/libcurl.dll"


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({}, []),
        ({f"{THERE}/INDEX.txt": ""}, [f"{BLAS}: no licence", "INDEX.txt: missing"]),
        ({f"{THERE}/OpenBLAS.txt": ""}, ["OpenBLAS.txt: missing or empty"]),
        ({f"{INFO}/METADATA": "Name: taut\n\n"}, ["OpenBLAS.txt: METADATA has no License-File"]),
        ({CURL: "code"}, [f"{CURL}: no licence", f"{CURL}: not among the libraries"]),
        ({DLL: "code"}, [f"{DLL}: no licence", f"{DLL}: not among the libraries"]),
    ],
    ids=[
        "complete",
        "no index",
        "empty licence",
        "not in the metadata",
        "another library",
        "of Windows",
    ],
)
def test_a_wheel_is_held_to_the_licences_of_what_is_in_it(tmp_path, change, expected):
    wheel = tmp_path / "taut-1-py3-none-any.whl"
    with zipfile.ZipFile(wheel, "w") as archive:
        for name, text in (GOOD | change).items():
            archive.writestr(name, text)
    found = wheel_licences.problems(wheel)
    assert len(found) == len(expected)
    for problem, part in zip(found, expected, strict=True):
        assert part in problem


@pytest.mark.skipif(not shutil.which("dpkg"), reason="asks Debian's packages")
def test_a_library_of_no_package_is_refused():
    with pytest.raises(wheel_licences.MissingLicenceError, match=r"nobodys\.h"):
        wheel_licences.add_debian_libraries(wheel_licences.Notices(), ["nobodys.h"])
