// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "taut/files/table_file.hpp"

namespace taut {

/// Gives a part of an Excel file by its name, "xl/workbook.xml".
using XlsxPart = std::function<std::optional<std::string>(const std::string& name)>;

/// The sheet of an Excel file (xlsx, ECMA-376) that has a table, as CSV: that with a row of three
/// numbers; where none has one, that with any content. Each row is the line of its number, so that
/// a message names it. Numbers have all their digits, whatever their format shows; dates are text.
/// A formula counts by the value that was saved with it. Hidden sheets are left out.
/// @throws InputError with the row, for errors (#REF!), formulas without a value, cells merged over
///   rows of numbers and broken references; and where there is no such sheet, or more than one
[[nodiscard]] TableFile read_xlsx(const XlsxPart& part, const std::string& file_name);

/// The same of the whole file.
[[nodiscard]] TableFile read_xlsx(std::string_view bytes, const std::string& file_name);

}  // namespace taut
