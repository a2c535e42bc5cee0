# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

include(GenerateExportHeader)

# taut_add_library(<component>) makes the library libtaut_<component>, taut::<component> to whoever
# links it, static or shared as BUILD_SHARED_LIBS says. What its public headers mark with
# TAUT_<COMPONENT>_EXPORT can be linked, and nothing else.
function(taut_add_library component)
    set(target taut_${component})
    add_library(${target})
    add_library(taut::${component} ALIAS ${target})
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES
        EXPORT_NAME ${component}
        VERSION ${PROJECT_VERSION}
        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
        INSTALL_RPATH $ORIGIN
        POSITION_INDEPENDENT_CODE ON
        CXX_VISIBILITY_PRESET hidden
        VISIBILITY_INLINES_HIDDEN ON
        VERIFY_INTERFACE_HEADER_SETS ON)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
    # All but fmt are used by our sources alone: whoever links an installed taut does not need them.
    target_link_libraries(${target} PRIVATE
        ${TAUT_FMT}
        $<BUILD_INTERFACE:Boost::headers>
        $<BUILD_INTERFACE:FastFloat::fast_float>
        $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>
        $<BUILD_INTERFACE:taut_warnings>)

    if(TAUT_BUILD_FUZZERS)  # what reaches new code in the libraries is seen, and tests are compiled faster
        target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
    endif()

    string(TOUPPER ${component} name)
    set(header ${PROJECT_BINARY_DIR}/include/taut/export/${component}.hpp)
    generate_export_header(${target}
        BASE_NAME TAUT_${name}
        INCLUDE_GUARD_NAME TAUT_EXPORT_${name}_HPP
        EXPORT_FILE_NAME ${header})
    if(NOT BUILD_SHARED_LIBS)
        target_compile_definitions(${target} PUBLIC TAUT_${name}_STATIC_DEFINE)
        if(TAUT_LINKER_EXCLUDES)  # what templates of others make of types of ours is not hidden by the compiler
            target_link_options(${target} INTERFACE LINKER:--exclude-libs,lib${target}.a)
        endif()
    endif()
    target_sources(${target} PUBLIC
        FILE_SET generated_headers TYPE HEADERS BASE_DIRS ${PROJECT_BINARY_DIR}/include FILES ${header})
    set_property(GLOBAL APPEND PROPERTY TAUT_LIBRARIES ${target})
endfunction()

# taut_add_room(<room> SOURCES <source>... HEADERS <public header>...) adds a room to the library
# TAUT_LIBRARY: sources of the folder that calls it, public headers of include/taut/<room>/.
function(taut_add_room room)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;HEADERS")
    list(TRANSFORM arg_HEADERS PREPEND ${PROJECT_SOURCE_DIR}/include/taut/${room}/)
    target_sources(${TAUT_LIBRARY}
        PRIVATE ${arg_SOURCES}
        PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${arg_HEADERS})
endfunction()
