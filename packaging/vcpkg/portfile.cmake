# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# An overlay port of the tree that it lies in, from the root of the repository:
#   vcpkg install taut --overlay-ports=packaging/vcpkg
# vcpkg sees no change of these sources: --no-binarycaching builds them anew.
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES conic TAUT_WITH_CLARABEL)
vcpkg_find_acquire_program(PKGCONFIG)

vcpkg_cmake_configure(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS
        ${features}
        "-DPKG_CONFIG_EXECUTABLE=${PKGCONFIG}"
        -DTAUT_INSTALL=ON
        -DTAUT_WITH_METIS=OFF
        -DTAUT_WITH_XLSX=OFF
        -DTAUT_BUILD_APP=OFF
        -DTAUT_BUILD_BENCHMARKS=OFF
        -DTAUT_BUILD_C=OFF
        -DTAUT_BUILD_EXAMPLES=OFF
        -DTAUT_BUILD_TESTS=OFF
        -DTAUT_BUILD_VIEWER=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/taut)
vcpkg_fixup_pkgconfig()

# The files of CMake have moved from lib/cmake/taut to share/taut.
vcpkg_replace_string("${CURRENT_PACKAGES_DIR}/share/taut/tautConfig.cmake"
    "/../../libclarabel_c.a" "/../../lib/libclarabel_c.a")

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
file(INSTALL "${CURRENT_PORT_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
