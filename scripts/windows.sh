#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds taut for Windows 10 and later on 64 bit: build/windows/taut, the program with what it needs beside it and all
# licences; and in build/windows/wheels wheels of the Python package with the same program, for 3.9, which is that of
# Rhino 8, for 3.11, and for 3.12 and all later ones, where there are a python3.9, python3.11 and python3.12. The
# compiler is Debian's MinGW-w64.
# Usage: scripts/windows.sh
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/cross.sh build/windows

root() { # place
    copy_headers "$1/include"
    build_libraries "$1" nlopt onetbb
    rm -rf "$into/openblas"
    build/venv/uv/bin/pip download --quiet --disable-pip-version-check --no-deps --require-hashes --only-binary :all: \
        --platform win_amd64 -r scripts/requirements/wheel.txt -d "$into/openblas"
    unzip -q "$into"/openblas/*.whl -d "$into/openblas"
    mkdir -p "$1/bin"
    cp "$into"/openblas/scipy_openblas32/lib/*.dll "$1/bin"
    cp "$into"/openblas/scipy_openblas32/lib/*.lib "$1/lib"
    cp "$into"/openblas/*.dist-info/licenses/LICENSE.txt "$1/OpenBLAS.txt"
}

# For several threads it must be a shared library there.
hdf5() { # place
    packaging/hdf5/build.sh "$1" "${toolchain[@]}" -DHDF5_ENABLE_THREADSAFE=ON -DBUILD_STATIC_LIBS=OFF -DBUILD_SHARED_LIBS=ON
    # It shows MinGW's threads, too, of which each program has its own.
    local imports="$1/installed/lib/libhdf5.dll.a"
    x86_64-w64-mingw32-nm --print-file-name "$imports" | sed -n 's/.*:\([^:]*\.o\):.* T [^H].*/\1/p' |
        xargs x86_64-w64-mingw32-ar d "$imports"
    sed -i 's/ -lm -lpthread//' "$1/installed/lib/pkgconfig/hdf5.pc"
}

# Before all that is for the other machine alone.
scripts/python.sh build
native="$(ls "$PWD"/build/python/dist/taut-*.whl)"
root="$(place root < <(made_of && dpkg-query --show g++-mingw-w64-x86-64-posix mingw-w64-x86-64-dev &&
    cat cmake/cross/mingw.cmake scripts/requirements/wheel.txt))"
hdf5="$(place hdf5 < <(echo "$root" && cat packaging/hdf5/{build.sh,Cargo.lock}))"
toolchain=("-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/cross/mingw.cmake" "-DTAUT_CROSS_ROOT=$root")
keep root "$root"
keep hdf5 "$hdf5"
find_rust
use_rust std,panic_unwind

# Rust's own library asks Windows 7 for nothing that Wine 8 does not have.
build() { # target SETTING...
    PKG_CONFIG_LIBDIR="$hdf5/installed/lib/pkgconfig:$root/lib/pkgconfig" cmake --log-level=WARNING -S . -B "$into/program" \
        -G Ninja "${toolchain[@]}" "-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES=$PWD/cmake/cross/packages.cmake" \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16 -DTAUT_BUILD_VIEWER=ON \
        -DTAUT_BUILD_TESTS=OFF -DTAUT_BUILD_EXAMPLES=OFF -DTAUT_BUILD_BENCHMARKS=OFF -DTAUT_BUILD_C=OFF \
        -DTAUT_WITH_METIS=OFF -DTAUT_WITH_CLARABEL=ON -DTAUT_CARGO_TARGET=x86_64-win7-windows-gnu "${@:2}"
    cmake --build "$into/program" --target "$1"
}

# Headers of Python for Windows, by those of this one; and all that they declare, as a library for the linker.
prepare_python() { # python library OPTION...
    local folder="$into/program/for_python"
    rm -rf "$folder"
    mkdir -p "$folder"
    cp -r "$("$1" -c 'import sysconfig; print(sysconfig.get_path("include"))')" "$folder/include"
    cp packaging/windows/pyconfig.h "$folder/include"
    {
        printf 'LIBRARY %s\nEXPORTS\n' "$2"
        x86_64-w64-mingw32-gcc-posix -E -P -I "$folder/include" -include Python.h -include frameobject.h "${@:3}" -x c /dev/null | tr '\n' ' ' |
            grep --only-matching --perl-regexp '__attribute__ ?\(\(dllimport\)\)\K[^;{]*' |
            sed -E 's/ *__attribute__ *\(\([^)]*\)\)//g; t names; :names; s/^[^(]*\b(_?Py[A-Za-z_0-9]*) *\(.*/\1/; t; s/,/\n/g' |
            sed -E 's/^.*\b(_?Py[A-Za-z_0-9]*) *(\[.*)?$/\1/' |
            grep --extended-regexp '^_?Py[A-Za-z_0-9]*$' | sort --unique
    } >"$folder/names.def"
    x86_64-w64-mingw32-dlltool --input-def "$folder/names.def" --output-lib "$folder/libpython.a"
}

build taut_app --fresh -DTAUT_BUILD_PYTHON=OFF
rm -rf "$into"/{taut,wheels,licences}
mkdir -p "$into"/{taut,wheels}
cp "$into/program/apps/taut/taut.exe" "$root"/bin/*.dll "$hdf5"/installed/bin/*.dll "$into/taut"
[[ ! -e build/app/taut.html ]] || cp build/app/taut.html "$into/taut"

# The first that there is of those with the stable ABI makes the wheel for all of them.
for version in 3.12 3.13 3.14 none; do
    "python$version" --version &>/dev/null && break
done
versions=(3.9 "$(python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')" "$version")
for version in $(printf '%s\n' "${versions[@]}" | sort --unique --version-sort); do
    if ! "python$version" --version &>/dev/null; then
        echo "windows.sh: no wheel for Python ${version/none/3.12 and later}: there is none here" >&2
        continue
    fi
    scripts/venv.sh build "$version"
    python="$PWD/build/venv/build-$version/bin/python"
    if ((${version#*.} >= 12)); then
        abi=cp312-abi3
        prepare_python "$python" python3.dll -DPy_LIMITED_API=0x030C0000
    else
        abi="cp${version/.}-cp${version/.}"
        prepare_python "$python" "python${version/.}.dll"
    fi
    rm -f "$into/program"/python/*.pyd
    build taut_python -DTAUT_BUILD_PYTHON=ON "-DTAUT_PYTHON=$into/program/for_python" "-DPython_EXECUTABLE=$python" "-DPython_VERSION=$version" \
        "-DPython_VERSION_MAJOR=${version%.*}" "-DPython_VERSION_MINOR=${version#*.}" -DPython_SOABI= -DPython_SOSABI= -DNB_SUFFIX=.pyd -DNB_SUFFIX_S=.pyd \
        "-Dnanobind_DIR=$("$python" -m nanobind --cmake_dir)" -DSKBUILD_SCRIPTS_DIR=scripts -DSKBUILD_DATA_DIR=data
    build/venv/build/bin/python scripts/windows_wheel.py "$native" "$into"/program/python/_taut*.pyd "$into/taut" \
        "$abi-win_amd64" "$into/wheels"
    wheel="$into/wheels/$(basename "$native" | cut --delimiter - --fields 1,2)-$abi-win_amd64.whl"
    build/venv/build/bin/python scripts/wheel_licences.py "$wheel" "$into/program" mingw "$root" "$hdf5" "$rust"
    unzip -q -o "$wheel" '*/licenses/*' -d "$into/licences"
done
mv "$into"/licences/*/licenses "$into/taut"
rm -rf "$into/licences"
