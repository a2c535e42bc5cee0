// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Writes the schema of saved results: taut_print_schema FILE

#include "taut/files/file.hpp"
#include "taut/results/result_file.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        return 2;
    }
    taut::write_file(argv[1], taut::result_schema());
}
