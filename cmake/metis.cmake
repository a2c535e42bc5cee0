# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# taut::metis where METIS is found, which comes with no package for CMake of its own.
find_path(TAUT_METIS_INCLUDE_DIR metis.h)
find_library(TAUT_METIS_LIBRARY metis)
if(TAUT_METIS_INCLUDE_DIR AND TAUT_METIS_LIBRARY AND NOT TARGET taut::metis)
    add_library(taut::metis UNKNOWN IMPORTED)
    set_target_properties(taut::metis PROPERTIES
        IMPORTED_LOCATION "${TAUT_METIS_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${TAUT_METIS_INCLUDE_DIR}")
endif()
