// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against names that a spreadsheet runs as a formula when it opens a table of taut, and that
// are other names when taut reads the table again.

#include "files/csv_field.hpp"

#include <gtest/gtest.h>

#include "files/csv_reader.hpp"

namespace taut {
namespace {

const std::string file_name = "a.csv";

TEST(CsvField, LeadsWhatASpreadsheetWouldRunByAnApostropheAndIsReadBack) {
    for (const std::string name :
         {"=1+1", "+cmd|x", "-2+3", "@sum", "\tx", "\r=x", "'=x", "''=x", "=a,b", "-", "=\"q\""}) {
        const std::string field = csv_field(name);
        const std::string bare = field.substr(field.starts_with('"') ? 1 : 0);
        EXPECT_TRUE(bare.starts_with('\'')) << field;
        const std::string text = field + ",1\n";
        CsvReader reader(text, file_name);
        const auto record = reader.next();
        ASSERT_TRUE(record);
        EXPECT_EQ(record->fields.front(), name) << text;
    }
}

TEST(CsvField, LeavesNumbersAndOtherNamesAsTheyAre) {
    for (const std::string name : {"-0.5", "+3", "-1e-3", "12", "A-1", "'x", "O'Neil", "'"}) {
        EXPECT_EQ(csv_field(name), name);
        const std::string text = name + ",1\n";
        CsvReader reader(text, file_name);
        EXPECT_EQ(reader.next()->fields.front(), name);
    }
}

}  // namespace
}  // namespace taut
