// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "files/xlsx_cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iterator>
#include <map>
#include <stdexcept>

#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/xml_name.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

std::optional<size_t> parse_index(std::string_view text) {
    size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                    : std::nullopt;
}

/// All text of a node: pugixml's text() ends at the first comment.
std::string own_text(pugi::xml_node node) {
    std::string text;
    for (const pugi::xml_node part : node.children()) {
        text += part.value();  // of an element: nothing
    }
    return text;
}

/// A text, which may stand in runs of different fonts; without how it is pronounced.
std::string rich_text(pugi::xml_node node) {
    std::string text;
    for (const pugi::xml_node part : node.children()) {
        if (local_name(part) == "t") {
            text += own_text(part);
        } else if (local_name(part) == "r") {
            text += own_text(child_of(part, "t"));
        }
    }
    return text;
}

/// Of the formats that have no code in the file.
bool is_builtin_date(unsigned format) {
    return (format >= 14 && format <= 22) || (format >= 27 && format <= 36) ||
           (format >= 45 && format <= 47) || (format >= 50 && format <= 58);
}

/// Whether years to seconds stand in the code of a format, outside quotes and brackets.
bool is_date_code(std::string_view code) {
    for (size_t i = 0; i < code.size() && code[i] != ';'; ++i) {
        const char c = code[i];
        if (c == '"' || c == '[') {
            i = std::min(code.find(c == '"' ? '"' : ']', i + 1), code.size());
        } else if (c == '\\' || c == '_' || c == '*') {
            ++i;
        } else if (std::string_view("yYmMdDhHsS").find(c) != std::string_view::npos) {
            return true;
        }
    }
    return false;
}

std::string_view type_of(pugi::xml_node cell) {
    return cell.attribute("t").as_string("n");
}

bool is_date(pugi::xml_node cell, const XlsxShared& shared) {
    const auto style = parse_index(cell.attribute("s").as_string("0"));
    return style && *style < shared.is_date.size() && shared.is_date[*style];
}

/// @param serial days since 1899-12-30, or since 1904-01-01
std::string date_text(double serial, bool starts_1904) {
    using namespace std::chrono;
    constexpr double last = 2'958'465.0;  // 9999-12-31
    if (!(serial >= 0.0 && serial <= last)) {
        return fmt::format("date {}", serial);
    }
    const auto day = static_cast<int>(serial);
    if (day == 0 && !starts_1904) {
        const auto minutes = static_cast<int>(serial * 24.0 * 60.0);
        return fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
    }
    const sys_days start =
        starts_1904 ? sys_days(year(1904) / 1 / 1) : sys_days(year(1899) / 12 / 30);
    const year_month_day date(start + days(day));
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

/// The text of a cell of text; nothing for other cells.
std::optional<std::string> text_of(pugi::xml_node cell, const XlsxShared& shared) {
    const std::string_view type = type_of(cell);
    const std::string value = own_text(child_of(cell, "v"));
    if (type == "s") {
        const auto index = parse_index(value);
        if (!index || *index >= shared.texts.size()) {
            throw std::invalid_argument(
                fmt::format("names the shared text {}, of which there are {}", quote(value),
                            shared.texts.size()));
        }
        return shared.texts[*index];
    }
    if (type == "inlineStr") {
        return rich_text(child_of(cell, "is"));
    }
    return type == "str" || type == "d" ? std::optional<std::string>(value) : std::nullopt;
}

}  // namespace

XlsxXml::XlsxXml(const std::string& text, const std::string& part, const std::string& file_name) {
    const pugi::xml_parse_result result = m_document.load_buffer(text.data(), text.size());
    if (!result) {
        throw InputError(file_name, "",
                         fmt::format("its part {} is no XML: {}", part, result.description()));
    }
}

pugi::xml_node child_of(pugi::xml_node node, std::string_view name) {
    return node.find_child([&](pugi::xml_node child) { return local_name(child) == name; });
}

std::vector<pugi::xml_node> children_of(pugi::xml_node node, std::string_view name) {
    std::vector<pugi::xml_node> found;
    std::ranges::copy_if(node.children(), std::back_inserter(found),
                         [&](pugi::xml_node child) { return local_name(child) == name; });
    return found;
}

std::vector<std::string> shared_texts(pugi::xml_node root) {
    std::vector<std::string> texts;
    for (const pugi::xml_node item : children_of(root, "si")) {
        texts.push_back(rich_text(item));
    }
    return texts;
}

std::vector<bool> date_styles(pugi::xml_node root) {
    std::map<unsigned, bool> is_date;
    for (const pugi::xml_node format : children_of(child_of(root, "numFmts"), "numFmt")) {
        is_date[format.attribute("numFmtId").as_uint()] =
            is_date_code(format.attribute("formatCode").as_string());
    }
    std::vector<bool> styles;
    for (const pugi::xml_node style : children_of(child_of(root, "cellXfs"), "xf")) {
        const unsigned format = style.attribute("numFmtId").as_uint();
        const auto found = is_date.find(format);
        styles.push_back(found != is_date.end() ? found->second : is_builtin_date(format));
    }
    return styles;
}

std::optional<XlsxReference> parse_reference(std::string_view text) {
    constexpr int most_columns = 16'384;
    constexpr int most_rows = 1'048'576;
    XlsxReference cell;
    while (!text.empty() && text[0] >= 'A' && text[0] <= 'Z' && cell.column <= most_columns) {
        cell.column = 26 * cell.column + (text[0] - 'A' + 1);
        text.remove_prefix(1);
    }
    const auto row = parse_index(text);
    if (cell.column < 1 || cell.column > most_columns || !row || *row < 1 || *row > most_rows) {
        return std::nullopt;
    }
    cell.row = static_cast<int>(*row);
    return cell;
}

std::string to_string(XlsxReference cell) {
    std::string text;
    for (int rest = cell.column; rest > 0; rest = (rest - 1) / 26) {
        text.insert(text.begin(), static_cast<char>('A' + (rest - 1) % 26));
    }
    return text + std::to_string(cell.row);
}

bool holds_value(pugi::xml_node cell) {
    return child_of(cell, "f") || !own_text(child_of(cell, "v")).empty() ||
           (type_of(cell) == "inlineStr" && !rich_text(child_of(cell, "is")).empty());
}

bool holds_number(pugi::xml_node cell, const XlsxShared& shared) {
    if (type_of(cell) == "n") {
        return !is_date(cell, shared) && parse_number(own_text(child_of(cell, "v"))).has_value();
    }
    try {
        constexpr size_t longest_number = 1000;
        std::string text = text_of(cell, shared).value_or("");
        if (text.size() > longest_number) {
            return false;
        }
        std::ranges::replace(text, ',', '.');
        return parse_number(text).has_value();
    } catch (const std::invalid_argument&) {
        return false;  // refused where the cell is read
    }
}

std::string value_text(pugi::xml_node cell, const XlsxShared& shared) {
    const std::string_view type = type_of(cell);
    const std::string value = own_text(child_of(cell, "v"));
    if (type == "e") {
        throw std::invalid_argument(
            fmt::format("holds the error {}, expected a value or nothing", quote(value)));
    }
    if (child_of(cell, "f") && value.empty() && type != "str") {
        throw std::invalid_argument(
            "holds a formula that was never computed: open the file in a spreadsheet program and "
            "save it");
    }
    if (const auto text = text_of(cell, shared)) {
        return *text;
    }
    if (type == "b") {
        return value == "1" ? "TRUE" : "FALSE";
    }
    if (value.empty()) {
        return {};
    }
    const auto number = parse_number(value);
    if (type != "n" || !number) {
        throw std::invalid_argument(fmt::format("is {}, expected a finite number", quote(value)));
    }
    return is_date(cell, shared) ? date_text(*number, shared.starts_1904)
                                 : fmt::format("{}", *number);
}

}  // namespace taut
