# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# The schema of saved results becomes a source of the library, whose reader checks them against it.
set(TAUT_RESULT_SCHEMA_CPP ${PROJECT_BINARY_DIR}/result_schema.cpp)
set(schema ${PROJECT_SOURCE_DIR}/src/results/result.schema.json)
set(embed_script ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)
add_custom_command(OUTPUT ${TAUT_RESULT_SCHEMA_CPP}
    COMMAND ${CMAKE_COMMAND} -DINPUT=${schema} -DOUTPUT=${TAUT_RESULT_SCHEMA_CPP}
        -DHEADER=results/schema_check.hpp -DFUNCTION=taut::result_schema -P ${embed_script}
    DEPENDS ${schema} ${embed_script}
    COMMENT "Embedding the schema of saved results")
