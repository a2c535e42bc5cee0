// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "files/json_value.hpp"

namespace taut {

/// The attributes of one node or edge: its own, in one or more objects that must agree, and
/// defaults for the rest. An attribute that is null counts as not given.
class CompasAttributes {
public:
    explicit CompasAttributes(const std::optional<JsonValue>& defaults) : m_defaults(defaults) {}

    /// @throws InputError where the object gives an attribute another value than one before it
    void add(const JsonValue& object);

    [[nodiscard]] std::optional<JsonValue> find(const std::string& name) const;
    /// @throws InputError where it is neither true nor false
    [[nodiscard]] bool flag(const std::string& name, bool otherwise) const;
    [[nodiscard]] double number(const std::string& name, double otherwise) const;
    /// All that are numbers, or text that is one, or true or false.
    /// @throws InputError where one that taut understands is no number
    [[nodiscard]] std::map<std::string, double> numbers() const;

private:
    std::optional<JsonValue> m_defaults;
    std::vector<JsonValue> m_own;
};

}  // namespace taut
