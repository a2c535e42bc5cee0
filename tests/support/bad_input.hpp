// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/errors.hpp"

namespace taut::test {

/// An invalid text, and the message of its refusal behind the name of the file.
struct BadText {
    std::string text;
    std::string message;  ///< whole, or its beginning where it ends in "..."
};

inline void expect_message(const std::string& message, const std::string& expected) {
    if (expected.ends_with("...")) {
        EXPECT_THAT(message, testing::StartsWith(expected.substr(0, expected.size() - 3)));
    } else {
        EXPECT_EQ(message, expected);
    }
}

/// Each text is refused with its message.
/// @param parse reads a text under the name of the file
template <class Parse>
void expect_refused(const std::string& file, const std::vector<BadText>& texts,
                    const Parse& parse) {
    for (const BadText& bad : texts) {
        SCOPED_TRACE("'" + bad.text.substr(0, 200) + "'");
        expect_message(input_error_of([&] { return parse(bad.text); }), file + bad.message);
    }
}

/// A change of one value of a valid document, and the message of its refusal.
struct BadValue {
    std::string at;     ///< JSON pointer
    std::string value;  ///< JSON, or the pointer to a value that is put there; empty to remove it
    std::string message;
};

/// Of lines "pointer | value | message". A line that begins with four blanks continues the one
/// before it.
inline std::vector<BadValue> bad_values(const std::string& table) {
    std::vector<std::string> lines;
    std::istringstream stream(table);
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with("    ")) {
            lines.back() += line.substr(3);
        } else if (!line.empty()) {
            lines.push_back(line);
        }
    }
    std::vector<BadValue> values;
    for (const std::string& line : lines) {
        const size_t first = line.find(" | ");
        const size_t last = line.find(" | ", first + 2);
        EXPECT_NE(last, std::string::npos) << line;
        values.push_back({line.substr(0, first),
                          last > first + 3 ? line.substr(first + 3, last - first - 3) : "",
                          line.substr(last + 3)});
    }
    return values;
}

inline nlohmann::json changed(nlohmann::json document, const BadValue& bad) {
    const nlohmann::json::json_pointer at(bad.at);
    if (bad.value.empty()) {
        return document.patch({{{"op", "remove"}, {"path", bad.at}}});
    }
    document[at] = bad.value.starts_with('/')
                       ? nlohmann::json(document.at(nlohmann::json::json_pointer(bad.value)))
                       : nlohmann::json::parse(bad.value);
    return document;
}

/// Each change of a document is refused with its message.
/// @param table of the changes. A message stands behind the pointer, or begins with one of its own
/// @param parse reads the changed document under the name of the file
template <class Parse>
void expect_refused(const std::string& file, const nlohmann::json& document,
                    const std::string& table, const Parse& parse) {
    for (const BadValue& bad : bad_values(table)) {
        SCOPED_TRACE(bad.at + " | " + bad.value);
        const std::string place = bad.at.empty()                 ? ": "
                                  : bad.message.starts_with('/') ? ":"
                                                                 : ":" + bad.at + ": ";
        expect_message(input_error_of([&] { return parse(changed(document, bad).dump()); }),
                       file + place + bad.message);
    }
}

}  // namespace taut::test
