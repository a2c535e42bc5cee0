# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

include(CMakePackageConfigHelpers)

set(TAUT_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/taut)

# One export a library, so that whoever asks for one need not have what the others are linked with.
foreach(component core adjustment io report)
    install(TARGETS taut_${component} EXPORT taut-${component}
        RUNTIME COMPONENT library
        LIBRARY COMPONENT library NAMELINK_COMPONENT development
        ARCHIVE COMPONENT development
        FILE_SET HEADERS COMPONENT development
        FILE_SET generated_headers COMPONENT development)
    install(EXPORT taut-${component} NAMESPACE taut:: DESTINATION ${TAUT_CMAKE_DIR}
        COMPONENT development)
endforeach()
if(TAUT_HAS_CLARABEL AND NOT BUILD_SHARED_LIBS)
    # Whoever links libtaut_adjustment.a links this one, too: tautConfig.cmake names it.
    get_target_property(clarabel_c taut::clarabel_c IMPORTED_LOCATION)
    install(FILES ${clarabel_c} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
endif()
install(FILES ${PROJECT_BINARY_DIR}/result.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/taut COMPONENT development)
if(TAUT_BUILD_C)
    install(TARGETS taut_c EXPORT taut-c
        RUNTIME COMPONENT library
        LIBRARY COMPONENT library NAMELINK_COMPONENT development
        ARCHIVE COMPONENT development
        FILE_SET HEADERS COMPONENT development)
    install(EXPORT taut-c NAMESPACE taut:: DESTINATION ${TAUT_CMAKE_DIR} COMPONENT development)
endif()
if(TAUT_BUILD_APP)
    install(TARGETS taut_app COMPONENT program)
    # Of `make app`, where that has been called: taut app writes it.
    install(FILES build/app/taut.html DESTINATION ${CMAKE_INSTALL_DATADIR}/taut COMPONENT program OPTIONAL)
endif()
if(TAUT_BUILD_MPI)
    install(TARGETS taut_mpi COMPONENT cluster)
endif()

# For pkg-config. A shared library finds for itself what it needs; for a static one pass --static.
if(NOT BUILD_SHARED_LIBS)
    if(TAUT_HAS_CLARABEL)
        set(TAUT_PC_CLARABEL "-Wl,--exclude-libs,libclarabel_c.a -lclarabel_c -lpthread -ldl -lm")
    endif()
    set(requires pugixml)
    if(TAUT_WITH_HDF5)
        string(PREPEND requires "hdf5 ")
    endif()
    if(TAUT_WITH_XLSX)
        string(APPEND requires " minizip")
    endif()
    set(TAUT_PC_REQUIRES "Requires.private: ${requires}")
    set(TAUT_PC_FLAGS "-DTAUT_ADJUSTMENT_STATIC_DEFINE -DTAUT_IO_STATIC_DEFINE -DTAUT_REPORT_STATIC_DEFINE")
    set(requires fmt)
    if(TAUT_WITH_NLOPT)
        string(APPEND requires " nlopt")
    endif()
    if(TAUT_WITH_TBB)
        string(APPEND requires " tbb")
    endif()
    set(TAUT_PC_CORE_REQUIRES "Requires.private: ${requires}")
    set(TAUT_PC_CORE_FLAGS -DTAUT_CORE_STATIC_DEFINE)
    set(lapack)
    if(TAUT_WITH_BLAS)
        list(JOIN LAPACK_LIBRARIES " " lapack)
    endif()
    if(TAUT_HAS_METIS)
        set(TAUT_PC_METIS "${TAUT_METIS_LIBRARY}")
    endif()
    set(TAUT_PC_CORE_LIBS "Libs.private: ${TAUT_PC_METIS} ${lapack}")
endif()
# From where the file lies, so that what is installed may be moved.
file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
set(TAUT_PC_PREFIX "\${pcfiledir}/${to_prefix}")
set(TAUT_PC_NAMES taut taut-core)
if(TAUT_BUILD_C)
    list(APPEND TAUT_PC_NAMES taut-c)
endif()
foreach(name ${TAUT_PC_NAMES})
    configure_file(cmake/${name}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)
endforeach()

configure_package_config_file(cmake/tautConfig.cmake.in
    ${PROJECT_BINARY_DIR}/tautConfig.cmake
    INSTALL_DESTINATION ${TAUT_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tautConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/tautConfig.cmake
    ${PROJECT_BINARY_DIR}/tautConfigVersion.cmake
    cmake/metis.cmake
    DESTINATION ${TAUT_CMAKE_DIR} COMPONENT development)
