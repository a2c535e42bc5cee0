// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>

namespace taut::test {

/// The message with which an action is refused; "not refused" where it is taken. Other exceptions
/// propagate.
template <class Error = std::invalid_argument, class Action>
std::string refusal_of(const Action& action) {
    try {
        static_cast<void>(action());
    } catch (const Error& error) {
        return error.what();
    }
    return "not refused";
}

/// Expects an action to be refused with some words.
template <class Error = std::invalid_argument, class Action>
void expect_refused(const Action& action, const std::string& words) {
    EXPECT_THAT(refusal_of<Error>(action), testing::HasSubstr(words));
}

}  // namespace taut::test
