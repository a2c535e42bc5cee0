# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# taut_add_room(<room> SOURCES <source>... HEADERS <public header>...) adds a room to the library:
# sources of the folder that calls it, public headers of include/taut/<room>/.
function(taut_add_room room)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS")
    list(TRANSFORM arg_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/include/taut/${room}/)
    target_sources(taut
        PRIVATE ${arg_SOURCES}
        PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${arg_HEADERS})
endfunction()
