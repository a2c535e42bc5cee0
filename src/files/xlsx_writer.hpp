// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace taut {

/// Nothing, a number, or a text, which no spreadsheet takes for a formula.
using XlsxCell = std::variant<std::monostate, double, std::string>;

struct XlsxColumn {
    std::string title;  ///< with its unit: "stroke_mm"
    int decimals = 0;   ///< that are shown; numbers are kept whole
};

/// A sheet for print and for filling in: A4 landscape, as wide as the page, with the titles on each
/// page, and in sight while it is scrolled.
struct XlsxSheet {
    std::string name;                  ///< one word
    std::vector<std::string> remarks;  ///< lines above the titles, led by #
    std::vector<XlsxColumn> columns;
    std::vector<std::vector<XlsxCell>> rows;  ///< a cell a column
};

/// The bytes of an Excel file (xlsx), the same for the same sheets. libxlsxwriter would write files
/// only, with their date, 16 digits and the locale's decimal sign, print where that fails, and
/// bring OpenSSL along.
/// @throws std::invalid_argument for a text of more than 32767 bytes, and where taut was built
///   without Excel files
[[nodiscard]] std::string xlsx_bytes(const std::vector<XlsxSheet>& sheets);

}  // namespace taut
