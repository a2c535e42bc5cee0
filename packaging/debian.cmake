# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# Three Debian packages by install component, libtaut<major>.<minor>, libtaut-dev and taut:
# CONTRIBUTING.md, "Releasing", has the commands. Their prefix makes GNUInstallDirs take Debian's folder of libraries; there
# nothing needs an RPATH.
# dpkg-shlibdeps (dpkg-dev) finds what the binaries need.
include_guard()

# A new SOVERSION is a new package, so that programs of the old one run on.
set(library_package libtaut${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(revision 1)
set(same_version "(= ${PROJECT_VERSION}-${revision})")

set(CPACK_PACKAGE_NAME taut)
set(CPACK_PACKAGE_VENDOR "The taut authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # the first line of each description is one
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS  # whatever the umask
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The taut authors <taut@example.org>")
set(CPACK_DEBIAN_PACKAGE_RELEASE ${revision})
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# The libraries of the build, which no package holds yet.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src)

set(CPACK_COMPONENTS_ALL development)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtaut-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libeigen3-dev)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "lengths of a tensioned cable net from one survey (development)
taut estimates how long each cable of a built net is, how tight and how sure that
is. This package holds what programs are built with: headers, libraries to
link, and files for CMake and pkg-config.")

# The library for C is shared whatever the others are.
set(shared "")
if(BUILD_SHARED_LIBS)
    list(APPEND shared core adjustment io report)
endif()
if(TAUT_BUILD_C)
    list(APPEND shared c)
endif()
if(shared)
    list(APPEND CPACK_COMPONENTS_ALL library)
    set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library_package})
    set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
    set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "lengths of a tensioned cable net from one survey (libraries)
taut estimates how long each cable of a built net is, how tight and how sure that
is. This package holds the libraries that programs run with.")
    # For packages made on top of this one: what they link, and from which version on. CPack's own
    # would call ldconfig from a script; Debian's way is a trigger.
    set(shlibs "")
    foreach(component ${shared})
        string(APPEND shlibs "libtaut_${component} ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} "
            "${library_package} (>= ${PROJECT_VERSION})\n")
    endforeach()
    file(WRITE ${PROJECT_BINARY_DIR}/debian/shlibs "${shlibs}")
    file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
    set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA
        ${PROJECT_BINARY_DIR}/debian/shlibs ${PROJECT_BINARY_DIR}/debian/triggers)
    string(PREPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library_package} ${same_version}, ")
endif()
if(NOT BUILD_SHARED_LIBS)
    # A static library brings none of its own along.
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
        ", libfmt-dev, libhdf5-dev, libmetis-dev, libminizip-dev, libnlopt-dev, libopenblas-dev, libpugixml-dev, libtbb-dev, pkg-config")
endif()

if(TAUT_BUILD_APP)
    list(APPEND CPACK_COMPONENTS_ALL program)
    set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME taut)
    set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
    set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
    if(BUILD_SHARED_LIBS)
        set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${library_package} ${same_version}")
    endif()
    set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "lengths of a tensioned cable net from one survey (program)
taut estimates how long each cable of a built net is, how tight, how sure that is,
and which turnbuckle to turn how far. Surveys go in as they come from the
instrument, results come out as JSON, CSV and reports for any browser.")
endif()

if(TAUT_BUILD_MPI)
    list(APPEND CPACK_COMPONENTS_ALL cluster)
    set(CPACK_DEBIAN_CLUSTER_PACKAGE_NAME taut-mpi)
    set(CPACK_DEBIAN_CLUSTER_PACKAGE_SECTION science)
    set(CPACK_DEBIAN_CLUSTER_PACKAGE_SHLIBDEPS ON)
    if(BUILD_SHARED_LIBS)
        set(CPACK_DEBIAN_CLUSTER_PACKAGE_DEPENDS "${library_package} ${same_version}")
    endif()
    set(CPACK_DEBIAN_CLUSTER_DESCRIPTION "lengths of a tensioned cable net from one survey (program for clusters)
taut estimates how long each cable of a built net is, how tight and how sure that
is. This package holds the program that samples, trains and tries methods over
the nodes of a cluster, by MPI.")
endif()

# Each package has the licence and the changes where Debian looks for them. Only who asks for a
# component gets them there: a plain `cmake --install` does not.
set(changes ${PROJECT_BINARY_DIR}/debian/changelog.Debian)
file(STRINGS ${PROJECT_SOURCE_DIR}/CHANGELOG.md release REGEX "^## \\[${PROJECT_VERSION}\\] - " LIMIT_COUNT 1)
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+$" released "${release}")
execute_process(COMMAND date --utc --rfc-email --date=${released}
    OUTPUT_VARIABLE released OUTPUT_STRIP_TRAILING_WHITESPACE)
file(WRITE ${changes} "taut (${PROJECT_VERSION}-${revision}) unstable; urgency=medium

  * ${PROJECT_VERSION}: see changelog.gz.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${released}
")
configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_BINARY_DIR}/debian/changelog COPYONLY)
execute_process(COMMAND gzip --best --no-name --force ${changes} ${PROJECT_BINARY_DIR}/debian/changelog)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} name)
    set(documents ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME})
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright
        DESTINATION ${documents} COMPONENT ${component} EXCLUDE_FROM_ALL)
    install(FILES ${changes}.gz ${PROJECT_BINARY_DIR}/debian/changelog.gz
        DESTINATION ${documents} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()

# What is installed without one of these components would be in no package.
get_cmake_property(installed COMPONENTS)
list(REMOVE_ITEM installed library ${CPACK_COMPONENTS_ALL})
if(installed)
    message(WARNING "In no Debian package: what is installed as component '${installed}'")
endif()

include(CPack)
