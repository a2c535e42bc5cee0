// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "results/description.hpp"

#include <stdexcept>

namespace taut {

void read_value(const JsonValue& json, UncertainParameter& value) {
    try {
        value = parse_uncertain_parameter(json.text());
    } catch (const std::invalid_argument& error) {
        json.fail(error.what());
    }
}

void read_value(const JsonValue& json, EdgeStatus& value) {
    value = json.text() == "unobserved" ? EdgeStatus::not_determined : EdgeStatus::determined;
    for (const EdgeStatus status : enumerators<EdgeStatus>()) {
        value = json.text() == to_string(status) ? status : value;
    }
}

void read_value(const JsonValue& json, ForceSource& value) {
    for (const ForceSource source : enumerators<ForceSource>()) {
        value = json.text() == to_string(source) ? source : value;
    }
}

}  // namespace taut
