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
into="$PWD/build/app"
store="${XDG_CACHE_HOME:-$HOME/.cache}/taut-app"
mkdir -p "$into" "$store"
find "$store" -mindepth 1 -maxdepth 1 -mtime +30 -exec rm -rf {} +
PATH="$PATH:${CARGO_HOME:-$HOME/.cargo}/bin"

# Where that is kept which a function makes of what standard input holds.
place() { # function
    echo "$store/$1-$({ declare -f "$1" && cat; } | sha256sum | cut --characters 1-16)"
}

# Lets a function fill its place, unless that is done.
keep() { # function place
    (
        flock 9
        if [[ ! -e "$2/made" ]]; then
            echo "app.sh: $1"
            rm -rf "$2"
            mkdir "$2"
            "$1" "$2"
        fi
        touch "$2" "$2/made"
    ) 9>"$2.lock"
}

# The sources of packages of Debian, in the folder it is called in: of the archives that packages come from.
debian_sources() { # package...
    local file lists="$into/apt"
    rm -rf "$lists"
    mkdir -p "$lists/sources" "$lists/index/partial"
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
        [[ ! -f "$file" ]] || sed -E 's/^(Types: *)deb$/\1deb-src/; s/^deb /deb-src /' "$file" >"$lists/sources/$(basename "$file")"
    done
    local options=(-qq -o APT::Sandbox::User=root -o Dir::Etc::SourceList=/dev/null -o "Dir::Etc::SourceParts=$lists/sources" -o "Dir::State::Lists=$lists/index")
    apt-get "${options[@]}" update
    apt-get "${options[@]}" source "$@" >/dev/null
}

# Headers of Debian that need no library, without those of its C library, which are not for this machine;
# libc++, pugixml and minizip.
root() { # place
    local name
    mkdir "$1/include"
    for name in fmt fast_float nlohmann CLI valijson eigen3/Eigen eigen3/unsupported boost; do
        cp -r "/usr/include/$name" "$1/include/$(basename "$name")"
    done
    # Boost before 1.81 counts enumerations down below their first value, which Clang no longer allows
    # where they have no type.
    sed -i -E 's/^( *enum (int_float|sign|udt_builtin)_mixture_enum)$/\1 : int/' \
        "$1"/include/boost/numeric/conversion/*_mixture_enum.hpp
    rm -rf "$into/sources" "$into/runtime"
    build/venv/uv/bin/pip download --quiet --disable-pip-version-check --no-deps --no-binary :all: --require-hashes \
        -r scripts/requirements/app_sources.txt -d "$into/sources"
    tar -x -f "$into"/sources/pugixml-*.tar.gz -C "$into/sources" --strip-components 1
    (cd "$into/sources" && debian_sources zlib minizip)
    cmake -S cmake/wasm/runtime -B "$into/runtime" -G Ninja -Wno-dev "${toolchain[@]}" -DCMAKE_BUILD_TYPE=Release \
        "-DCMAKE_INSTALL_PREFIX=$1" "-DTAUT_PUGIXML=$into/sources/src/third_party/pugixml/src" \
        "-DTAUT_ZLIB=$(echo "$into"/sources/zlib-*/)" "-DTAUT_MINIZIP=$(echo "$into"/sources/minizip-*/)" >/dev/null
    cmake --build "$into/runtime" -- --quiet
    cmake --install "$into/runtime" >/dev/null
}

hdf5() { # place
    CFLAGS="-include $PWD/cmake/wasm/runtime/hdf5_gaps.h" \
        packaging/hdf5/build.sh "$1" "${toolchain[@]}" -DHDF5_ENABLE_THREADSAFE=OFF -DH5_HAVE_FCNTL=OFF
}

depends_on() { apt-cache depends "$1" 2>/dev/null | sed -n "s/^ *Depends: \($2.*\)/\1/p" || true; }

rust() { # place
    (cd "$1" && apt-get download "${packages[@]}" >/dev/null)
    local package
    for package in "$1"/*.deb; do dpkg -x "$package" "$1"; done
    rm "$1"/*.deb
}

program() { # place
    scripts/venv.sh app
    local zig
    zig="$(build/venv/app/bin/python -c 'import pathlib, ziglang; print(pathlib.Path(ziglang.__file__).parent)')"
    local toolchain=("-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/wasm/toolchain.cmake" "-DTAUT_ZIG=$zig" "-DTAUT_WASM_ROOT=$root")
    # Where a compiler launcher is set, ccache: it does not know this compiler, whose file is a different one
    # in each environment.
    export CMAKE_C_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER:-}" CCACHE_COMPILERTYPE=clang
    export CCACHE_COMPILERCHECK="string:$(sha256sum scripts/requirements/app.txt)"
    export ZIG_GLOBAL_CACHE_DIR="$store/zig" ZIG_LOCAL_CACHE_DIR="$into/cache"
    keep root "$root"
    keep hdf5 "$hdf5"
    keep rust "$rust"
    export RUSTC="$rust/usr/bin/rustc" RUSTC_BOOTSTRAP=1 CARGO_UNSTABLE_BUILD_STD=std,panic_abort
    export CARGO_TARGET_WASM32_WASIP1_RUSTFLAGS="-C target-feature=+simd128 -C panic=abort"
    # Clarabel asks for a shared library, too, which nobody links.
    export CARGO_TARGET_WASM32_WASIP1_LINKER=true
    export LD_LIBRARY_PATH="$rust/usr/lib/x86_64-linux-gnu"
    export PKG_CONFIG_LIBDIR="$hdf5/installed/lib/pkgconfig:$root/lib/pkgconfig"
    cmake --preset app --log-level=WARNING "${toolchain[@]}" "-DTAUT_CARGO_FOLDER=$rust/clarabel" \
        "-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES=$PWD/cmake/wasm/packages.cmake"
    cmake --build --preset app --target taut_app
    cp "$into/program/apps/taut/taut.wasm" "$into/program/viewer/page.html" "$1"
    scripts/app_licences.py "$zig" "$hdf5" "$rust" "$1/licences.json"
}

mapfile -t headers < <(dpkg --search /usr/include/{fmt,fast_float,nlohmann,CLI,valijson,eigen3/Eigen,boost,minizip}/ /usr/include/zlib.h | cut --delimiter : --fields 1)
root="$(place root < <(declare -f debian_sources && dpkg-query --show "${headers[@]}" && cat cmake/wasm/{toolchain.cmake,Platform/*,runtime/*} scripts/requirements/app*.txt))"
hdf5="$(place hdf5 < <(echo "$root" && cat packaging/hdf5/{build.sh,Cargo.lock}))"
std="$(depends_on libstd-rust-web-dev libstd-rust-web-)"
if [[ -z "$std" ]]; then
    echo "app.sh: apt lists no package libstd-rust-web-dev, which Debian 12 has: call apt-get update" >&2
    exit "$([[ "${1:-}" == --kept ]]; echo $?)"
fi
# As root, apt would warn that its own user may not write here.
packages=(-o APT::Sandbox::User=root rustc-web rust-web-src libstd-rust-web-dev "$std" "$(depends_on "$std" libllvm)")
rust="$(place rust < <(apt-get download --print-uris "${packages[@]}"))"
sources=(CMakeLists.txt CMakePresets.json LICENSE apps/taut cmake extern include src viewer)
program="$(place program < <(echo "$root $hdf5 $rust" && find "${sources[@]}" -type f \
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
