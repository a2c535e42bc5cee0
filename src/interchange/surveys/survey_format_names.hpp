// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "taut/interchange/foreign_survey.hpp"

namespace taut {

/// For people: "a Leica GSI file".
[[nodiscard]] std::string_view words_of(SurveyFormat format);

}  // namespace taut
