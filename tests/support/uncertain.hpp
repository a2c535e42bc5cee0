// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <vector>

#include "taut/sampling/uncertain_parameter.hpp"

namespace taut::test {

/// Of texts as "supports:1mm".
inline std::vector<UncertainParameter> uncertain(std::initializer_list<const char*> texts) {
    std::vector<UncertainParameter> result;
    for (const char* text : texts) {
        result.push_back(parse_uncertain_parameter(text));
    }
    return result;
}

}  // namespace taut::test
