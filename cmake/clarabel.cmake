# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

# taut::clarabel_c, the conic solver behind its C interface: built by cargo from the locked list of
# crates. AUTO takes it where cargo is recent enough. TAUT_HAS_CLARABEL is the outcome.
set(TAUT_CARGO_MINIMUM 1.71)  # rust-version of extern/clarabel_c/Cargo.toml
set(TAUT_HAS_CLARABEL OFF)

if(TAUT_WITH_CLARABEL)
    find_program(TAUT_CARGO cargo HINTS $ENV{CARGO_HOME}/bin $ENV{HOME}/.cargo/bin)
    set(version 0)
    if(TAUT_CARGO)
        execute_process(COMMAND ${TAUT_CARGO} --version OUTPUT_VARIABLE said)
        if(said MATCHES "cargo ([0-9.]+)")
            set(version ${CMAKE_MATCH_1})
        endif()
    endif()
    if(version VERSION_GREATER_EQUAL TAUT_CARGO_MINIMUM)
        set(TAUT_HAS_CLARABEL ON)
    else()
        set(level FATAL_ERROR)
        if(TAUT_WITH_CLARABEL STREQUAL "AUTO")
            set(level WARNING)
        endif()
        message(${level} "Without the conic solver Clarabel: it needs cargo ${TAUT_CARGO_MINIMUM} or "
            "later, found ${version} (${TAUT_CARGO}). On Debian 12: apt-get install cargo-web. "
            "-DTAUT_WITH_CLARABEL=OFF leaves it out without this message.")
    endif()
endif()

if(TAUT_HAS_CLARABEL)
    set(crate ${PROJECT_SOURCE_DIR}/extern/clarabel_c)
    set(library ${PROJECT_BINARY_DIR}/clarabel_c/libclarabel_c.a)
    # Builds that differ in nothing that Rust sees can share this folder.
    set(TAUT_CARGO_FOLDER ${PROJECT_BINARY_DIR}/clarabel_c CACHE PATH "Where cargo builds Clarabel")
    set(TAUT_CARGO_TARGET "" CACHE STRING "Target that cargo builds Clarabel for; empty: this machine")
    set(target)
    if(TAUT_CARGO_TARGET)
        set(target --target ${TAUT_CARGO_TARGET})
    endif()
    add_custom_command(OUTPUT ${library}
        COMMAND ${TAUT_CARGO} build --release --locked --quiet
            --manifest-path ${crate}/Cargo.toml --target-dir ${TAUT_CARGO_FOLDER} ${target}
        COMMAND ${CMAKE_COMMAND} -E copy ${TAUT_CARGO_FOLDER}/${TAUT_CARGO_TARGET}/release/libclarabel_c.a ${library}
        DEPENDS ${crate}/Cargo.toml ${crate}/Cargo.lock ${crate}/src/lib.rs
        COMMENT "Building the conic solver Clarabel with cargo")
    add_custom_target(taut_clarabel_c DEPENDS ${library})
    # Rust compiles its own symbols to be seen: the linker must not pass them on.
    set(TAUT_HIDE_CLARABEL)
    if(TAUT_LINKER_EXCLUDES)
        set(TAUT_HIDE_CLARABEL LINKER:--exclude-libs,libclarabel_c.a)
    endif()
    set(TAUT_CLARABEL_SYSTEM pthread dl m)
    if(WIN32)
        set(TAUT_CLARABEL_SYSTEM advapi32 ws2_32 userenv ntdll)
    endif()
    add_library(taut::clarabel_c STATIC IMPORTED GLOBAL)
    set_target_properties(taut::clarabel_c PROPERTIES
        IMPORTED_LOCATION ${library}
        INTERFACE_INCLUDE_DIRECTORIES ${crate}/include
        INTERFACE_LINK_LIBRARIES "${TAUT_CLARABEL_SYSTEM}"
        INTERFACE_LINK_OPTIONS "${TAUT_HIDE_CLARABEL}")
    add_dependencies(taut::clarabel_c taut_clarabel_c)
endif()
