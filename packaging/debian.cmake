# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# Three Debian packages by install component, libtaut<major>.<minor>, libtaut-dev and taut:
#   cmake -S . -B build/debian -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON -DCMAKE_INSTALL_PREFIX=/usr
#       -DCMAKE_SKIP_INSTALL_RPATH=ON
#   cmake --build build/debian && cpack -G DEB --config build/debian/CPackConfig.cmake -B build/debian/packages
# The prefix makes GNUInstallDirs take Debian's folder of libraries; there nothing needs an RPATH.
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
taut tells how long each cable of a built net is, how tight and how sure that is.
This package holds what programs are built with: headers, libraries to link, and
files for CMake and pkg-config.")

if(BUILD_SHARED_LIBS)
    list(APPEND CPACK_COMPONENTS_ALL library)
    set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME ${library_package})
    set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
    set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
    # For packages made on top of this one: what they link, and from which version on. The call of
    # ldconfig comes by itself.
    set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
    set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
    set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "lengths of a tensioned cable net from one survey (libraries)
taut tells how long each cable of a built net is, how tight and how sure that is.
This package holds the libraries that programs run with.")
    string(PREPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library_package} ${same_version}, ")
else()
    # A static library brings none of its own along.
    string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
        ", libfmt-dev, libhdf5-dev, libnlopt-dev, libopenblas-dev, libpugixml-dev, libtbb-dev, pkg-config")
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
taut tells how long each cable of a built net is, how tight, how sure that is,
and which turnbuckle to turn how far. Surveys go in as they come from the
instrument, results come out as JSON, CSV and reports for any browser.")
endif()

# Each package has the licence where Debian looks for it. Only who asks for a component gets it
# there: a plain `cmake --install` does not.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} name)
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright
        DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME}
        COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()

# What is installed without one of these components would be in no package.
get_cmake_property(installed COMPONENTS)
list(REMOVE_ITEM installed library ${CPACK_COMPONENTS_ALL})
if(installed)
    message(WARNING "In no Debian package: what is installed as component '${installed}'")
endif()

include(CPack)
