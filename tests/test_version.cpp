// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/version.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace {

TEST(Version, IsThreeNumbersWithDots) {
    EXPECT_THAT(std::string{taut::version()}, testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
}

}  // namespace
