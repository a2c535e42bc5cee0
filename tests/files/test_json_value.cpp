// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a value of another type than a reader takes for granted that ends the program in
// the words of nlohmann-json.

#include "files/json_value.hpp"

#include <gmock/gmock.h>

#include "files/json_parse.hpp"
#include "support/errors.hpp"

namespace taut {
namespace {

using test::input_error_of;

TEST(JsonValue, HasNoEntryOfANumberNorBehindTheLast) {
    const auto entry_of = [](const std::string& text, size_t index) {
        return input_error_of([&] {
            return read_json(text, "a.json", [index](const JsonValue& root) {
                return root.require("list", "an array").at(index).number();
            });
        });
    };
    EXPECT_EQ(entry_of(R"({"list": -0.012})", 0), "a.json:/list: is -0.012, expected an array");
    EXPECT_EQ(entry_of(R"({"list": [1, 2]})", 2),
              "a.json:/list: has 2 entries, expected more than 2");
}

TEST(ReadJson, NamesTheFileWhereItsReaderTakesAnotherTypeForGranted) {
    const auto error = input_error_of([] {
        return read_json("[1, 2]", "a.json", [](const JsonValue& root) {
            return root.json().at("key").get<std::string>();
        });
    });
    EXPECT_THAT(error, testing::StartsWith("a.json: holds a value of another type"));
    EXPECT_THAT(error, testing::Not(testing::HasSubstr("json.exception")));
}

}  // namespace
}  // namespace taut
