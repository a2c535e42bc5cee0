// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/schema_check.hpp"

#include <fmt/core.h>

#include <map>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "taut/results/result_file.hpp"

// No other source includes valijson: it takes seconds to compile.

namespace taut {
namespace {

using nlohmann::json;
using valijson::adapters::NlohmannJsonAdapter;

const json& definitions() {
    static const json all = json::parse(result_schema()).at("definitions");
    return all;
}

/// A rule of the schema as valijson has it.
class Judge {
public:
    explicit Judge(const json& rule) {
        const json document{{"definitions", definitions()}, {"allOf", json::array({rule})}};
        valijson::SchemaParser().populateSchema(NlohmannJsonAdapter(document), m_schema);
    }

    /// Collects no reasons: for a large file that is wrong throughout they would take many times
    /// the memory of the file.
    [[nodiscard]] bool accepts(const json& value) const {
        return valijson::Validator().validate(m_schema, NlohmannJsonAdapter(value), nullptr);
    }

private:
    valijson::Schema m_schema;
};

const json* find(const json& object, const std::string& key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

/// The rule that a "$ref" names, or the rule itself.
const json& referred(const json& rule) {
    const json* reference = find(rule, "$ref");
    if (reference == nullptr) {
        // Rules are parts of the schema, which stays.
        return rule;  // NOLINT(bugprone-return-const-ref-from-parameter)
    }
    constexpr std::string_view before = "#/definitions/";
    const auto& name = reference->get_ref<const std::string&>();
    return referred(definitions().at(name.substr(before.size())));
}

/// The alternative of a rule for values of this type; the rule itself without fitting alternatives.
const json& rule_for(const json& value, const json& rule_or_reference) {
    const json& rule = referred(rule_or_reference);
    if (const json* alternatives = find(rule, "anyOf")) {
        for (const json& alternative : *alternatives) {
            if (const json& fitting = referred(alternative);
                fitting.value("type", json()) == value.type_name()) {
                return fitting;
            }
        }
    }
    return rule;
}

/// The rule for a member of an object; null where the schema has none.
const json* rule_of_member(const json& rule, const std::string& key) {
    const json* properties = find(rule, "properties");
    const json* named = properties == nullptr ? nullptr : find(*properties, key);
    return named == nullptr ? find(rule, "additionalProperties") : named;
}

/// "at least 0", "0 to 1", "3"; empty without limits.
std::string range_words(const json& rule, const char* least, const char* most) {
    const json* from = find(rule, least);
    const json* to = find(rule, most);
    if (from == nullptr || to == nullptr) {
        return from != nullptr ? "at least " + from->dump()
               : to != nullptr ? "at most " + to->dump()
                               : "";
    }
    return *from == *to ? from->dump() : fmt::format("{} to {}", from->dump(), to->dump());
}

/// "a number of at least 0".
std::string type_words(const json& rule, const std::string& type) {
    struct Type {
        const char* name;
        const char* least;
        const char* most;
        const char* counted;
    };
    static const std::map<std::string, Type> types{
        {"object", {"an object", "minProperties", "maxProperties", " entries"}},
        {"array", {"an array", "minItems", "maxItems", " entries"}},
        {"number", {"a number", "minimum", "maximum", ""}},
        {"integer", {"a whole number", "minimum", "maximum", ""}},
        {"boolean", {"true or false", "", "", ""}},
        {"string", {"text", "", "", ""}},
        {"null", {"null", "", "", ""}},
    };
    const Type& it = types.at(type);
    const std::string range = range_words(rule, it.least, it.most);
    return range.empty() ? it.name : fmt::format("{} of {}{}", it.name, range, it.counted);
}

/// The values that a rule accepts: "a number of at least 0, or null".
std::string words_of(const json& rule_or_reference) {
    const json& rule = referred(rule_or_reference);
    std::string words;
    const auto add = [&words](const std::string& alternative) {
        words += (words.empty() ? "" : ", or ") + alternative;
    };
    if (const json* alternatives = find(rule, "anyOf")) {
        for (const json& alternative : *alternatives) {
            add(words_of(alternative));
        }
    } else if (const json* values = find(rule, "enum")) {
        for (const json& value : *values) {
            words += (words.empty() ? "" : " or ") + value.dump();
        }
    } else if (const json* only = find(rule, "const")) {
        add(only->dump());
    } else if (const json* types = find(rule, "type")) {
        for (const json& type : types->is_array() ? *types : json::array({*types})) {
            add(type_words(rule, type.get_ref<const std::string&>()));
        }
    }
    return words;
}

/// Fails at the innermost part of a value that its rule refuses. valijson alone decides; the rules
/// are read to find that of each part, and for the words.
[[noreturn]] void refuse(const JsonValue& value, const json& rule_or_alternatives) {
    const json& content = value.json();
    const json& rule = rule_for(content, rule_or_alternatives);
    const json* of_entry = find(rule, "items");
    if (content.is_array() && of_entry != nullptr) {
        const Judge judge(*of_entry);
        for (size_t i = 0; i < content.size(); ++i) {
            if (!judge.accepts(content[i])) {
                refuse(value.at(i), *of_entry);
            }
        }
    }
    if (content.is_object()) {
        for (const auto& [key, member] : content.items()) {
            const json* of_member = rule_of_member(rule, key);
            if (of_member != nullptr && !Judge(*of_member).accepts(member)) {
                refuse(*value.find(key), *of_member);
            }
        }
        for (const json& required : rule.value("required", json::array())) {
            const auto& key = required.get_ref<const std::string&>();
            if (!content.contains(key)) {
                const json* of_member = rule_of_member(rule, key);
                value.fail_below("/" + key,
                                 "is missing, expected " +
                                     (of_member == nullptr ? "some value" : words_of(*of_member)));
            }
        }
    }
    if (content.is_structured() &&
        find(rule, content.is_array() ? "minItems" : "minProperties") != nullptr) {
        value.fail(fmt::format(
            "{}, expected {}",
            content.empty() ? "is empty" : fmt::format("has {} entries", content.size()),
            words_of(rule)));
    }
    value.fail_type(words_of(rule_or_alternatives));
}

}  // namespace

void check_against_schema(const JsonValue& value, const std::string& definition) {
    const json& rule = definitions().at(definition);
    if (!Judge(rule).accepts(value.json())) {
        refuse(value, rule);
    }
}

}  // namespace taut
