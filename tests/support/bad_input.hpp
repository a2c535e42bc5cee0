// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace taut::test {

/// An invalid text, and the message of its refusal.
struct BadText {
    const char* name;
    std::string text;
    std::string message;
};

/// A change of one value of a valid document: a JSON pointer, and what to put there.
struct BadValue {
    const char* name;
    const char* at;
    const char* value;  ///< JSON, or empty to remove the key
    const char* message;
};

}  // namespace taut::test
