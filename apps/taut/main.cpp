// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/version.hpp"

#include <CLI/CLI.hpp>

#include <string>

int main(int argc, char** argv) {
    CLI::App app{"The unstressed lengths of a tensioned cable net, from one survey of its form."};
    app.set_version_flag("--version", "taut " + std::string{taut::version()});
    CLI11_PARSE(app, argc, argv);
    return 0;
}
