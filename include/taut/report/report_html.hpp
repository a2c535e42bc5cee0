// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/export/report.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

/// Whether this build contains the report's viewer, which needs Node.js to build.
[[nodiscard]] TAUT_REPORT_EXPORT bool has_report_viewer();

/// A result as one self-contained HTML page that loads nothing over the network: the viewer
/// (viewer/) and the result, from which the viewer makes summary, 3D view, charts, tables and
/// lists. Text of the result is never taken for markup, and the page's content security policy
/// allows no script but the viewer.
/// @return the page in UTF-8
/// @throws std::runtime_error where has_report_viewer() is false
[[nodiscard]] TAUT_REPORT_EXPORT std::string report_html(const ResultFile& result);

}  // namespace taut
