// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/version.hpp"

#include <iostream>
#include <string_view>

int main(int argc, char** argv) {
    const std::string_view expected = argc > 1 ? argv[1] : "";
    std::cout << "taut " << taut::version() << '\n';
    return taut::version() == expected ? 0 : 1;
}
