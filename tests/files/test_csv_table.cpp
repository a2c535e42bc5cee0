// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a column that is taken for another, and lines that are dropped or shortened
// without a word.

#include "files/csv_table.hpp"

#include <gmock/gmock.h>

#include "support/bad_input.hpp"

namespace taut {
namespace {

using Header = CsvColumns::Header;

CsvTable force_table(std::string_view text, Header header = Header::optional) {
    return {text,
            "a.csv",
            {.names = {"edge", "force", "std"}, .optional = 1, .header = header},
            "holds no force"};
}

TEST(CsvTable, HasItsHeaderAndItsLastColumnOrNot) {
    for (const char* text : {"edge,force\nA,2\n", "A;2\n", "# all\n\nA 2\n"}) {
        const CsvTable table = force_table(text);
        ASSERT_EQ(table.rows().size(), 1U) << text;
        EXPECT_EQ(table.text(table.rows()[0], 0), "A");
        EXPECT_EQ(table.number(table.rows()[0], 1), 2.0);
        EXPECT_FALSE(table.has(2));
    }
    const CsvTable whole = force_table("edge,force,std\nA,2,.5\n", Header::required);
    EXPECT_EQ(whole.number(whole.rows()[0], 2), 0.5);
}

TEST(CsvTable, OfQuotedTitlesWithBlanksIsSeparatedByCommas) {
    EXPECT_EQ(first_fields("\"Time (s)\",\"x (m/s^2)\",\"y (m/s^2)\"\n", "a.csv").size(), 3U);
    EXPECT_EQ(first_fields("\"A 1\" 1,5 2,5 3,5 4,5\n", "a.csv").size(), 5U);
}

TEST(CsvTable, IsReadByTheNamesInItsHeader) {
    const CsvTable table = force_table("force,more,std,edge\n2,x,3,A\n", Header::by_name);
    EXPECT_EQ(table.text(table.rows()[0], 0), "A");
    EXPECT_EQ(table.number(table.rows()[0], 2), 3.0);
}

TEST(CsvTable, IsRefusedWithItsLine) {
    Header header = Header::optional;
    const auto read = [&](const std::string& text) {
        const CsvTable table = force_table(text, header);
        return table.number(table.rows().back(), 1);
    };
    test::expect_refused(
        "a.csv",
        {{"", ": holds no force, expected lines edge,force[,std]"},
         {"edge,force\n", ": holds no force, expected lines edge,force[,std]"},
         {"A\n", ":1: has 1 fields, expected edge,force[,std]"},
         {"A,1,2,3\n", ":1: has 4 fields, expected edge,force[,std]"},
         {"A,1,2\nB,1\n", ":2: has 2 fields, expected 3 as in the lines before"},
         {"edge,force\nedge,force\n", ":2: force is 'force', expected a finite number"},
         {"A,nan\n", ":1: force is 'nan', expected a finite number"},
         {"A,1e999\n", ":1: force is '1e999', expected a finite number"},
         {"A,\n", ":1: force is '', expected a finite number"}},
        read);
    header = Header::required;
    test::expect_refused("a.csv",
                         {{"A,1\n", ":1: does not start with the header edge,force[,std]"},
                          {"", ": does not start with the header edge,force[,std]"}},
                         read);
    header = Header::by_name;
    test::expect_refused(
        "a.csv", {{"edge,force\nA,1\n", ":1: has no column std, expected edge,force[,std]"}}, read);
}

}  // namespace
}  // namespace taut
