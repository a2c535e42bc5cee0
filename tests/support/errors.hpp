// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "taut/files/input_error.hpp"

namespace taut::test {

/// The message of the InputError that the action throws; a test failure if it throws none.
template <typename Action>
std::string input_error_of(const Action& action) {
    try {
        static_cast<void>(action());
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "not one line";
        return error.what();
    }
    ADD_FAILURE() << "expected an InputError";
    return {};
}

/// Runs the action. True if it gave a result, false if it threw an InputError. Other exceptions
/// propagate.
template <typename Action>
bool succeeds_or_refuses(const Action& action) {
    try {
        static_cast<void>(action());
        return true;
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace taut::test
