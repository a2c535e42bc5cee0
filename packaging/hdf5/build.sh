#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Builds HDF5, once: a static library that reads and writes files on this machine and
# nothing else. Debian's brings curl, Kerberos, LDAP and OpenSSL along, by which it reads from the
# cloud; in a wheel these would age without Debian's security updates. taut compresses nothing, so
# neither zlib nor szip is needed.
# Usage: packaging/hdf5/build.sh [FOLDER CMAKE_ARGUMENT...], by default build/hdf5, for several threads
set -euo pipefail
cd "$(dirname "$0")/../.."
into="${1:-build/hdf5}"
arguments=("${@:2}")
(($# > 0)) || arguments=(-DHDF5_ENABLE_THREADSAFE=ON)
stamp="$(echo "${arguments[@]}" | cat - packaging/hdf5/build.sh packaging/hdf5/Cargo.lock | sha256sum)"
if [[ -e "$into/stamp" && "$(cat "$into/stamp")" == "$stamp" ]]; then
    exit 0
fi
rm -rf "$into"
mkdir -p "$into"
PATH="$PATH:${CARGO_HOME:-$HOME/.cargo}/bin"
cargo vendor --quiet --locked --manifest-path packaging/hdf5/Cargo.toml "$into/vendor" >/dev/null
prefix="$(realpath "$into")/installed"
CFLAGS="-w ${CFLAGS:-}" cmake -S "$into/vendor/hdf5-metno-src/ext/hdf5" -B "$into/build" -G Ninja -Wno-dev \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DCMAKE_C_VISIBILITY_PRESET=hidden \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DHDF5_INSTALL_LIB_DIR=lib \
    -DHDF5_NO_PACKAGES=ON -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF \
    -DHDF5_BUILD_HL_LIB=OFF -DHDF5_BUILD_TOOLS=OFF -DHDF5_BUILD_UTILS=OFF \
    -DHDF5_ENABLE_Z_LIB_SUPPORT=OFF -DHDF5_ENABLE_SZIP_SUPPORT=OFF "${arguments[@]}" >/dev/null
cmake --build "$into/build" -- --quiet
cmake --install "$into/build" >/dev/null
cp "$into/vendor/hdf5-metno-src/ext/hdf5/COPYING_LBNL_HDF5" "$prefix/share/"
version="$(sed -n 's/^Version: //p' "$prefix/lib/pkgconfig/hdf5.pc")"
# HDF5's own names no library.
cat >"$prefix/lib/pkgconfig/hdf5.pc" <<EOF
Name: hdf5
Description: HDF5, static, for the wheel
Version: $version
Cflags: -I$prefix/include
Libs: -L$prefix/lib -lhdf5 -lm -lpthread
EOF
rm -rf "$into/build" "$into/vendor"
echo "$stamp" >"$into/stamp"
