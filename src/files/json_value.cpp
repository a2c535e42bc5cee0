// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/json_value.hpp"

#include <fmt/core.h>

#include <limits>

#include "files/message.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// "is a string", "is 1.5".
std::string describe(const nlohmann::json& value) {
    switch (value.type()) {
        case nlohmann::json::value_t::null:
            return "is null";
        case nlohmann::json::value_t::object:
            return "is an object";
        case nlohmann::json::value_t::array:
            return "is an array";
        case nlohmann::json::value_t::string:
            return "is the text " + quote(value.get_ref<const std::string&>());
        default:
            return "is " + value.dump();
    }
}

}  // namespace

void JsonValue::fail(const std::string& what) const {
    throw InputError(*m_file_name, m_pointer, what);
}

void JsonValue::fail_below(const std::string& pointer, const std::string& what) const {
    throw InputError(*m_file_name, m_pointer + pointer, what);
}

void JsonValue::fail_type(const std::string& expected) const {
    fail(fmt::format("{}, expected {}", describe(*m_value), expected));
}

void JsonValue::require_object(const std::string& expected) const {
    if (!m_value->is_object()) {
        fail_type(expected);
    }
}

size_t JsonValue::array_size(const std::string& expected) const {
    if (!m_value->is_array()) {
        fail_type(expected);
    }
    return m_value->size();
}

void JsonValue::require_array(size_t size, const std::string& expected) const {
    if (const size_t found = array_size(expected); found != size) {
        fail(fmt::format("has {} entries, expected {}", found, expected));
    }
}

double JsonValue::number() const {
    if (!m_value->is_number()) {
        fail_type("a number");
    }
    return m_value->get<double>();
}

int JsonValue::integer() const {
    if (!m_value->is_number_integer()) {
        fail_type("a whole number");
    }
    // What does not fit a signed 64-bit number is unsigned there.
    if (m_value->is_number_unsigned() &&
        m_value->get<std::uint64_t>() > std::numeric_limits<int>::max()) {
        fail_type(fmt::format("a whole number up to {}", std::numeric_limits<int>::max()));
    }
    const auto value = m_value->get<std::int64_t>();
    if (value < std::numeric_limits<int>::min()) {
        fail_type(fmt::format("a whole number from {}", std::numeric_limits<int>::min()));
    }
    return static_cast<int>(value);
}

const std::string& JsonValue::text() const {
    if (!m_value->is_string()) {
        fail_type("text");
    }
    return m_value->get_ref<const std::string&>();
}

bool JsonValue::flag() const {
    if (m_value->is_boolean()) {
        return m_value->get<bool>();
    }
    if (*m_value != 0 && *m_value != 1) {
        fail_type("true or false");
    }
    return *m_value == 1;
}

JsonValue JsonValue::at(size_t index) const {
    if (const size_t size = array_size("an array"); index >= size) {
        fail(fmt::format("has {} entries, expected more than {}", size, index));
    }
    return {(*m_value)[index], *m_file_name, fmt::format("{}/{}", m_pointer, index)};
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
    const auto found = m_value->find(key);
    if (found == m_value->end()) {
        return std::nullopt;
    }
    const nlohmann::json::json_pointer pointer(m_pointer);
    return JsonValue(*found, *m_file_name, (pointer / key).to_string());
}

JsonValue JsonValue::require(const std::string& key, const std::string& expected) const {
    const auto found = find(key);
    if (!found) {
        throw InputError(*m_file_name, fmt::format("{}/{}", m_pointer, key),
                         "is missing, expected " + expected);
    }
    return *found;
}

}  // namespace taut
