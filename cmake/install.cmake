# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(TAUT_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/taut)

install(TARGETS taut EXPORT tautTargets FILE_SET HEADERS FILE_SET generated_headers)
install(EXPORT tautTargets NAMESPACE taut:: DESTINATION ${TAUT_CMAKE_DIR})
if(TAUT_HAS_CLARABEL)
    # libtaut.a is static, so whoever links it links this one, too: tautConfig.cmake names it.
    get_target_property(clarabel_c taut::clarabel_c IMPORTED_LOCATION)
    install(FILES ${clarabel_c} DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
install(FILES src/results/result.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/taut)
if(TAUT_BUILD_APP)
    install(TARGETS taut_app)
endif()

if(TAUT_HAS_CLARABEL)
    set(TAUT_PC_CLARABEL "-lclarabel_c -lpthread -ldl -lm")
endif()
# From where the file lies, so that what is installed may be moved.
file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
set(TAUT_PC_PREFIX "\${pcfiledir}/${to_prefix}")
configure_file(cmake/taut.pc.in ${PROJECT_BINARY_DIR}/taut.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/taut.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

configure_package_config_file(cmake/tautConfig.cmake.in
    ${PROJECT_BINARY_DIR}/tautConfig.cmake
    INSTALL_DESTINATION ${TAUT_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tautConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/tautConfig.cmake
    ${PROJECT_BINARY_DIR}/tautConfigVersion.cmake
    DESTINATION ${TAUT_CMAKE_DIR})
