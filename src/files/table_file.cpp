// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/files/table_file.hpp"

#include "files/xlsx_reader.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

TableFile read_table_file(const std::filesystem::path& path) {
    TableFile table{.text = read_file(path), .sheet = {}};
    if (table.text.starts_with("PK\x03\x04")) {
        return read_xlsx(table.text, path.string());
    }
    if (table.text.starts_with("\xD0\xCF\x11\xE0")) {
        throw InputError(path.string(), "",
                         "is an old Office file (xls), or encrypted: save it as xlsx without a "
                         "password, or as CSV");
    }
    return table;
}

std::string read_table(const std::filesystem::path& path) {
    return read_table_file(path).text;
}

}  // namespace taut
