// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace taut::test {

/// A file made by other people, which is not part of this repository: under TAUT_REAL_DATA, else
/// beside the repository in shared/data.
inline std::filesystem::path real_file(const std::string& name) {
    const char* const folder = std::getenv("TAUT_REAL_DATA");
    const std::filesystem::path root =
        std::filesystem::path(TAUT_TEST_DATA_DIR).parent_path().parent_path();
    return (folder != nullptr ? std::filesystem::path(folder)
                              : root.parent_path() / "shared/data") /
           name;
}

}  // namespace taut::test

/// Skips the test if the file does not exist.
#define TAUT_NEEDS_REAL_FILE(name)                                                             \
    if (!std::filesystem::exists(taut::test::real_file(name)))                                 \
    GTEST_SKIP() << "the real file " << taut::test::real_file(name) << " does not exist; set " \
                 << "TAUT_REAL_DATA to the folder that holds it"
