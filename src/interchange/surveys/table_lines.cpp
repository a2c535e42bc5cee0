// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/surveys/table_lines.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>

#include "taut/files/input_error.hpp"

namespace taut {
namespace {

bool is_separator(char c, char separator) {
    return separator == ' ' ? c == ' ' || c == '\t' : c == separator;
}

}  // namespace

std::optional<NumberField> parse_number_field(std::string_view field) {
    NumberField number;
    std::string text(field);
    if (const size_t sign = text.find_first_of(".,"); sign != std::string::npos) {
        number.decimal = text[sign];
        text[sign] = '.';
        if (text.find(',') != std::string::npos) {
            return std::nullopt;
        }
    }
    const size_t plus = text.starts_with('+') && !text.starts_with("+-") ? 1 : 0;
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = fast_float::from_chars(text.data() + plus, end, value);
    if (error == std::errc::invalid_argument || rest != end) {
        return std::nullopt;
    }
    if (error == std::errc() && std::isfinite(value)) {
        number.value = value;
    }
    return number;
}

bool says_nothing(std::string_view field) {
    return field.empty() || field == "-" || field == "--" || field == "*" || field == "?";
}

bool is_comment(std::string_view line) {
    const std::string_view text = trimmed(line);
    return text.starts_with('#') || text.starts_with("//") || text.starts_with('!') ||
           text.starts_with('%');
}

std::vector<std::string> split_fields(const TextLine& line, char separator,
                                      const std::string& file_name) {
    std::vector<std::string> fields;
    std::string_view rest = trimmed(line.text);
    // A tab may stand before the first field, which is then empty.
    if (separator == '\t') {
        rest = line.text;
    }
    const auto skip_blanks = [&] {
        while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t') &&
               (separator == ' ' || rest.front() != separator)) {
            rest.remove_prefix(1);
        }
    };
    while (!rest.empty()) {
        skip_blanks();
        std::string field;
        if (rest.starts_with('"')) {
            rest.remove_prefix(1);
            for (;;) {
                const size_t end = rest.find('"');
                if (end == std::string_view::npos) {
                    throw InputError(file_name, std::to_string(line.number),
                                     "opens a quote that is never closed");
                }
                field += rest.substr(0, end);
                rest.remove_prefix(end + 1);
                if (!rest.starts_with('"')) {
                    break;
                }
                field += '"';
                rest.remove_prefix(1);
            }
            skip_blanks();
        }
        size_t end = 0;
        while (end < rest.size() && !is_separator(rest[end], separator)) {
            ++end;
        }
        // What stands behind a closing quote, up to the separator, belongs to the field.
        field += trimmed(rest.substr(0, end));
        const bool is_last = end == rest.size();
        rest.remove_prefix(is_last ? end : end + 1);
        fields.push_back(std::move(field));
    }
    while (!fields.empty() && fields.back().empty()) {
        fields.pop_back();
    }
    return fields;
}

size_t count_numbers(const std::vector<std::string>& fields) {
    return static_cast<size_t>(std::ranges::count_if(
        fields, [](const std::string& field) { return parse_number_field(field).has_value(); }));
}

std::optional<char> detect_table_separator(const std::vector<TextLine>& lines) {
    constexpr size_t looked_at = 2000;
    constexpr size_t coordinates = 3;
    std::optional<char> best;
    size_t most = 0;
    for (const char separator : {';', '\t', ',', ' '}) {
        size_t count = 0;
        size_t seen = 0;
        for (const TextLine& line : lines) {
            if (seen == looked_at) {
                break;
            }
            if (trimmed(line.text).empty() || is_comment(line.text)) {
                continue;
            }
            ++seen;
            try {
                const auto fields = split_fields(line, separator, "");
                count += count_numbers(fields) >= coordinates ? 1 : 0;
            } catch (const InputError&) {
                continue;  // reported when the line is read
            }
        }
        if (count > most) {
            most = count;
            best = separator;
        }
    }
    return best;
}

std::string_view name_of_separator(char separator) {
    switch (separator) {
        case ';':
            return "semicolon";
        case '\t':
            return "tab";
        case ',':
            return "comma";
        default:
            return "blanks";
    }
}

}  // namespace taut
