// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

#include "taut/version.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

TEST(Version, IsThatOfTheHeaders) {
    EXPECT_EQ(taut::version(), std::to_string(TAUT_VERSION_MAJOR) + "." +
                                   std::to_string(TAUT_VERSION_MINOR) + "." +
                                   std::to_string(TAUT_VERSION_PATCH));
    EXPECT_EQ(TAUT_VERSION_NUMBER,
              10000 * TAUT_VERSION_MAJOR + 100 * TAUT_VERSION_MINOR + TAUT_VERSION_PATCH);
}

}  // namespace
