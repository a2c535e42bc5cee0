// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/xlsx_reader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <vector>

#include "files/csv_field.hpp"
#include "files/message.hpp"
#include "files/xlsx_cells.hpp"
#include "files/xml_name.hpp"
#include "files/zip_archive.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// As of text files: files/csv_reader.cpp, interchange/surveys/foreign_survey.cpp.
constexpr size_t most_columns = 1000;
constexpr size_t largest_text = size_t{64} << 20U;
constexpr size_t most_sheets = 1000;

/// A row without its empty cells.
struct Row {
    int number = 0;
    std::vector<std::pair<int, pugi::xml_node>> cells;  ///< by column, from 1
    int numbers = 0;                                    ///< how many of them
};

/// One sheet as it stands in the file.
class Sheet {
public:
    Sheet(std::string name, const std::string& text, const std::string& part,
          const std::string& file_name, const XlsxShared& shared)
        : m_name(std::move(name)),
          m_file_name(file_name),
          m_shared(shared),
          m_xml(text, part, file_name) {
        for (const pugi::xml_node row : children_of(child_of(m_xml.root(), "sheetData"), "row")) {
            add(row);
        }
    }

    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] bool is_empty() const { return m_rows.empty(); }
    [[nodiscard]] bool has_points() const {
        constexpr int coordinates = 3;
        return std::ranges::any_of(m_rows,
                                   [](const Row& row) { return row.numbers >= coordinates; });
    }

    [[nodiscard]] std::string to_csv() const {
        refuse_merged_rows();
        std::set<int> columns;
        for (const Row& row : m_rows) {
            for (const auto& [column, cell] : row.cells) {
                columns.insert(column);
            }
        }
        if (columns.size() > most_columns) {
            fail(0, fmt::format("has more than {} columns", most_columns));
        }
        std::string text;
        int line = 1;
        for (const Row& row : m_rows) {
            text.append(static_cast<size_t>(row.number - line), '\n');
            line = row.number + 1;
            text += line_of(row, *columns.begin(), *columns.rbegin()) + '\n';
            if (text.size() > largest_text) {
                fail(row.number, fmt::format("is where the table becomes larger than {} MiB",
                                             largest_text >> 20U));
            }
        }
        return text;
    }

private:
    /// @param row 0: of the whole sheet
    [[noreturn]] void fail(int row, const std::string& what) const {
        throw InputError(m_file_name, row > 0 ? std::to_string(row) : "",
                         row > 0 ? what : fmt::format("its sheet {} {}", quote(m_name), what));
    }

    void add(pugi::xml_node node) {
        const int before = m_rows.empty() ? m_last : std::max(m_last, m_rows.back().number);
        Row row{.number = before + 1, .cells = {}};
        if (const char* const given = node.attribute("r").as_string(); *given != '\0') {
            const auto reference = parse_reference(fmt::format("A{}", given));
            if (!reference || reference->row <= before) {
                fail(before, fmt::format("is followed by row {}, expected a later one, of 1048576 "
                                         "at most",
                                         quote(given)));
            }
            row.number = reference->row;
        }
        m_last = row.number;
        int column = 0;
        for (const pugi::xml_node cell : children_of(node, "c")) {
            const char* const given = cell.attribute("r").as_string();
            const auto reference = parse_reference(
                *given == '\0' ? to_string({.column = column + 1, .row = row.number}) : given);
            if (!reference || reference->column <= column) {
                fail(row.number, fmt::format("names the cell {}, expected one behind those before",
                                             quote(given)));
            }
            column = reference->column;
            if (holds_value(cell)) {
                row.cells.emplace_back(column, cell);
                row.numbers += holds_number(cell, m_shared) ? 1 : 0;
            }
        }
        if (!row.cells.empty()) {
            m_rows.push_back(std::move(row));
        }
    }

    /// A value that stands for several rows would be missing in all but the first.
    void refuse_merged_rows() const {
        std::vector<int> numbered;
        for (const Row& row : m_rows) {
            if (row.numbers >= 2) {
                numbered.push_back(row.number);
            }
        }
        for (const pugi::xml_node merged :
             children_of(child_of(m_xml.root(), "mergeCells"), "mergeCell")) {
            const std::string_view range = merged.attribute("ref").as_string();
            const size_t colon = std::min(range.find(':'), range.size());
            const auto first = parse_reference(range.substr(0, colon));
            const auto last = parse_reference(range.substr(std::min(colon + 1, range.size())));
            if (!first || !last) {
                continue;
            }
            const auto second = std::ranges::lower_bound(numbered, first->row + 1);
            if (second != numbered.end() && *second <= last->row) {
                fail(first->row, fmt::format("begins the merged cells {}, expected a cell of its "
                                             "own in each row of the table",
                                             range));
            }
        }
    }

    [[nodiscard]] std::string text_of(const Row& row, int column, pugi::xml_node cell) const {
        std::string text;
        try {
            text = value_text(cell, m_shared);
        } catch (const std::invalid_argument& error) {
            fail(row.number,
                 fmt::format("cell {} {}", to_string({.column = column, .row = row.number}),
                             error.what()));
        }
        std::ranges::replace_if(
            text, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
        text.erase(text.find_last_not_of(' ') + 1);
        return text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
    }

    /// A row as a line of CSV with so many fields as all others. One that starts with # is a
    /// remark, as in text files.
    [[nodiscard]] std::string line_of(const Row& row, int first, int last) const {
        std::string line;
        int column = first;
        bool is_remark = false;
        for (const auto& [at, cell] : row.cells) {
            line.append(is_remark ? 1 : static_cast<size_t>(at - column), is_remark ? ' ' : ',');
            column = at;
            const std::string text = text_of(row, at, cell);
            is_remark = is_remark || (at == row.cells.front().first && text.starts_with('#'));
            line += is_remark ? text : quoted_csv_field(text);
            if (line.size() > largest_text) {
                fail(row.number, "is too long");
            }
        }
        return is_remark ? line : line.append(static_cast<size_t>(last - column), ',');
    }

    std::string m_name;
    const std::string& m_file_name;
    const XlsxShared& m_shared;
    XlsxXml m_xml;
    std::vector<Row> m_rows;  ///< those that hold something
    int m_last = 0;           ///< row
};

/// Parts that a part names: of each kind and by each id its name in the file.
struct Relations {
    std::map<std::string, std::string> by_id;
    std::map<std::string, std::string> by_kind;  ///< "styles"
};

class Workbook {
public:
    Workbook(const XlsxPart& part, const std::string& file_name)
        : m_part(part), m_file_name(file_name) {}

    [[nodiscard]] TableFile table() {
        const Relations root = relations_of("");
        const auto found = root.by_kind.find("officeDocument");
        const auto text = found == root.by_kind.end() ? std::nullopt : m_part(found->second);
        if (!text) {
            refuse_kind();
        }
        const XlsxXml workbook(*text, found->second, m_file_name);
        if (local_name(workbook.root()) != "workbook") {
            refuse_kind();
        }
        const Relations relations = relations_of(found->second);
        read_shared(workbook.root(), relations);
        return chosen(sheets_of(workbook.root(), relations));
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(m_file_name, "", what);
    }

    [[noreturn]] void refuse_kind() const {
        fail("is a ZIP archive, but no Excel file (xlsx): save the table as xlsx or CSV");
    }

    [[nodiscard]] Relations relations_of(const std::filesystem::path& of) const {
        const std::filesystem::path folder = of.parent_path();
        const std::string name =
            (folder / "_rels" / (of.filename().string() + ".rels")).generic_string();
        Relations relations;
        const auto text = m_part(name);
        if (!text) {
            return relations;
        }
        const XlsxXml xml(*text, name, m_file_name);
        for (const pugi::xml_node one : children_of(xml.root(), "Relationship")) {
            const std::string kind = one.attribute("Type").as_string();
            const std::string target = one.attribute("Target").as_string();
            // An absolute target begins at the root of the archive.
            const std::string path = target.starts_with('/')
                                         ? target.substr(1)
                                         : (folder / target).lexically_normal().generic_string();
            relations.by_id[one.attribute("Id").as_string()] = path;
            relations.by_kind[kind.substr(kind.rfind('/') + 1)] = path;
        }
        return relations;
    }

    void read_shared(pugi::xml_node workbook, const Relations& relations) {
        m_shared.starts_1904 = child_of(workbook, "workbookPr").attribute("date1904").as_bool();
        const auto root_of = [&](const char* kind, const auto& use) {
            const auto found = relations.by_kind.find(kind);
            if (found == relations.by_kind.end()) {
                return;
            }
            if (const auto text = m_part(found->second)) {
                use(XlsxXml(*text, found->second, m_file_name).root());
            }
        };
        root_of("sharedStrings", [&](auto root) { m_shared.texts = shared_texts(root); });
        root_of("styles", [&](auto root) { m_shared.is_date = date_styles(root); });
    }

    using Sheets = std::vector<std::unique_ptr<Sheet>>;

    /// Those that are shown and hold something.
    [[nodiscard]] Sheets sheets_of(pugi::xml_node workbook, const Relations& relations) const {
        Sheets sheets;
        const auto named = children_of(child_of(workbook, "sheets"), "sheet");
        if (named.size() > most_sheets) {
            fail(fmt::format("has more than {} sheets", most_sheets));
        }
        for (const pugi::xml_node one : named) {
            const std::string_view state = one.attribute("state").as_string("visible");
            const pugi::xml_attribute id = one.find_attribute([](pugi::xml_attribute attribute) {
                return std::string_view(attribute.name()).ends_with(":id");
            });
            const auto found = relations.by_id.find(id.value());
            if (state != "visible") {
                continue;
            }
            const auto text = found == relations.by_id.end() ? std::nullopt : m_part(found->second);
            const std::string name = one.attribute("name").as_string();
            if (!text) {
                fail(fmt::format("lacks its sheet {}: is the file whole?", quote(name)));
            }
            auto sheet = std::make_unique<Sheet>(name, *text, found->second, m_file_name, m_shared);
            if (!sheet->is_empty()) {
                sheets.push_back(std::move(sheet));
            }
        }
        return sheets;
    }

    [[nodiscard]] TableFile chosen(Sheets sheets) const {
        if (sheets.empty()) {
            fail("is an Excel file whose sheets are empty or hidden, expected one with a table");
        }
        if (std::ranges::any_of(sheets, &Sheet::has_points)) {
            std::erase_if(sheets, [](const auto& sheet) { return !sheet->has_points(); });
        }
        if (sheets.size() > 1) {
            std::vector<std::string> names;
            for (const auto& sheet : sheets) {
                names.push_back(quote(sheet->name()));
            }
            fail(
                fmt::format("holds tables in the sheets {}, expected one: hide the others, or save "
                            "one as CSV",
                            fmt::join(names, ", ")));
        }
        return {.text = sheets.front()->to_csv(), .sheet = sheets.front()->name()};
    }

    const XlsxPart& m_part;
    const std::string& m_file_name;
    XlsxShared m_shared;
};

}  // namespace

TableFile read_xlsx(const XlsxPart& part, const std::string& file_name) {
    return Workbook(part, file_name).table();
}

TableFile read_xlsx(std::string_view bytes, const std::string& file_name) {
    ZipArchive archive(bytes, file_name);
    return read_xlsx([&](const std::string& name) { return archive.part(name); }, file_name);
}

}  // namespace taut
