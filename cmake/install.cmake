# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(TAUT_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/taut)

install(TARGETS taut EXPORT tautTargets FILE_SET HEADERS)
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

configure_package_config_file(cmake/tautConfig.cmake.in
    ${PROJECT_BINARY_DIR}/tautConfig.cmake
    INSTALL_DESTINATION ${TAUT_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tautConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES
    ${PROJECT_BINARY_DIR}/tautConfig.cmake
    ${PROJECT_BINARY_DIR}/tautConfigVersion.cmake
    DESTINATION ${TAUT_CMAKE_DIR})
