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
    set(viewer_sources build.mjs page.html style.css package.json
        src/charts.ts src/colours.ts src/csv.ts src/details.ts src/dom.ts src/edge_lines.ts
        src/format.ts src/inspector.ts src/legend.ts src/main.ts src/model.ts src/net_camera.ts
        src/net_controls.ts src/net_section.ts src/node_dots.ts src/picking.ts src/plan_model.ts
        src/plan_sections.ts src/plan_summary.ts src/result.ts src/result_schema.ts src/selection.ts
        src/stroke_arrows.ts src/summary.ts src/table.ts src/tables.ts src/view.ts)
    list(TRANSFORM viewer_sources PREPEND ${viewer_dir}/)
    # What only type checks and tests need is left out, unless there are tests.
    set(omit --omit=dev)
    set(viewer_packages ${viewer_dir}/node_modules/.package-lock.json)
    if(TAUT_BUILD_TESTS)
        set(omit)
        set(viewer_packages ${viewer_dir}/node_modules/playwright-core/package.json)
    endif()
    add_custom_command(OUTPUT ${viewer_packages}
        COMMAND ${TAUT_NPM} ci ${omit} --ignore-scripts --no-audit --no-fund --loglevel=error
        COMMAND ${CMAKE_COMMAND} -E touch ${viewer_packages}
        WORKING_DIRECTORY ${viewer_dir}
        DEPENDS ${viewer_dir}/package-lock.json
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
