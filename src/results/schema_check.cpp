// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/schema_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "files/message.hpp"

namespace taut {
namespace {

using nlohmann::json;

/// A rule with the definitions that it refers to in their places: the schema has no circles.
json inlined(const json& rule, const json& definitions) {
    if (const auto reference = rule.find("$ref"); reference != rule.end()) {
        constexpr std::string_view before = "#/definitions/";
        return inlined(definitions.at(reference->get<std::string>().substr(before.size())),
                       definitions);
    }
    json result = rule;
    for (json& entry : result) {
        if (entry.is_structured()) {
            entry = inlined(entry, definitions);
        }
    }
    return result;
}

const json& definitions() {
    static const json all = [] {
        const json as_written = json::parse(result_schema()).at("definitions");
        return inlined(as_written, as_written);
    }();
    return all;
}

struct Type {
    const char* words;
    bool (json::*is_of)() const noexcept;
};

const Type& type_named(const json& name) {
    static const std::map<std::string_view, Type> types{
        {"object", {"an object", &json::is_object}},
        {"array", {"an array", &json::is_array}},
        {"number", {"a number", &json::is_number}},
        {"boolean", {"true or false", &json::is_boolean}},
        {"integer", {"a whole number", &json::is_number_integer}},
        {"string", {"text", &json::is_string}},
        {"null", {"null", &json::is_null}},
    };
    return types.at(name.get_ref<const std::string&>());
}

/// Calls with the name of each type that a rule allows, its alternatives' where it has such, until
/// one call is true.
template <class Action>
bool any_type(const json& rule, const Action& action) {
    if (const auto alternatives = rule.find("anyOf"); alternatives != rule.end()) {
        return std::ranges::any_of(
            *alternatives, [&](const json& alternative) { return any_type(alternative, action); });
    }
    const json& type = rule.at("type");
    return type.is_string() ? action(type) : std::ranges::any_of(type, action);
}

bool is_of_type(const json& value, const json& rule) {
    return any_type(rule, [&](const json& name) { return (value.*type_named(name).is_of)(); });
}

/// "a number, or null".
std::string type_words(const json& rule) {
    std::string words;
    any_type(rule, [&](const json& name) {
        words += (words.empty() ? "" : ", or ") + std::string(type_named(name).words);
        return false;
    });
    return words;
}

void check(const JsonValue& value, const json& rule);

// One function a keyword: the value, which is of the rule's type, what the keyword says, the rule.

void nothing(const JsonValue& /*value*/, const json& /*argument*/, const json& /*rule*/) {}

/// Alternatives are told apart by their types.
void check_alternatives(const JsonValue& value, const json& alternatives, const json& /*rule*/) {
    check(value, *std::ranges::find_if(alternatives, [&](const json& alternative) {
              return is_of_type(value.json(), alternative);
          }));
}

void check_values(const JsonValue& value, const json& values, const json& /*rule*/) {
    if (std::ranges::find(values, value.json()) == values.end()) {
        std::string expected;
        for (const json& each : values) {
            expected += (expected.empty() ? "" : " or ") + each.dump();
        }
        value.fail(fmt::format("is {}, expected {}",
                               value.json().is_string() ? quote(value.text()) : value.json().dump(),
                               expected));
    }
}

void check_value(const JsonValue& value, const json& expected, const json& rule) {
    check_values(value, json{expected}, rule);
}

void check_minimum(const JsonValue& value, const json& least, const json& /*rule*/) {
    if (!value.json().is_null() && value.json() < least) {
        value.fail_type("at least " + least.dump());
    }
}

void check_maximum(const JsonValue& value, const json& most, const json& /*rule*/) {
    if (!value.json().is_null() && value.json() > most) {
        value.fail_type("at most " + most.dump());
    }
}

void check_least_size(const JsonValue& value, const json& least, const json& rule) {
    const size_t size = value.json().size();
    if (size == 0 && least > 0) {
        value.fail(fmt::format("is empty, expected at least {} {}", least.dump(),
                               least == 1 ? "entry" : "entries"));
    }
    if (least > size) {
        value.fail(fmt::format("has {} entries, expected {}{}", size,
                               rule.value("maxItems", json()) == least ? "" : "at least ",
                               least.dump()));
    }
}

void check_most_size(const JsonValue& value, const json& most, const json& rule) {
    if (most < value.json().size()) {
        value.fail(fmt::format("has {} entries, expected {}{}", value.json().size(),
                               rule.value("minItems", json()) == most ? "" : "at most ",
                               most.dump()));
    }
}

void check_entries(const JsonValue& value, const json& rule_of_entry, const json& /*rule*/) {
    for (size_t i = 0; i < value.json().size(); ++i) {
        check(value.at(i), rule_of_entry);
    }
}

void check_keys(const JsonValue& value, const json& keys, const json& rule) {
    for (const json& key : keys) {
        const auto& name = key.get_ref<const std::string&>();
        if (!value.json().contains(name)) {
            value.fail_below("/" + name,
                             "is missing, expected " + type_words(rule.at("properties").at(name)));
        }
    }
}

void check_members(const JsonValue& value, const json& rules, const json& /*rule*/) {
    for (const auto& [key, rule_of_member] : rules.items()) {
        if (const auto member = value.find(key)) {
            check(*member, rule_of_member);
        }
    }
}

void check_other_members(const JsonValue& value, const json& rule_of_member, const json& rule) {
    const auto named = rule.find("properties");
    for (const auto& [key, member] : value.json().items()) {
        if (named == rule.end() || !named->contains(key)) {
            check(*value.find(key), rule_of_member);
        }
    }
}

using KeywordCheck = void (*)(const JsonValue&, const json&, const json&);

/// A keyword that is not here is not in the schema: at() throws.
KeywordCheck check_of(const std::string& keyword) {
    static const std::map<std::string, KeywordCheck> checks{
        {"type", nothing},  // before all others
        {"title", nothing},
        {"description", nothing},
        {"anyOf", check_alternatives},
        {"enum", check_values},
        {"const", check_value},
        {"minimum", check_minimum},
        {"maximum", check_maximum},
        {"minItems", check_least_size},
        {"maxItems", check_most_size},
        {"items", check_entries},
        {"minProperties", check_least_size},
        {"required", check_keys},
        {"properties", check_members},
        {"additionalProperties", check_other_members},
    };
    return checks.at(keyword);
}

void check(const JsonValue& value, const json& rule) {
    if (!is_of_type(value.json(), rule)) {
        value.fail_type(type_words(rule));
    }
    for (const auto& [keyword, argument] : rule.items()) {
        check_of(keyword)(value, argument, rule);
    }
}

}  // namespace

void check_against_schema(const JsonValue& value, const std::string& definition) {
    check(value, definitions().at(definition));
}

}  // namespace taut
