// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a cell that is taken for another or left out without a word, a row that is called
// by another number, and an Excel file that hangs or fills the reader.

#include <gmock/gmock.h>

#include <map>

#include "files/xlsx_reader.hpp"
#include "files/xlsx_writer.hpp"
#include "files/zip_archive.hpp"
#include "support/bad_input.hpp"
#include "support/errors.hpp"
#include "support/scratch.hpp"
#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

template <class Action>
void expect_refused(const Action& action, const std::string& message) {
    EXPECT_THAT(test::input_error_of(action), testing::HasSubstr(message));
}

using Parts = std::map<std::string, std::string>;

/// The parts of a workbook of sheets (attributes, content).
Parts workbook(const std::vector<std::pair<std::string, std::string>>& sheets) {
    constexpr auto type = "http://schemas.openxmlformats.org/officeDocument/2006/relationships/";
    Parts parts;
    std::string list;
    std::string relations;
    const auto relate = [&](const std::string& id, const std::string& kind, const std::string& to) {
        relations +=
            "<Relationship Id='" + id + "' Type='" + type + kind + "' Target='" + to + "'/>";
    };
    for (const auto& [attributes, content] : sheets) {
        const std::string number = std::to_string(parts.size());
        list += "<sheet r:id='r" + number + "' " + attributes + "/>";
        relate("r" + number, "worksheet", "sheets/" + number + ".xml");
        parts["xl/sheets/" + number + ".xml"] = "<worksheet>" + content + "</worksheet>";
    }
    relate("t", "sharedStrings", "/xl/texts.xml");
    relate("s", "styles", "styles.xml");
    parts["xl/_rels/book.xml.rels"] = "<Relationships>" + relations + "</Relationships>";
    relations.clear();
    relate("r", "officeDocument", "xl/book.xml");
    parts["_rels/.rels"] = "<Relationships>" + relations + "</Relationships>";
    parts["xl/book.xml"] = "<workbook><sheets>" + list + "</sheets></workbook>";
    parts["xl/texts.xml"] =
        "<sst><si><t>P1</t></si><si><r><t>East</t></r><r><t>&#10;[mm]</t></r><rPh><t>x</t></rPh></"
        "si>"
        "</sst>";
    parts["xl/styles.xml"] =
        "<styleSheet><numFmts><numFmt numFmtId='170' formatCode='dd.mm.yyyy'/>"
        "<numFmt numFmtId='171' formatCode='0.0&quot; mm&quot;;[Red]-0.0'/></numFmts><cellXfs>"
        "<xf numFmtId='0'/><xf numFmtId='14'/><xf numFmtId='170'/><xf numFmtId='171'/></cellXfs>"
        "</styleSheet>";
    return parts;
}

Parts one_sheet(const std::string& rows, const std::string& behind = "") {
    return workbook({{"name='Ist'", "<sheetData>" + rows + "</sheetData>" + behind}});
}

TableFile table(const Parts& parts) {
    return read_xlsx(
        [&](const std::string& name) {
            const auto found = parts.find(name);
            return found == parts.end() ? std::nullopt : std::optional(found->second);
        },
        "a.xlsx");
}

const std::string points =
    "<row r='3'><c r='B3' t='s'><v>0</v></c><c r='C3'><v>0.30000000000000004</v></c>"
    "<c r='D3'><v>1E-3</v></c><c r='E3'><f>C3*2</f><v>12</v></c></row>";

TEST(Xlsx, IsTheTextOfItsSheetWithEachRowOnItsLine) {
    const TableFile read = table(one_sheet(
        "<row r='1'><c r='B1' t='inlineStr'><is><t xml:space='preserve'> a, \"b\" </t></is></c>"
        "<c r='C1' t='s'><v>1</v></c></row>" +
        points +
        "<row><c t='str'><v> </v></c></row><row><c t='str'><v># "
        "last</v></c><c><v>7</v></c></row>"));
    EXPECT_EQ(read.sheet, "Ist");
    EXPECT_EQ(
        read.text,
        ",\"a, \"\"b\"\"\",\"East [mm]\",,\n\n,P1,0.30000000000000004,0.001,12\n\n# last 7\n");
}

TEST(Xlsx, HasValuesWholeAndNamesThatBeginLikeRemarks) {
    EXPECT_EQ(table(one_sheet("<row><c t='str'><v>#a</v></c><c><v>1<!-- x -->2</v></c>"
                              "<c><v>2</v></c><c><v><![CDATA[3]]></v></c></row>"
                              "<row><c t='str'><v># b</v></c><c><v>7</v></c></row>"))
                  .text,
              "\"#a\",12,2,3\n# b 7\n");
}

TEST(Xlsx, TakesDatesForTextAndFormatsForNothing) {
    EXPECT_EQ(table(one_sheet("<row r='1'><c r='A1' s='1'><v>46145.75</v></c>"
                              "<c r='B1' s='2'><v>46145</v></c><c r='C1' s='3'><v>1.2345</v></c>"
                              "<c r='D1' t='b'><v>1</v></c><c r='E1' s='1'><v>0.5</v></c>"
                              "<c r='F1' t='d'><v>2026-05-03</v></c></row>"))
                  .text,
              "2026-05-03,2026-05-03,1.2345,TRUE,12:00,2026-05-03\n");
    Parts mac = one_sheet("<row><c s='1'><v>1</v></c><c><v>2</v></c></row>");
    mac["xl/book.xml"].insert(10, "<workbookPr date1904='1'/>");
    EXPECT_EQ(table(mac).text, "1904-01-02,2\n");
}

TEST(Xlsx, IsTheOneSheetThatIsShownAndHasPoints) {
    const std::string cover = "<sheetData><row><c><v>1</v></c><c><v>2</v></c></row></sheetData>";
    const std::string sheet = "<sheetData>" + points + "</sheetData>";
    EXPECT_EQ(table(workbook({{"name='cover'", cover},
                              {"name='old' state='hidden'", sheet},
                              {"name='chart'", ""},
                              {"name='new'", sheet}}))
                  .sheet,
              "new");
    EXPECT_EQ(table(workbook({{"name='list'", cover}, {"name='empty'", "<sheetData/>"}})).sheet,
              "list");
}

TEST(Xlsx, LeavesMergedTitlesAlone) {
    EXPECT_EQ(table(one_sheet("<row><c t='s'><v>0</v></c></row>" + points,
                              "<mergeCells><mergeCell ref='A1:E2'/></mergeCells>"))
                  .text,
              "P1,,,,\n\n,P1,0.30000000000000004,0.001,12\n");
}

TEST(Xlsx, IsRefusedWithItsRow) {
    test::expect_refused(
        "",
        {{"", "a.xlsx: is an Excel file whose sheets are empty or hidden..."},
         {"<row r='4'><c r='D4' t='e'><v>#REF!</v></c></row>",
          "a.xlsx:4: cell D4 holds the error '#REF!'..."},
         {"<row r='4'><c r='D4'><f>A1</f></c></row>",
          "a.xlsx:4: cell D4 holds a formula that was never computed..."},
         {"<row><c t='s'><v>2</v></c></row>",
          "a.xlsx:1: cell A1 names the shared text '2', of which there are 2..."},
         {"<row><c t='s'><v>-1</v></c></row>", "a.xlsx:1: cell A1 names the shared text '-1'..."},
         {"<row><c><v>1,5</v></c></row>", "a.xlsx:1: cell A1 is '1,5'..."},
         {"<row><c><v>1e999</v></c></row>", "a.xlsx:1: cell A1 is '1e999'..."},
         {"<row><c><v>&x;</v></c></row>", "a.xlsx:1: cell A1 is '&x;'..."},
         {"<row><c t='q'><v>1</v></c></row>", "a.xlsx:1: cell A1 is '1'..."},
         {"<row r='4'/><row r='4'/>", "a.xlsx:4: is followed by row '4'..."},
         {"<row r='1048577'/>", "a.xlsx: its sheet 'Ist' is followed by row '1048577'..."},
         {"<row><c r='B1'><v>1</v></c><c r='B1'><v>2</v></c></row>",
          "a.xlsx:1: names the cell 'B1'..."},
         {"<row><c r='XFE1'><v>1</v></c></row>", "a.xlsx:1: names the cell 'XFE1'..."},
         {"<row><c r='B'><v>1</v></c></row>", "a.xlsx:1: names the cell 'B'..."},
         {"<row>", "a.xlsx: its part xl/sheets/0.xml is no XML..."}},
        [](const std::string& text) { return table(one_sheet(text)); });
}

TEST(Xlsx, IsRefusedWhereItsPartsDoNotFit) {
    const auto refused = [](const Parts& parts, const std::string& message) {
        expect_refused([&] { return table(parts); }, message);
    };
    const std::string sheet = "<sheetData>" + points + "</sheetData>";
    refused(workbook({{"name='a'", sheet}, {"name='b'", sheet}}),
            "a.xlsx: holds tables in the sheets 'a', 'b', expected one: hide the others");
    refused(one_sheet(points + "<row r='4'><c r='C4'><v>1</v></c><c r='D4'><v>1</v></c></row>",
                      "<mergeCells><mergeCell ref='B3:B4'/></mergeCells>"),
            "a.xlsx:3: begins the merged cells B3:B4");
    refused({}, "a.xlsx: is a ZIP archive, but no Excel file");
    Parts parts = one_sheet(points);
    parts.erase("xl/sheets/0.xml");
    refused(parts, "a.xlsx: lacks its sheet 'Ist'");
}

std::string zipped(const Parts& parts) {
    return zip_bytes({parts.begin(), parts.end()});
}

TEST(Xlsx, IsRefusedWhereItsArchiveIsDamagedEncryptedOrTooLarge) {
    const std::string whole = zipped(one_sheet(points));
    EXPECT_EQ(read_xlsx(whole, "a.xlsx").sheet, "Ist");
    const auto refused = [](const std::string& bytes, const std::string& message) {
        expect_refused([&] { return read_xlsx(bytes, "a.xlsx"); }, message);
    };
    refused(whole.substr(0, whole.size() - 30),
            "a.xlsx: is a ZIP archive, as xlsx files are, that");
    std::string encrypted = whole;
    for (size_t at = 0; (at = encrypted.find("PK\x01\x02", at)) != std::string::npos; ++at) {
        encrypted[at + 8] = 1;
    }
    refused(encrypted, "a.xlsx: is encrypted");
    std::string damaged = whole;
    damaged[damaged.find("_rels/.rels") + 30] ^= 0x55;
    refused(damaged, "a.xlsx: its part _rels/.rels is damaged");
    Parts bomb = one_sheet(points);
    bomb["xl/texts.xml"] = "<sst>" + std::string(size_t{33} << 20U, ' ') + "</sst>";
    refused(zipped(bomb), "a.xlsx: is larger than 32 MiB when unpacked");
    // Each of many cells is the same long text.
    Parts repeated = one_sheet([] {
        std::string rows;
        for (int i = 0; i < 70; ++i) {
            rows += "<row><c t='s'><v>0</v></c></row>";
        }
        return rows;
    }());
    repeated["xl/texts.xml"] =
        "<sst><si><t>" + std::string(size_t{1} << 20U, 'a') + "</t></si></sst>";
    expect_refused([&] { return table(repeated); },
                   "is where the table becomes larger than 64 MiB");
}

TEST(Xlsx, IsReadFromAFileAsTextFilesAre) {
    const test::ScratchDirectory folder;
    const auto write = [&](const std::string& name, const std::string& content) {
        write_file(folder / name, content);
        return folder / name;
    };
    EXPECT_EQ(read_table(write("a.csv", "a,1\n")), "a,1\n");
    EXPECT_EQ(read_table_file(write("b.xlsx", "a,1\n")).sheet, "");
    EXPECT_EQ(read_table_file(write("c.csv", zipped(one_sheet(points)))).sheet, "Ist");
    expect_refused([&] { return read_table(write("d.xlsx", "\xD0\xCF\x11\xE0")); },
                   "d.xlsx: is an old Office file (xls), or encrypted");
    const std::filesystem::path data = std::filesystem::path(TAUT_TEST_DATA_DIR) / "surveys";
    const TableFile read = read_table_file(data / "excel.xlsx");
    EXPECT_EQ(read.sheet, "Aufmaß & Lage");
    EXPECT_EQ(read.text, read_file(data / "excel.txt"));
}

TEST(Xlsx, ReadsWhatItWrites) {
    const std::string id = "=1+1, \"2\"";
    const TableFile read =
        read_xlsx(xlsx_bytes({{.name = "turns",
                               .remarks = {"DO NOT TURN", "because"},
                               .columns = {{"edge"}, {"stroke_mm", 3}, {"kind"}},
                               .rows = {{12.0, 0.1 + 0.2, {}}, {id, -2.0, "a"}}}}),
                  "a.xlsx");
    EXPECT_EQ(read.sheet, "turns");
    EXPECT_EQ(read.text,
              "# DO NOT TURN\n# because\nedge,stroke_mm,kind\n12,0.30000000000000004,\n"
              "\"=1+1, \"\"2\"\"\",-2,a\n");
}

}  // namespace
}  // namespace taut
