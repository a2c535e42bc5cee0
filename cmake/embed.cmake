# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
#
# Makes a C++ source that holds a file: cmake -DINPUT=page.html -DOUTPUT=page.cpp -P embed.cmake.
# Without INPUT the source holds nothing.

set(bytes "")
if(INPUT)
    file(READ "${INPUT}" hex HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
endif()
file(WRITE "${OUTPUT}" "#include \"report/viewer_page.hpp\"
namespace taut::report {
std::string_view viewer_page() {
    static constexpr char page[] = {${bytes}'\\0'};
    return {page, sizeof page - 1};
}
}
")
