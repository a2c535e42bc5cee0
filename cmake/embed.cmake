# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Makes a C++ source that holds a file: cmake -DINPUT=page.html -DOUTPUT=page.cpp
# -DHEADER=report/viewer_page.hpp -DFUNCTION=taut::report::viewer_page -P embed.cmake. The header
# declares the function, which gives the bytes. Without INPUT the source holds nothing.

set(bytes "")
if(INPUT)
    file(READ "${INPUT}" hex HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
endif()
file(WRITE "${OUTPUT}" "#include \"${HEADER}\"
std::string_view ${FUNCTION}() {
    static constexpr char file[] = {${bytes}'\\0'};
    return {file, sizeof file - 1};
}
")
