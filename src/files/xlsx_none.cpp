// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// In place of xlsx_reader.cpp and xlsx_writer.cpp, where taut was built without TAUT_WITH_XLSX.
#include <stdexcept>

#include "files/xlsx_reader.hpp"
#include "files/xlsx_writer.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

TableFile read_xlsx(std::string_view /*bytes*/, const std::string& file_name) {
    throw InputError(file_name, "",
                     "is a ZIP archive, as Excel files (xlsx) are, which this taut was built "
                     "without: save the table as CSV");
}

std::string xlsx_bytes(const std::vector<XlsxSheet>& /*sheets*/) {
    throw std::invalid_argument("this taut was built without Excel files (xlsx)");
}

}  // namespace taut
