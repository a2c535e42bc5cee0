// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/study/study.hpp"

namespace taut::app {

/// The figures of a study beside those of the paper, as text.
[[nodiscard]] std::string paper_table(const Study& study);

}  // namespace taut::app
