// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "files/json_value.hpp"

namespace taut {

/// Checks a value against a definition of the schema, with the keywords that the schema uses.
/// @param definition "study", "identification", "comparison", "plan" or "control"
/// @throws InputError at the first value that the schema refuses
void check_against_schema(const JsonValue& value, const std::string& definition);

}  // namespace taut
