#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds build/app/taut.html, taut as one page that works in a browser without a network, out of the
# program as WebAssembly, build/app/taut.wasm. The compiler is the Clang of the Python package ziglang;
# headers are Debian's; the sources of libc++ come with ziglang, those of pugixml and HDF5 as
# scripts/requirements/app_sources.txt and packaging/hdf5 pin them; Clarabel is built by Debian's
# rustc-web and rust-web-src, which are unpacked here, and not installed.
# Usage: scripts/app.sh
set -euo pipefail
cd "$(dirname "$0")/.."
into="$PWD/build/app"
root="$into/root"
mkdir -p "$root/include" "$root/lib"
export ZIG_GLOBAL_CACHE_DIR="$into/cache" ZIG_LOCAL_CACHE_DIR="$into/cache"
PATH="$PATH:${CARGO_HOME:-$HOME/.cargo}/bin"

scripts/venv.sh app
zig="$(build/venv/app/bin/python -c 'import pathlib, ziglang; print(pathlib.Path(ziglang.__file__).parent)')"
toolchain=("-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/wasm/toolchain.cmake" "-DTAUT_ZIG=$zig" "-DTAUT_WASM_ROOT=$root")

# Runs a function once, as long as neither it nor the files change.
once() { # function file...
    local stamp
    stamp="$({ declare -f "$1" && cat "${@:2}" </dev/null; } | sha256sum)"
    if [[ "$(cat "$into/$1.stamp" 2>/dev/null)" != "$stamp" ]]; then
        echo "app.sh: $1"
        "$1"
        echo "$stamp" >"$into/$1.stamp"
    fi
}

# Headers of Debian that need no library, apart from those of its C library, which are not for this machine.
headers() {
    local name
    for name in fmt fast_float nlohmann CLI valijson eigen3/Eigen eigen3/unsupported; do
        ln -sfn "/usr/include/$name" "$root/include/$(basename "$name")"
    done
    rm -rf "$root/include/boost"
    cp -r /usr/include/boost "$root/include/boost"
    # Boost before 1.81 counts enumerations down below their first value, which Clang no longer allows
    # where they have no type.
    local mixture="$root/include/boost/numeric/conversion"
    sed -i -E 's/^( *enum (int_float|sign|udt_builtin)_mixture_enum)$/\1 : int/' "$mixture"/*_mixture_enum.hpp
}

runtime() {
    rm -rf "$into/sources" "$into/runtime"
    build/venv/uv/bin/pip download --quiet --disable-pip-version-check --no-deps --no-binary :all: --require-hashes \
        -r scripts/requirements/app_sources.txt -d "$into/sources"
    tar -x -f "$into"/sources/pugixml-*.tar.gz -C "$into/sources" --strip-components 1
    cmake -S cmake/wasm/runtime -B "$into/runtime" -G Ninja -Wno-dev "${toolchain[@]}" -DCMAKE_BUILD_TYPE=Release \
        "-DCMAKE_INSTALL_PREFIX=$root" "-DTAUT_PUGIXML=$into/sources/src/third_party/pugixml/src" >/dev/null
    cmake --build "$into/runtime"
    cmake --install "$into/runtime" >/dev/null
}

depends_on() { apt-cache depends "$1" | sed -n "s/^ *Depends: \($2.*\)/\1/p"; }

rust() {
    rm -rf "$into/rust"
    mkdir -p "$into/rust/packages"
    local package std
    std="$(depends_on libstd-rust-web-dev libstd-rust-web-)"
    (cd "$into/rust/packages" && apt-get download rustc-web rust-web-src libstd-rust-web-dev "$std" \
        "$(depends_on "$std" libllvm)" >/dev/null 2>&1)
    for package in "$into"/rust/packages/*.deb; do dpkg -x "$package" "$into/rust"; done
    rm -r "$into/rust/packages"
}

once headers
once runtime cmake/wasm/runtime/* cmake/wasm/toolchain.cmake cmake/wasm/Platform/* scripts/requirements/app*.txt
once rust
CFLAGS="-include $PWD/cmake/wasm/runtime/hdf5_gaps.h" \
    packaging/hdf5/build.sh build/app/hdf5 "${toolchain[@]}" -DHDF5_ENABLE_THREADSAFE=OFF -DH5_HAVE_FCNTL=OFF


export RUSTC="$into/rust/usr/bin/rustc" RUSTC_BOOTSTRAP=1 CARGO_UNSTABLE_BUILD_STD=std,panic_abort
export CARGO_TARGET_WASM32_WASIP1_RUSTFLAGS="-C target-feature=+simd128 -C panic=abort"
# Clarabel asks for a shared library, too, which nobody links.
export CARGO_TARGET_WASM32_WASIP1_LINKER=true
export LD_LIBRARY_PATH="$into/rust/usr/lib/x86_64-linux-gnu"
export PKG_CONFIG_LIBDIR="$into/hdf5/installed/lib/pkgconfig"
cmake --preset app --log-level=WARNING "${toolchain[@]}" "-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES=$PWD/cmake/wasm/packages.cmake"
cmake --build --preset app --target taut_app
cp "$into/program/apps/taut/taut.wasm" "$into/taut.wasm"

scripts/app_licences.py "$zig" "$into" "$into/licences.json"
version="$(sed -n 's/^project(taut VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)"
(cd viewer && node build_app.mjs "$into/taut.wasm" "$into/program/viewer/page.html" "$version" "$into/licences.json" "$into/taut.html")
ls -l "$into/taut.html"
