# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# What is compiled here for other machines, for scripts that are called in the root: source scripts/cross.sh FOLDER,
# of what is made on the way. The compiler is the Clang of the Python package ziglang, but for Windows; headers are
# Debian's, as are the sources of libraries; those of pugixml and HDF5 come as scripts/requirements/app_sources.txt and packaging/hdf5
# pin them. What takes long is kept in ~/.cache/taut-app (XDG_CACHE_HOME) under a hash of all that it is made of,
# for 30 days after it was last used.
into="$PWD/$1"
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
            echo "$(basename "$0"): $1"
            rm -rf "$2"
            mkdir "$2"
            "$1" "$2"
        fi
        touch "$2" "$2/made"
    ) 9>"$2.lock"
}

# Sets zig, the folder of the compiler, and what it needs.
prepare_zig() {
    scripts/venv.sh app
    zig="$(build/venv/app/bin/python -c 'import pathlib, ziglang; print(pathlib.Path(ziglang.__file__).parent)')"
    # Where a compiler launcher is set, ccache: it does not know this compiler, whose file is a different one
    # in each environment.
    export CMAKE_C_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER:-}" CCACHE_COMPILERTYPE=clang
    export CCACHE_COMPILERCHECK="string:$(sha256sum scripts/requirements/app.txt)"
    export ZIG_GLOBAL_CACHE_DIR="$store/zig" ZIG_LOCAL_CACHE_DIR="$into/cache"
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

# Headers of Debian that need no library, without those of its C library, which are not for the other machine.
copy_headers() { # folder
    local name
    mkdir "$1"
    for name in fmt fast_float nlohmann CLI valijson eigen3/Eigen eigen3/unsupported boost; do
        cp -r "/usr/include/$name" "$1/$(basename "$name")"
    done
    # Boost before 1.81 counts enumerations down below their first value, which Clang no longer allows
    # where they have no type.
    sed -i -E 's/^( *enum (int_float|sign|udt_builtin)_mixture_enum)$/\1 : int/' \
        "$1"/boost/numeric/conversion/*_mixture_enum.hpp
}

# pugixml, minizip and more libraries by the names of Debian's sources, by the toolchain.
build_libraries() { # place library...
    local name folders=()
    rm -rf "$into/sources" "$into/libraries"
    build/venv/uv/bin/pip download --quiet --disable-pip-version-check --no-deps --no-binary :all: --require-hashes \
        -r scripts/requirements/app_sources.txt -d "$into/sources"
    tar -x -f "$into"/sources/pugixml-*.tar.gz -C "$into/sources" --strip-components 1
    (cd "$into/sources" && debian_sources zlib minizip "${@:2}")
    for name in zlib minizip "${@:2}"; do
        folders+=("-DTAUT_$(tr '[:lower:]' '[:upper:]' <<<"${name#one}")=$(echo "$into/sources/$name"-*/)")
    done
    cmake -S cmake/cross/libraries -B "$into/libraries" -G Ninja -Wno-dev "${toolchain[@]}" -DCMAKE_BUILD_TYPE=Release \
        "-DCMAKE_INSTALL_PREFIX=$1" "-DTAUT_PUGIXML=$into/sources/src/third_party/pugixml/src" "${folders[@]}" >/dev/null
    cmake --build "$into/libraries" -- --quiet
    cmake --install "$into/libraries" >/dev/null
}

# All that the libraries are made of, but for the toolchain.
made_of() {
    declare -f debian_sources copy_headers build_libraries
    dpkg --search /usr/include/{fmt,fast_float,nlohmann,CLI,valijson,eigen3/Eigen,boost,minizip}/ /usr/include/zlib.h |
        cut --delimiter : --fields 1 | xargs dpkg-query --show
    cat cmake/cross/libraries/CMakeLists.txt scripts/requirements/app*.txt
}

depends_on() { apt-cache depends "$1" 2>/dev/null | sed -n "s/^ *Depends: \($2.*\)/\1/p" || true; }

rust() { # place
    (cd "$1" && apt-get download "${packages[@]}" >/dev/null)
    local package
    for package in "$1"/*.deb; do dpkg -x "$package" "$1"; done
    rm "$1"/*.deb
}

# Sets rust, the place of Debian's compiler for it with the sources of its standard library.
find_rust() {
    local std
    std="$(depends_on libstd-rust-web-dev libstd-rust-web-)"
    if [[ -z "$std" ]]; then
        echo "$(basename "$0"): apt lists no package libstd-rust-web-dev, which Debian 12 has: call apt-get update" >&2
        return 1
    fi
    # As root, apt would warn that its own user may not write here.
    packages=(-o APT::Sandbox::User=root rustc-web rust-web-src libstd-rust-web-dev "$std" "$(depends_on "$std" libllvm)")
    rust="$(place rust < <(apt-get download --print-uris "${packages[@]}"))"
}

# Lets cargo build with it, and these parts of the standard library from their sources.
use_rust() { # part,...
    keep rust "$rust"
    export RUSTC="$rust/usr/bin/rustc" RUSTC_BOOTSTRAP=1 CARGO_UNSTABLE_BUILD_STD="$1"
    export LD_LIBRARY_PATH="$rust/usr/lib/x86_64-linux-gnu"
}
