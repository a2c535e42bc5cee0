// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against messages that break the one line an error has, whatever a file or its name holds.

#include "taut/files/input_error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace taut {
namespace {

TEST(InputError, NamesFilePlaceAndWhatIsWrong) {
    EXPECT_STREQ(InputError("net.json", "/edges/3", "is wrong").what(),
                 "net.json:/edges/3: is wrong");
    EXPECT_STREQ(InputError("net.json", "", "is empty").what(), "net.json: is empty");
}

TEST(InputError, KeepsItsMessageOnOneLine) {
    EXPECT_STREQ(InputError("a\nb", "/c\r\x1b", "d\x7f\te").what(),
                 R"(a\u000ab:/c\u000d\u001b: d\u007f\u0009e)");
}

TEST(InputError, CutsAPlaceThatIsAsLongAsTheFile) {
    const InputError error("a", std::string(1'000'000, 'k'), "is wrong");
    EXPECT_LT(std::string(error.what()).size(), 300U);
}

}  // namespace
}  // namespace taut
