# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# The report's viewer: TypeScript, bundled into one page, which becomes a source of the library.
# Without Node.js the library is whole but for report_html().
set(TAUT_VIEWER_CPP ${PROJECT_BINARY_DIR}/viewer/viewer_page.cpp)
set(embed ${CMAKE_COMMAND} -DOUTPUT=${TAUT_VIEWER_CPP} -DHEADER=report/viewer_page.hpp
    -DFUNCTION=taut::report::viewer_page)
set(embed_script ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)
set(viewer_dir ${PROJECT_SOURCE_DIR}/viewer)

if(TAUT_BUILD_VIEWER)
    set(viewer_page ${PROJECT_BINARY_DIR}/viewer/page.html)
    file(GLOB viewer_sources CONFIGURE_DEPENDS ${viewer_dir}/src/*.ts)
    # Types, which type checks make from the schema: they are not in the bundle.
    list(FILTER viewer_sources EXCLUDE REGEX result_schema)
    foreach(file build.mjs bundle.mjs licences.mjs page.html style.css package.json)
        list(APPEND viewer_sources ${viewer_dir}/${file})
    endforeach()
    list(APPEND viewer_sources ${PROJECT_SOURCE_DIR}/LICENSE)
    # What only type checks and tests need is left out, unless there are tests.
    set(omit --omit=dev)
    set(package three)
    if(TAUT_BUILD_TESTS)
        set(omit)
        set(package playwright-core)
    endif()
    set(viewer_packages ${PROJECT_BINARY_DIR}/viewer/packages.${package})
    set(packages_script ${PROJECT_SOURCE_DIR}/cmake/viewer_packages.cmake)
    add_custom_command(OUTPUT ${viewer_packages}
        COMMAND ${CMAKE_COMMAND} -DNPM=${TAUT_NPM} -DFOLDER=${viewer_dir} -DOMIT=${omit} -DPACKAGE=${package}
            -DSTAMP=${viewer_packages} -P ${packages_script}
        DEPENDS ${viewer_dir}/package-lock.json ${packages_script}
        COMMENT "Installing the viewer's locked npm packages")
    add_custom_command(OUTPUT ${viewer_page}
        COMMAND ${TAUT_NODE} build.mjs ${viewer_page}
        WORKING_DIRECTORY ${viewer_dir}
        DEPENDS ${viewer_sources} ${viewer_packages}
        COMMENT "Bundling the report's viewer")
    add_custom_command(OUTPUT ${TAUT_VIEWER_CPP}
        COMMAND ${embed} -DINPUT=${viewer_page} -P ${embed_script}
        DEPENDS ${viewer_page} ${embed_script}
        COMMENT "Embedding the report's viewer")
else()
    add_custom_command(OUTPUT ${TAUT_VIEWER_CPP}
        COMMAND ${embed} -P ${embed_script}
        DEPENDS ${embed_script})
endif()
