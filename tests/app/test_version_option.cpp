// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/version.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace {

TEST(VersionOption, PrintsTheVersionOfTheLibrary) {
    FILE* output = popen(TAUT_PROGRAM " --version", "r");
    ASSERT_NE(output, nullptr);
    std::array<char, 256> line{};
    const std::string printed = std::fgets(line.data(), line.size(), output) ? line.data() : "";
    EXPECT_EQ(pclose(output), 0);
    EXPECT_EQ(printed, "taut " + std::string{taut::version()} + "\n");
}

}  // namespace
