// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace taut {

/// A value in a JSON file that knows where it stands, so that a type error names the place and what
/// was expected there. All members throw InputError at the value's JSON pointer. Does not own the
/// value, nor the file's name.
class JsonValue {
public:
    JsonValue(const nlohmann::json& value, const std::string& file_name, std::string pointer = "")
        : m_value(&value), m_file_name(&file_name), m_pointer(std::move(pointer)) {}

    [[noreturn]] void fail(const std::string& what) const;
    /// "is the text 'x', expected a number".
    [[noreturn]] void fail_type(const std::string& expected) const;
    [[nodiscard]] const std::string& pointer() const { return m_pointer; }
    /// @param pointer to the bad value, from here
    [[noreturn]] void fail_below(const std::string& pointer, const std::string& what) const;
    [[nodiscard]] const std::string& file_name() const { return *m_file_name; }
    [[nodiscard]] const nlohmann::json& json() const { return *m_value; }

    /// @param expected what to ask for where it is of another type, "an object" say
    void require_object(const std::string& expected) const;
    /// Entries of an array.
    [[nodiscard]] size_t array_size(const std::string& expected) const;
    /// Entries of an array that holds so many.
    void require_array(size_t size, const std::string& expected) const;
    [[nodiscard]] double number() const;
    /// A whole number that fits an int, written without fraction or exponent.
    [[nodiscard]] int integer() const;
    [[nodiscard]] const std::string& text() const;
    /// true or false, or 1 or 0.
    [[nodiscard]] bool flag() const;

    /// Entry of an array, which must have it.
    [[nodiscard]] JsonValue at(size_t index) const;
    /// Member of an object, if it has it.
    [[nodiscard]] std::optional<JsonValue> find(const std::string& key) const;
    /// Member of an object, which must have it.
    [[nodiscard]] JsonValue require(const std::string& key, const std::string& expected) const;

private:
    const nlohmann::json* m_value;
    const std::string* m_file_name;
    std::string m_pointer;
};

}  // namespace taut
