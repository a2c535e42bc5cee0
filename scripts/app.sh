#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds build/app/taut.html, taut as one page that works in a browser without a network, out of the
# program as WebAssembly, build/app/taut.wasm. The compiler is the Clang of the Python package ziglang;
# headers are Debian's, as is the source of zlib and minizip; the sources of libc++ come with ziglang, those of
# pugixml and HDF5 as scripts/requirements/app_sources.txt and packaging/hdf5 pin them; Clarabel is built by Debian's
# rustc-web and rust-web-src, which are unpacked, and not installed.
# What is made of these, and the program itself, is kept in ~/.cache/taut-app (XDG_CACHE_HOME) under a hash
# of all that it is made of, for 30 days after it was last used: the page around a kept program takes seconds.
# Usage: scripts/app.sh [--kept]
#   --kept   makes no page where the program of these sources is not kept
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/cross.sh build/app

# Headers and libraries for WebAssembly, with libc++.
root() { # place
    copy_headers "$1/include"
    rm -rf "$into/runtime"
    cmake -S cmake/wasm/runtime -B "$into/runtime" -G Ninja -Wno-dev "${toolchain[@]}" -DCMAKE_BUILD_TYPE=Release \
        "-DCMAKE_INSTALL_PREFIX=$1" >/dev/null
    cmake --build "$into/runtime" -- --quiet
    cmake --install "$into/runtime" >/dev/null
    build_libraries "$1"
}

hdf5() { # place
    CFLAGS="-include $PWD/cmake/wasm/runtime/hdf5_gaps.h" \
        packaging/hdf5/build.sh "$1" "${toolchain[@]}" -DHDF5_ENABLE_THREADSAFE=OFF -DH5_HAVE_FCNTL=OFF
}

program() { # place
    prepare_zig
    local toolchain=("-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/wasm/toolchain.cmake" "-DTAUT_ZIG=$zig" "-DTAUT_CROSS_ROOT=$root")
    keep root "$root"
    keep hdf5 "$hdf5"
    use_rust std,panic_abort
    export CARGO_TARGET_WASM32_WASIP1_RUSTFLAGS="-C target-feature=+simd128 -C panic=abort"
    # Clarabel asks for a shared library, too, which nobody links.
    export CARGO_TARGET_WASM32_WASIP1_LINKER=true
    export PKG_CONFIG_LIBDIR="$hdf5/installed/lib/pkgconfig:$root/lib/pkgconfig"
    cmake --preset app --log-level=WARNING "${toolchain[@]}" "-DTAUT_CARGO_FOLDER=$rust/clarabel" \
        "-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES=$PWD/cmake/cross/packages.cmake"
    cmake --build --preset app --target taut_app
    cp "$into/program/apps/taut/taut.wasm" "$into/program/viewer/page.html" "$1"
    scripts/app_licences.py "$zig" "$hdf5" "$rust" "$1/licences.json"
}

root="$(place root < <(made_of && cat cmake/wasm/{toolchain.cmake,Platform/*,runtime/*}))"
hdf5="$(place hdf5 < <(echo "$root" && cat packaging/hdf5/{build.sh,Cargo.lock}))"
find_rust || exit "$([[ "${1:-}" == --kept ]]; echo $?)"
sources=(CMakeLists.txt CMakePresets.json LICENSE apps/taut cmake extern include src viewer)
program="$(place program < <(echo "$root $hdf5 $rust" && declare -f use_rust && find "${sources[@]}" -type f \
    -not -path '*/node_modules/*' -not -path 'viewer/app/*' -not -path 'viewer/tests/*' \
    -not -name build_app.mjs -not -name result_schema.ts -print0 | LC_ALL=C sort --zero-terminated | xargs --null sha256sum))"

if [[ "${1:-}" == --kept && ! -e "$program/made" ]]; then
    rm -f "$into"/taut.{html,wasm}
    echo "app.sh: no page: the program of these sources is not kept on this machine. make app makes both."
    exit 0
fi
keep program "$program"
cp "$program/taut.wasm" "$into"
cmake -DNPM=npm -DFOLDER="$PWD/viewer" -DOMIT=--omit=dev -DPACKAGE=three -DSTAMP="$into/packages" -P cmake/viewer_packages.cmake
version="$(sed -n 's/^project(taut VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)"
(cd viewer && node build_app.mjs "$program/taut.wasm" "$program/page.html" "$version" "$program/licences.json" "$into/taut.html")
ls -l "$into/taut.html"
