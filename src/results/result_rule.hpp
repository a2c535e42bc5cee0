// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace taut {

/// JSON of all results; it keeps the order of keys.
using ResultJson = nlohmann::ordered_json;

/// Common rules for numbers.
enum class NumberRule {
    size,   ///< at least 0
    part,   ///< 0 to 1
    whole,  ///< an integer of at least 0
};
using enum NumberRule;

/// What a value of a result may be, as JSON Schema has it, with the definitions that it refers to.
class Rule {
public:
    explicit Rule(ResultJson json, ResultJson definitions = ResultJson::object())
        : m_json(std::move(json)), m_definitions(std::move(definitions)) {}

    Rule(NumberRule rule);  // NOLINT(google-explicit-constructor): lists of fields read better

    [[nodiscard]] static Rule number() { return Rule(ResultJson{{"type", "number"}}); }
    /// One that fits an int: a count, or the index of a node or edge.
    [[nodiscard]] static Rule count();
    [[nodiscard]] static Rule text() { return Rule(ResultJson{{"type", "string"}}); }
    [[nodiscard]] static Rule flag() { return Rule(ResultJson{{"type", "boolean"}}); }
    [[nodiscard]] static Rule one_of(const std::vector<std::string>& words);
    /// This text or number alone.
    [[nodiscard]] static Rule only(const ResultJson& value);
    [[nodiscard]] static Rule list_of(const Rule& entry);
    /// A list of so many.
    [[nodiscard]] static Rule list_of(const Rule& entry, int size);
    /// x, y, z.
    [[nodiscard]] static Rule point() { return list_of(number(), 3); }
    /// An object whose keys are names, at least one.
    [[nodiscard]] static Rule by_name(const Rule& member);
    [[nodiscard]] static Rule any_of(const Rule& one, const Rule& other);

    [[nodiscard]] Rule or_null() const;
    /// Of a list: with an entry at least.
    [[nodiscard]] Rule not_empty() const;
    /// @param text empty: as it is
    [[nodiscard]] Rule with_text(const std::string& text) const;

    [[nodiscard]] const ResultJson& json() const { return m_json; }
    /// Rules by name.
    [[nodiscard]] const ResultJson& definitions() const { return m_definitions; }

private:
    ResultJson m_json;
    ResultJson m_definitions = ResultJson::object();
};

/// The rule for an object with some keys; others may occur.
class ObjectRule {
public:
    /// @param name of its definition; empty: it stands where it is used
    ObjectRule(std::string name, std::string text)
        : m_name(std::move(name)), m_text(std::move(text)) {}

    void add(const std::string& key, const Rule& rule, bool is_required);
    [[nodiscard]] Rule rule() const;

private:
    std::string m_name;
    std::string m_text;
    ResultJson m_required = ResultJson::array();
    ResultJson m_properties = ResultJson::object();
    ResultJson m_definitions = ResultJson::object();
};

}  // namespace taut
