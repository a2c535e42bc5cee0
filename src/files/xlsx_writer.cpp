// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/xlsx_writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "files/xlsx_cells.hpp"
#include "files/zip_archive.hpp"
#include "taut/files/printable.hpp"

namespace taut {
namespace {

constexpr const char* main_space = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
constexpr const char* relations_space =
    "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
constexpr const char* content_type = "application/vnd.openxmlformats-officedocument.spreadsheetml.";

/// Styles of cells: indices into the cellXfs below.
enum class Style : unsigned { plain, title, remark, first_number };
constexpr auto first_number = static_cast<unsigned>(Style::first_number);
constexpr unsigned most_decimals = 5;

constexpr const char* xml_head = R"(<?xml version="1.0" encoding="UTF-8" standalone="yes"?>)"
                                 "\n";

/// Bold and a line below for titles, bold and red for remarks, and numbers of 0 to 5 decimals.
std::string styles() {
    std::string formats;
    std::string numbers;
    for (unsigned decimals = 0; decimals <= most_decimals; ++decimals) {
        const unsigned id = 164 + decimals;  // the first that is not Excel's own
        const std::string code =
            decimals == 0 ? "0" : fmt::format("0.{}", std::string(decimals, '0'));
        formats += fmt::format(R"(<numFmt numFmtId="{}" formatCode="{}"/>)", id, code);
        numbers += fmt::format(
            R"(<xf numFmtId="{}" fontId="0" fillId="0" borderId="0" xfId="0" applyNumberFormat="1"/>)",
            id);
    }
    const auto font = [](const char* start, const char* colour) {
        return fmt::format(
            R"(<font>{}<sz val="11"/>{}<name val="Calibri"/><family val="2"/></font>)", start,
            colour);
    };
    const std::string side = "<left/><right/><top/>";
    return xml_head +
           fmt::format(
               R"(<styleSheet xmlns="{}"><numFmts count="{}">{}</numFmts><fonts count="3">{}{}{}</fonts>)"
               R"(<fills count="2"><fill><patternFill patternType="none"/></fill>)"
               R"(<fill><patternFill patternType="gray125"/></fill></fills>)"
               R"(<borders count="2"><border>{}<bottom/><diagonal/></border>)"
               R"(<border>{}<bottom style="thin"><color auto="1"/></bottom><diagonal/></border></borders>)"
               R"(<cellStyleXfs count="1"><xf numFmtId="0" fontId="0" fillId="0" borderId="0"/></cellStyleXfs>)"
               R"(<cellXfs count="{}"><xf numFmtId="0" fontId="0" fillId="0" borderId="0" xfId="0"/>)"
               R"(<xf numFmtId="0" fontId="1" fillId="0" borderId="1" xfId="0" applyFont="1" applyBorder="1"/>)"
               R"(<xf numFmtId="0" fontId="2" fillId="0" borderId="0" xfId="0" applyFont="1"/>{}</cellXfs>)"
               R"(<cellStyles count="1"><cellStyle name="Normal" xfId="0" builtinId="0"/></cellStyles></styleSheet>)",
               main_space, most_decimals + 1, formats, font("", ""), font("<b/>", ""),
               font("<b/>", R"(<color rgb="FFFF0000"/>)"), side, side,
               first_number + most_decimals + 1, numbers);
}

void set_attributes(pugi::xml_node node,
                    std::initializer_list<std::pair<const char*, std::string>> values) {
    for (const auto& [name, value] : values) {
        node.append_attribute(name) = value.c_str();
    }
}

void add_text(pugi::xml_node row, XlsxReference place, Style style, const std::string& text) {
    constexpr size_t most = 32'767;
    std::string shown = printable(text);
    if (shown.size() > most) {
        throw std::invalid_argument(fmt::format(
            "a text for an Excel file has {} bytes, expected at most {}", shown.size(), most));
    }
    pugi::xml_node cell = row.append_child("c");
    set_attributes(cell, {{"r", to_string(place)},
                          {"s", std::to_string(static_cast<unsigned>(style))},
                          {"t", "inlineStr"}});
    pugi::xml_node content = cell.append_child("is").append_child("t");
    content.append_attribute("xml:space") = "preserve";
    content.text() = shown.c_str();
}

void add_number(pugi::xml_node row, XlsxReference place, int decimals, double number) {
    pugi::xml_node cell = row.append_child("c");
    const unsigned shown = std::min(static_cast<unsigned>(decimals), most_decimals);
    set_attributes(cell, {{"r", to_string(place)}, {"s", std::to_string(first_number + shown)}});
    cell.append_child("v").text() = fmt::format("{}", number).c_str();
}

pugi::xml_node add_row(pugi::xml_node data, int row) {
    pugi::xml_node node = data.append_child("row");
    node.append_attribute("r") = row;
    return node;
}

/// What stands before the cells: one page wide, the titles in sight, columns as wide as their
/// titles.
void add_view(pugi::xml_node page, const XlsxSheet& sheet, int titles, bool is_first) {
    page.append_child("sheetPr").append_child("pageSetUpPr").append_attribute("fitToPage") = 1;
    pugi::xml_node view = page.append_child("sheetViews").append_child("sheetView");
    if (is_first) {
        view.append_attribute("tabSelected") = 1;
    }
    view.append_attribute("workbookViewId") = 0;
    set_attributes(view.append_child("pane"), {{"ySplit", std::to_string(titles)},
                                               {"topLeftCell", fmt::format("A{}", titles + 1)},
                                               {"activePane", "bottomLeft"},
                                               {"state", "frozen"}});
    page.append_child("sheetFormatPr").append_attribute("defaultRowHeight") = 15;
    pugi::xml_node columns = page.append_child("cols");
    int number = 0;
    for (const XlsxColumn& column : sheet.columns) {
        constexpr size_t narrowest = 9;  // in letters
        constexpr size_t margin = 2;
        const std::string at = std::to_string(++number);
        set_attributes(
            columns.append_child("col"),
            {{"min", at},
             {"max", at},
             {"width", std::to_string(std::max(narrowest, column.title.size() + margin))},
             {"customWidth", "1"}});
    }
}

std::string sheet_xml(const XlsxSheet& sheet, bool is_first) {
    pugi::xml_document document;
    pugi::xml_node page = document.append_child("worksheet");
    page.append_attribute("xmlns") = main_space;
    int row = static_cast<int>(sheet.remarks.size()) + 1;
    add_view(page, sheet, row, is_first);
    pugi::xml_node data = page.append_child("sheetData");
    for (int k = 0; k + 1 < row; ++k) {
        add_text(add_row(data, k + 1), {.column = 1, .row = k + 1}, Style::remark,
                 "# " + sheet.remarks[static_cast<size_t>(k)]);
    }
    pugi::xml_node titles = add_row(data, row);
    for (size_t k = 0; k < sheet.columns.size(); ++k) {
        add_text(titles, {.column = static_cast<int>(k) + 1, .row = row}, Style::title,
                 sheet.columns[k].title);
    }
    for (const std::vector<XlsxCell>& cells : sheet.rows) {
        pugi::xml_node line = add_row(data, ++row);
        for (size_t k = 0; k < cells.size(); ++k) {
            const XlsxReference place{.column = static_cast<int>(k) + 1, .row = row};
            if (const auto* const number = std::get_if<double>(&cells[k]);
                number != nullptr && std::isfinite(*number)) {
                add_number(line, place, sheet.columns[k].decimals, *number);
            } else if (const auto* const text = std::get_if<std::string>(&cells[k]);
                       text != nullptr && !text->empty()) {
                add_text(line, place, Style::plain, *text);
            }
        }
    }
    set_attributes(page.append_child("pageMargins"), {{"left", "0.7"},
                                                      {"right", "0.7"},
                                                      {"top", "0.75"},
                                                      {"bottom", "0.75"},
                                                      {"header", "0.3"},
                                                      {"footer", "0.3"}});
    set_attributes(page.append_child("pageSetup"), {{"paperSize", "9"},  // A4
                                                    {"orientation", "landscape"},
                                                    {"fitToHeight", "0"}});
    std::ostringstream text;
    document.save(text, "", pugi::format_raw | pugi::format_no_declaration);
    return xml_head + text.str();
}

std::string relation(int id, const char* kind, const std::string& target) {
    return fmt::format(R"(<Relationship Id="rId{}" Type="{}/{}" Target="{}"/>)", id,
                       relations_space, kind, target);
}

std::string relations_xml(const std::string& all) {
    return std::string(xml_head) +
           R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">)" +
           all + "</Relationships>";
}

std::string override_xml(const std::string& part, const char* kind) {
    return fmt::format(R"(<Override PartName="/xl/{}" ContentType="{}{}+xml"/>)", part,
                       content_type, kind);
}

}  // namespace

std::string xlsx_bytes(const std::vector<XlsxSheet>& sheets) {
    std::vector<std::pair<std::string, std::string>> parts;
    std::string types = override_xml("workbook.xml", "sheet.main");
    std::string names;
    std::string titles;
    std::string related;
    int number = 0;
    for (const XlsxSheet& sheet : sheets) {
        const std::string part = fmt::format("worksheets/sheet{}.xml", ++number);
        const size_t row = sheet.remarks.size() + 1;
        types += override_xml(part, "worksheet");
        related += relation(number, "worksheet", part);
        names += fmt::format(R"(<sheet name="{}" sheetId="{}" r:id="rId{}"/>)", sheet.name, number,
                             number);
        titles += fmt::format(
            R"(<definedName name="_xlnm.Print_Titles" localSheetId="{}">{}!${}:${}</definedName>)",
            number - 1, sheet.name, row, row);
        parts.emplace_back("xl/" + part, sheet_xml(sheet, number == 1));
    }
    types += override_xml("styles.xml", "styles");
    related += relation(number + 1, "styles", "styles.xml");
    parts.emplace_back("xl/styles.xml", styles());
    parts.emplace_back("xl/_rels/workbook.xml.rels", relations_xml(related));
    parts.emplace_back(
        "xl/workbook.xml",
        xml_head + fmt::format(
                       R"(<workbook xmlns="{}" xmlns:r="{}"><bookViews><workbookView/></bookViews>)"
                       R"(<sheets>{}</sheets><definedNames>{}</definedNames></workbook>)",
                       main_space, relations_space, names, titles));
    parts.emplace_back("_rels/.rels",
                       relations_xml(relation(1, "officeDocument", "xl/workbook.xml")));
    const std::string start =
        R"(<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">)"
        R"(<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>)"
        R"(<Default Extension="xml" ContentType="application/xml"/>)";
    parts.emplace_back("[Content_Types].xml", xml_head + start + types + "</Types>");
    std::ranges::reverse(parts);  // the list of types first, as everywhere
    return zip_bytes(parts);
}

}  // namespace taut
