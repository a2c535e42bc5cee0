// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "taut/export/io.hpp"

namespace taut {

/// A table as text.
struct TableFile {
    std::string
        text;  ///< the bytes of a text file; of a sheet CSV, each row the line of its number
    std::string sheet;  ///< the name of the sheet; empty: a text file
};

/// Reads a text file, or the sheet of an Excel file (xlsx) that has a table.
/// @throws InputError as read_file(), with the row for a cell without a value to read (an error, a
///   formula that was never computed), and for an Excel file that is damaged, encrypted, of the old
///   format (xls), larger than 32 MiB when unpacked, or with no table or several; for any where
///   taut was built without Excel files
[[nodiscard]] TAUT_IO_EXPORT TableFile read_table_file(const std::filesystem::path& path);

/// The text of read_table_file().
[[nodiscard]] TAUT_IO_EXPORT std::string read_table(const std::filesystem::path& path);

}  // namespace taut
