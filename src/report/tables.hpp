// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/study/study.hpp"

namespace taut::report {

// Tables of the page, as HTML.

/// MSE, MRSE and what else is known of the errors of the identified lengths: paper and here.
[[nodiscard]] std::string length_error_table(const Study& study);

/// Nominal and identified form errors (the paper's table "Error Statistics"): paper and here, in
/// mm.
[[nodiscard]] std::string form_error_table(const Study& study);

/// Seconds of each stage.
[[nodiscard]] std::string seconds_table(const Study& study);

/// What the study was run with, and what became of the samples.
[[nodiscard]] std::string settings_table(const Study& study, std::string_view version,
                                         std::string_view date);

}  // namespace taut::report
