// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/xlsx_reader.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "files/message.hpp"
#include "files/xlsx_cells.hpp"
#include "files/xlsx_sheet.hpp"
#include "files/xml_name.hpp"
#include "files/zip_archive.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr size_t most_sheets = 1000;

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

    using Sheets = std::vector<std::unique_ptr<SheetReader>>;

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
            auto sheet =
                std::make_unique<SheetReader>(name, *text, found->second, m_file_name, m_shared);
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
        if (std::ranges::any_of(sheets, &SheetReader::has_points)) {
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
