// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/result_rule.hpp"

#include <limits>

namespace taut {

Rule::Rule(NumberRule rule)
    : m_json{{"type", rule == whole ? "integer" : "number"}, {"minimum", 0}} {
    if (rule == part) {
        m_json["maximum"] = 1;
    }
}

Rule Rule::count() {
    return Rule(ResultJson{
        {"type", "integer"}, {"minimum", 0}, {"maximum", std::numeric_limits<int>::max()}});
}

Rule Rule::one_of(const std::vector<std::string>& words) {
    return Rule(ResultJson{{"type", "string"}, {"enum", words}});
}

Rule Rule::only(const ResultJson& value) {
    return Rule(ResultJson{{"type", value.is_string() ? "string" : "integer"}, {"const", value}});
}

Rule Rule::list_of(const Rule& entry) {
    return Rule(ResultJson{{"type", "array"}, {"items", entry.m_json}}, entry.m_definitions);
}

Rule Rule::list_of(const Rule& entry, int size) {
    Rule list = list_of(entry);
    list.m_json["minItems"] = size;
    list.m_json["maxItems"] = size;
    return list;
}

Rule Rule::by_name(const Rule& member) {
    return Rule(
        ResultJson{
            {"type", "object"}, {"minProperties", 1}, {"additionalProperties", member.m_json}},
        member.m_definitions);
}

Rule Rule::any_of(const Rule& one, const Rule& other) {
    Rule any(ResultJson{{"anyOf", ResultJson::array({one.m_json, other.m_json})}},
             one.m_definitions);
    any.m_definitions.update(other.m_definitions);
    return any;
}

Rule Rule::or_null() const {
    const auto type = m_json.find("type");
    if (type == m_json.end() || *type == "object" || *type == "array") {
        return any_of(*this, Rule(ResultJson{{"type", "null"}}));
    }
    Rule rule = *this;
    rule.m_json["type"] = ResultJson::array({*type, "null"});
    if (rule.m_json.contains("enum")) {
        rule.m_json["enum"].push_back(nullptr);
    }
    return rule;
}

Rule Rule::not_empty() const {
    Rule rule = *this;
    rule.m_json["minItems"] = 1;
    return rule;
}

Rule Rule::with_text(const std::string& text) const {
    if (text.empty()) {
        return *this;
    }
    ResultJson json{{"description", text}};
    json.update(m_json);
    json["description"] = text;
    return Rule(json, m_definitions);
}

void ObjectRule::add(const std::string& key, const Rule& rule, bool is_required) {
    m_properties[key] = rule.json();
    m_definitions.update(rule.definitions());
    if (is_required) {
        m_required.push_back(key);
    }
}

Rule ObjectRule::rule() const {
    ResultJson object{{"type", "object"}, {"properties", m_properties}};
    if (!m_required.empty()) {
        object["required"] = m_required;
    }
    Rule inner = Rule(object, m_definitions).with_text(m_text);
    if (m_name.empty()) {
        return inner;
    }
    ResultJson definitions{{m_name, inner.json()}};
    definitions.update(m_definitions);
    return Rule({{"$ref", "#/definitions/" + m_name}}, definitions);
}

}  // namespace taut
