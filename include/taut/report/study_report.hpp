// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "taut/study/study.hpp"

namespace taut {

/// A study as one HTML page that needs nothing else, no script and no network: what was done in
/// plain sentences, the paper's figures beside ours, times, settings, and the plots of
/// study_figures_svg(). Light or dark as the reader's system is set, light in print. Text of the
/// net (its name, its ids) is escaped.
/// @param study as run_study() returns it
/// @param version of the program that ran it, shown as it is
/// @param date when it ran, shown as it is
/// @return the page in UTF-8
[[nodiscard]] std::string study_report_html(const Study& study, std::string_view version,
                                            std::string_view date);

}  // namespace taut
