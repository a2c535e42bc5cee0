// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/compas_attributes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "files/parse_number.hpp"

namespace taut {
namespace {

/// Those of an edge that mean something to taut.
constexpr std::array<std::string_view, 15> understood{
    "q",      "f",  "force", "l",  "length", "l0",         "E",       "r",
    "radius", "EA", "px",    "py", "pz",     "sag_weight", "friction"};

}  // namespace

void CompasAttributes::add(const JsonValue& object) {
    object.require_object("an object of attributes");
    for (const auto& [name, value] : object.json().items()) {
        for (const JsonValue& earlier : m_own) {
            const auto other = earlier.find(name);
            if (other && other->json() != value) {
                object.find(name)->fail(fmt::format("contradicts {}, where the same edge has {}",
                                                    other->pointer(), other->json().dump()));
            }
        }
    }
    m_own.push_back(object);
}

std::optional<JsonValue> CompasAttributes::find(const std::string& name) const {
    for (const JsonValue& object : m_own) {
        if (const auto value = object.find(name)) {
            return value->json().is_null() ? std::nullopt : value;
        }
    }
    const auto value = m_defaults ? m_defaults->find(name) : std::nullopt;
    return value && value->json().is_null() ? std::nullopt : value;
}

bool CompasAttributes::flag(const std::string& name, bool otherwise) const {
    const auto value = find(name);
    return value ? value->flag() : otherwise;
}

double CompasAttributes::number(const std::string& name, double otherwise) const {
    const auto value = find(name);
    return value ? value->number() : otherwise;
}

std::map<std::string, double> CompasAttributes::numbers() const {
    std::map<std::string, double> result;
    const auto take = [&](const JsonValue& object) {
        for (const auto& [name, value] : object.json().items()) {
            if (result.contains(name)) {
                continue;
            }
            if (std::ranges::find(understood, name) != understood.end()) {
                if (const auto given = find(name)) {
                    result.emplace(name, given->number());
                }
            } else if (value.is_number()) {
                result.emplace(name, value.get<double>());
            } else if (value.is_boolean()) {
                result.emplace(name, value.get<bool>() ? 1.0 : 0.0);
            } else if (value.is_string()) {
                if (const auto number = parse_number(value.get_ref<const std::string&>())) {
                    result.emplace(name, *number);
                }
            }
        }
    };
    std::ranges::for_each(m_own, take);
    if (m_defaults) {
        take(*m_defaults);
    }
    return result;
}

}  // namespace taut
