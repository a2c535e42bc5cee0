#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Puts the licences of all foreign code in a wheel into it, and checks that each library has one.

Whose code that is comes from the build: the library that auditwheel brought along, the headers that the
compiler read, and the crates of the conic solver. A licence that is not found is an error.

Usage: wheel_licences.py WHEEL BUILD ZIGLANG ROOT HDF5       adds those of the build folder BUILD with these parts
                                                             (scripts/wheels.sh), and checks
       wheel_licences.py WHEEL BUILD mingw ROOT HDF5 RUST    the same for Windows (scripts/windows.sh)
       wheel_licences.py WHEEL                               checks
"""

import email
import html
import json
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDER = "third-party"
# What may come along. Another library is a decision: in a wheel it ages without the updates of the
# system. Debian's HDF5, for one, would bring a network stack.
LIBRARIES = re.compile(r"libscipy_openblas\b|libhdf5\.dll$")
# A header of each package of Debian whose headers or sources are compiled in. pugixml's source comes from
# elsewhere, under the licence that Debian has of it. Boost's asks for nothing of what a compiler made.
HEADERS = (
    "CLI/CLI.hpp",
    "eigen3/Eigen/Core",
    "fast_float/fast_float.h",
    "fmt/core.h",
    "minizip/zip.h",
    "nlohmann/json.hpp",
    "pugixml.hpp",
    "valijson/validator.hpp",
    "zlib.h",
)
LINKED_HEADERS = ("metis.h", "nlopt.h", "oneapi/tbb/version.h")
MINGW = (Path("/usr/lib/gcc/x86_64-w64-mingw32"), Path("/usr/share/mingw-w64"))
PYTHON = re.compile(r"/include/python3\.\d+/")
LICENCE = re.compile(r"(licen[cs]e|copying|copyright|notice|unlicense)", re.IGNORECASE)


class MissingLicenceError(Exception):
    """No licence was found of what is in the wheel."""


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def owners(*patterns):
    """The Debian package of each installed file that a pattern names: {path: package}."""
    found = {}
    for start in range(0, len(patterns), 500):
        for line in output_of("dpkg", "-S", *patterns[start : start + 500]).splitlines():
            packages, _, path = line.partition(": ")
            if not packages.startswith("diversion by "):
                found[path] = packages.split(",")[0].split(":")[0]
    return found


def text_of(files):
    return "\n\n".join(file.read_text(encoding="utf-8", errors="replace") for file in files)


def licence_files(folder):
    return sorted(file for file in folder.iterdir() if file.is_file() and LICENCE.match(file.name))


class Notices:
    """Texts by the name of what they are for, and what in the wheel that is."""

    def __init__(self):
        self.texts = {}
        self.index = []

    def add(self, what, name, text, version=""):
        if not text.strip():
            raise MissingLicenceError(f"{what}: no licence found of {name}")
        same = next((other for other, known in self.texts.items() if known == text), name)
        self.texts[same] = text
        entry = f"{what}\t{name}{version}\t{same}.txt"
        if entry not in self.index:
            self.index.append(entry)

    def add_debian(self, what, package):
        """Debian's copyright file, and what it points to on a Debian system."""
        file = Path("/usr/share/doc", package, "copyright")
        if not file.is_file():
            raise MissingLicenceError(f"{what}: expected {file}, the licence of {package}")
        text = text_of([file])
        version = output_of("dpkg-query", "--show", "--showformat", "${Version}", package)
        self.add(what, package, text, f" {version}")
        for name in re.findall(r"/usr/share/common-licenses/([\w.+-]*\w)", text):
            common = Path("/usr/share/common-licenses", name)
            if common.is_file():
                self.texts[f"common-licenses/{name}"] = text_of([common])


def add_debian_libraries(notices, headers):
    """Of libraries of Debian, by a header of each."""
    found = owners(*(f"/usr/include/{header}" for header in headers))
    for header in headers:
        if (file := f"/usr/include/{header}") not in found:
            raise MissingLicenceError(f"{file}: no package of Debian has it")
        notices.add_debian(header, found[file])


def check_headers(build, known):
    """That the compiler read no header, as ninja knows, but in these folders and of Python."""
    said = output_of("ninja", "-C", str(build), "-t", "deps")
    read = {Path(line.strip()).resolve() for line in said.splitlines() if line.startswith("    /")}
    if not read:
        raise MissingLicenceError(f"{build}: ninja knows of no header, expected a build")
    known = [build, *known, *(ROOT / name for name in ("include", "src", "apps", "python", "extern"))]
    for file in sorted(read):
        is_known = "site-packages" in file.parts or PYTHON.search(str(file))
        if not is_known and not any(file.is_relative_to(part) for part in known):
            raise MissingLicenceError(f"{file}: no package says whose header this is")
    return read


def add_python_packages(notices, read):
    """Of Python packages whose headers were read."""
    folders = set()
    for file in sorted(read):
        if "site-packages" not in file.parts or "ziglang" in file.parts:
            continue
        folders.add(Path(*file.parts[: file.parts.index("site-packages") + 2]))
        if "ext" in file.parts:  # a package within the package: its licence heads its files
            name = file.parts[file.parts.index("ext") + 1]
            head = re.match(r"\s*/\*.*?\*/", file.read_text(encoding="utf-8"), re.DOTALL)
            notices.add("headers", name, head.group() if head else "")
    for folder in sorted(folders):
        info = next(folder.parent.glob(f"{folder.name}-*.dist-info"))
        files = [*licence_files(info), *sorted(f for f in info.glob("licenses/*") if f.is_file())]
        notices.add("headers", info.name.removesuffix(".dist-info"), text_of(files))


def add_crates(notices, cargo, target=""):
    """Of the crates that are linked: those that work while others are compiled are not."""
    target = target or re.search(r"host: (.*)", output_of(cargo, "-vV")).group(1)
    said = output_of(cargo, "metadata", "--locked", "--format-version=1", "--filter-platform", target,
                     "--manifest-path", str(ROOT / "extern/clarabel_c/Cargo.toml"))  # fmt: skip
    metadata = json.loads(said)
    packages = {package["id"]: package for package in metadata["packages"]}
    links = {node["id"]: node["deps"] for node in metadata["resolve"]["nodes"]}
    root = metadata["resolve"]["root"]
    linked, waiting = set(), [root]
    while waiting:
        crate = waiting.pop()
        if crate in linked or any("proc-macro" in t["kind"] for t in packages[crate]["targets"]):
            continue
        linked.add(crate)
        waiting += [
            d["pkg"] for d in links[crate] if any(k["kind"] is None for k in d["dep_kinds"])
        ]
    for crate in sorted(linked - {root}):
        package = packages[crate]
        files = licence_files(Path(package["manifest_path"]).parent)
        notices.add("crate", f"{package['name']}-{package['version']}", text_of(files))


def add_rust(notices, rustc):
    """Of Rust's own library: Debian's, or that of rustup."""
    libraries = Path(output_of(str(rustc), "--print", "target-libdir").strip())
    owner = owners(f"{libraries}/libstd-*.rlib")
    if owner:
        notices.add_debian("crate", next(iter(owner.values())))
        return
    documents = Path(output_of(str(rustc), "--print", "sysroot").strip(), "share/doc/rust")
    page = documents / "COPYRIGHT-library.html"
    text = text_of([page] if page.exists() else licence_files(documents))
    plain = html.unescape(re.sub(r"<[^>]*>", "", text)) if page.exists() else text
    notices.add("crate", "rust-standard-library", plain)


def problems(wheel):
    """What the wheel has no licence of, or should not have at all."""
    with zipfile.ZipFile(wheel) as archive:
        sizes = {entry.filename: entry.file_size for entry in archive.infolist()}
        folder = next(
            (n.split("/")[0] for n in sizes if n.split("/")[0].endswith(".dist-info")), ""
        )
        notices = f"{folder}/licenses/{FOLDER}"
        index = {}
        if f"{notices}/INDEX.txt" in sizes:
            for line in archive.read(f"{notices}/INDEX.txt").decode().splitlines():
                what, _, file = line.split("\t")
                index.setdefault(what, []).append(file)
        declared = email.message_from_bytes(archive.read(f"{folder}/METADATA")).get_all(
            "License-File", []
        )
    found = []
    for name in sizes:
        along = ".so" in Path(name).name and name.split("/")[0].endswith(".libs")
        if along or name.endswith(".dll"):
            if name not in index:
                found.append(f"{name}: no licence in the wheel")
            if not LIBRARIES.match(Path(name).name):
                found.append(f"{name}: not among the libraries that may come along")
    for file in sorted({file for files in index.values() for file in files}):
        if not sizes.get(f"{notices}/{file}"):
            found.append(f"{notices}/{file}: missing or empty")
        if f"{FOLDER}/{file}" not in declared:
            found.append(f"{notices}/{file}: METADATA has no License-File of it")
    if not index:
        found.append(f"{notices}/INDEX.txt: missing, expected the licences of what is compiled in")
    return [f"{wheel}: {problem}" for problem in found]


def add(wheel, build, zig, root, hdf5, rust=None):
    """rust: of MinGW-w64, instead of zig."""
    notices = Notices()
    hdf5_text = text_of(licence_files(hdf5 / "installed/share"))
    with zipfile.ZipFile(wheel) as archive:
        for name in archive.namelist():
            if Path(name).name.startswith("libscipy_openblas"):
                notices.add(name, "OpenBLAS", text_of([root / "OpenBLAS.txt"]))
            if name.endswith("libhdf5.dll"):
                notices.add(name, "HDF5", hdf5_text)
    linked = [header for header in LINKED_HEADERS if not (rust and header == "metis.h")]
    add_debian_libraries(notices, [*HEADERS, *linked])
    read = check_headers(build, (*(MINGW if rust else [zig]), root, hdf5))
    add_python_packages(notices, read)
    notices.add("library", "HDF5", hdf5_text)
    cache = (build / "CMakeCache.txt").read_text()
    cargo = re.search(r"TAUT_CARGO:FILEPATH=(.*)", cache).group(1)
    add_crates(notices, cargo, re.search(r"TAUT_CARGO_TARGET:STRING=(.*)", cache).group(1))
    if rust:
        for package in ("g++-mingw-w64-x86-64-posix", "mingw-w64-x86-64-dev"):
            notices.add_debian("library", package)
        copyright = rust / "usr/share/doc/libstd-rust-web-dev/copyright"
        notices.add("crate", "rust-standard-library", text_of([copyright]))
    else:
        notices.add("library", "libc++", text_of([zig / "lib/libcxx/LICENSE.TXT"]))
        add_rust(notices, Path(cargo).with_name("rustc"))
    with tempfile.TemporaryDirectory() as temporary:
        subprocess.run([sys.executable, "-m", "wheel", "unpack", wheel, "--dest", temporary],
                       check=True, stdout=subprocess.DEVNULL)  # fmt: skip
        unpacked = next(Path(temporary).iterdir())
        info = next(unpacked.glob("*.dist-info"))
        files = {f"{name}.txt": text for name, text in notices.texts.items()}
        files["INDEX.txt"] = "\n".join(notices.index) + "\n"
        for name, text in files.items():
            file = info / "licenses" / FOLDER / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        metadata = info / "METADATA"
        lines = "".join(f"License-File: {FOLDER}/{name}\n" for name in sorted(files))
        head, _, rest = metadata.read_text(encoding="utf-8").partition("License-File: LICENSE\n")
        metadata.write_text(f"{head}License-File: LICENSE\n{lines}{rest}", encoding="utf-8")
        subprocess.run([sys.executable, "-m", "wheel", "pack", unpacked, "--dest-dir", temporary],
                       check=True, stdout=subprocess.DEVNULL)  # fmt: skip
        shutil.move(next(Path(temporary).glob("*.whl")), wheel)


def main():
    if len(sys.argv) not in (2, 6, 7):
        print(__doc__, file=sys.stderr)
        return 2
    wheel = Path(sys.argv[1])
    try:
        if len(sys.argv) > 2:
            add(wheel, *(Path(folder).resolve() for folder in sys.argv[2:]))
    except MissingLicenceError as missing:
        print(f"wheel_licences.py: {missing}", file=sys.stderr)
        return 1
    found = problems(wheel)
    print("\n".join(found), end="\n" if found else "", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
