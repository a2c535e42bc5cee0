// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "taut/export/io.hpp"
#include "taut/results/result_file.hpp"

namespace taut {

/// An Excel file.
struct ResultXlsx {
    std::string bytes;                 ///< of the file
    std::vector<std::string> remarks;  ///< above its tables: why nobody should work by them
};

/// The tables of a result as sheets of an Excel file (xlsx): of a plan the work list of
/// plan_to_csv(), with the same columns, of an identification its edges and nodes. Titles name the
/// unit.
/// @param file_name of the result, for messages
/// @throws InputError for other results, which have no such tables
/// @throws std::invalid_argument for a name of more than 32767 bytes, and where taut was built
///   without Excel files
[[nodiscard]] TAUT_IO_EXPORT ResultXlsx result_to_xlsx(const ResultFile& result,
                                                       const std::string& file_name);

}  // namespace taut
