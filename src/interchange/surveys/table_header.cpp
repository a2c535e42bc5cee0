// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/surveys/table_header.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "files/message.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr std::string_view columns_hint = "give the columns, as id,y,x,z,-";

/// Finds the head of a table, step by step.
class HeadFinder {
public:
    HeadFinder(const std::vector<TextLine>& lines, char separator, const std::string& file_name)
        : m_lines(lines), m_separator(separator), m_file_name(file_name) {}

    [[nodiscard]] TableHead find(const SurveyFileOptions& options, bool is_cloud) && {
        find_first_point();
        find_header();
        if (!options.columns.empty()) {
            m_head.layout = layout_of_names(options.columns);
        } else if (m_head.header) {
            m_head.layout = layout_of_titles();
        } else {
            m_head.layout = layout_of_fields(is_cloud);
        }
        if (!m_head.titles.empty()) {
            units_of(m_head.titles, *m_head.header, false);
        }
        look_for_units();
        return std::move(m_head);
    }

private:
    [[noreturn]] void fail(size_t index, const std::string& what) const {
        throw InputError(m_file_name, std::to_string(m_lines[index].number), what);
    }

    [[nodiscard]] std::vector<std::string> fields(size_t index) const {
        return split_fields(m_lines[index], m_separator, m_file_name);
    }

    [[nodiscard]] bool is_content(size_t index) const {
        return !trimmed(m_lines[index].text).empty() && !is_comment(m_lines[index].text);
    }

    void find_first_point() {
        constexpr size_t coordinates = 3;
        for (size_t i = 0; i < m_lines.size(); ++i) {
            if (is_content(i) && count_numbers(fields(i)) >= coordinates) {
                m_head.first = i;
                return;
            }
        }
        throw InputError(m_file_name, "", "holds no line with the three coordinates of a point");
    }

    /// The columns that a line names; a comment may name them, too.
    [[nodiscard]] std::vector<std::string> titles_in(size_t index) const {
        TextLine line = m_lines[index];
        if (is_comment(line.text)) {
            const std::string_view text = trimmed(line.text);
            line.text = text.substr(std::min(text.find_first_not_of("#/!% \t"), text.size()));
        }
        try {
            return split_fields(line, m_separator, m_file_name);
        } catch (const InputError&) {
            return {};  // a quote in a text before the points
        }
    }

    /// The last line before the points that names all coordinates; else the last that could.
    void find_header() {
        std::optional<size_t> like;
        for (size_t i = m_head.first; i-- > 0;) {
            std::vector<std::string> titles = titles_in(i);
            size_t known = 0;
            bool places[3] = {false, false, false};
            for (const std::string& field : titles) {
                const auto column = parse_column_title(field).column;
                known += column ? 1 : 0;
                for (int k = 0; k < 3; ++k) {
                    places[k] = places[k] || column == static_cast<TableColumn>(
                                                           static_cast<int>(TableColumn::x) + k);
                }
            }
            if (places[0] && places[1] && places[2]) {
                m_head.header = i;
                m_head.titles = std::move(titles);
                return;
            }
            const bool names_some = known >= 2 && (places[0] || places[1] || places[2]);
            if (is_content(i) && !like && names_some) {
                like = i;
            }
            if (is_content(i) && m_last_text.empty() && titles.size() > 2 &&
                titles.size() == fields(m_head.first).size()) {
                m_last_text = m_lines[i].text;
            }
        }
        if (like) {
            m_head.header = like;
            m_head.titles = titles_in(*like);
        }
    }

    [[nodiscard]] TableLayout layout_of_titles() const {
        TableLayout layout{.count = m_head.titles.size()};
        std::optional<size_t> found[table_column_count];
        for (size_t i = 0; i < m_head.titles.size(); ++i) {
            const auto column = parse_column_title(m_head.titles[i]).column;
            if (!column) {
                continue;
            }
            std::optional<size_t>& at = found[static_cast<int>(*column)];
            const bool is_place = *column != TableColumn::id && *column != TableColumn::code &&
                                  *column != TableColumn::running_number;
            if (at && is_place) {
                fail(*m_head.header,
                     fmt::format("names a coordinate twice, {} and {}: {}",
                                 quote(m_head.titles[*at]), quote(m_head.titles[i]), columns_hint));
            }
            at = at ? at : i;
        }
        const auto at = [&](TableColumn column) { return found[static_cast<int>(column)]; };
        layout.id = at(TableColumn::id) ? at(TableColumn::id) : at(TableColumn::running_number);
        layout.code = at(TableColumn::code);
        for (int k = 0; k < 3; ++k) {
            const auto place = found[static_cast<int>(TableColumn::x) + k];
            if (!place) {
                fail(*m_head.header,
                     fmt::format("names no column for {}: {}", "xyz"[k], columns_hint));
            }
            layout.place[k] = *place;
        }
        if (at(TableColumn::sx) && at(TableColumn::sy) && at(TableColumn::sz)) {
            layout.spread = {*at(TableColumn::sx), *at(TableColumn::sy), *at(TableColumn::sz)};
        }
        return layout;
    }

    /// What the fields of the first lines are: numbers, whole numbers, none of them negative.
    struct ColumnContent {
        bool is_number = true;
        bool is_whole = true;
        bool is_positive = true;
    };

    [[nodiscard]] std::vector<ColumnContent> contents() const {
        constexpr size_t looked_at = 1000;
        std::vector<ColumnContent> result(fields(m_head.first).size());
        for (size_t i = m_head.first, seen = 0; i < m_lines.size() && seen < looked_at; ++i) {
            if (!is_content(i)) {
                continue;
            }
            ++seen;
            const std::vector<std::string> here = fields(i);
            if (count_numbers(here) < 3) {
                continue;
            }
            for (size_t k = 0; k < result.size(); ++k) {
                const auto number =
                    k < here.size() ? parse_number_field(here[k]) : std::optional<NumberField>();
                const bool is_empty = k >= here.size() || says_nothing(here[k]);
                result[k].is_number &= number || is_empty;
                result[k].is_whole &= (number && number->decimal == '\0') || is_empty;
                result[k].is_positive &= !number || !number->value || *number->value >= 0.0;
            }
        }
        return result;
    }

    [[nodiscard]] TableLayout layout_of_fields(bool is_cloud) {
        const std::vector<ColumnContent> columns = contents();
        TableLayout layout{.count = columns.size()};
        size_t start = 0;
        while (start + 3 <= columns.size() &&
               !(columns[start].is_number && columns[start + 1].is_number &&
                 columns[start + 2].is_number)) {
            ++start;
        }
        if (start + 3 > columns.size()) {
            fail(m_head.first,
                 fmt::format("has no three columns of numbers side by side: {}", columns_hint));
        }
        const bool has_fourth = start + 3 < columns.size() && columns[start + 3].is_number;
        const bool is_numbered =
            start == 0 && has_fourth && columns[0].is_whole &&
            !(columns[1].is_whole && columns[2].is_whole && columns[3].is_whole && is_cloud);
        if (start > 0) {
            layout.id = 0;
        } else if (is_numbered) {
            layout.id = 0;
            start = 1;
        } else if (has_fourth && columns.size() == 4 && !is_cloud) {
            fail(m_head.first, fmt::format("has four numbers, of which the first is no whole one: "
                                           "is it a name? {}",
                                           columns_hint));
        }
        layout.place = {start, start + 1, start + 2};
        const bool has_spread =
            !is_cloud && columns.size() == start + 6 &&
            std::all_of(columns.begin() + static_cast<long>(start) + 3, columns.end(),
                        [](const ColumnContent& c) { return c.is_number && c.is_positive; });
        if (has_spread) {
            layout.spread = {start + 3, start + 4, start + 5};
        }
        if (!is_cloud || layout.id) {
            m_head.guesses.push_back(
                fmt::format("no header was understood{}: columns taken as {}",
                            m_last_text.empty() ? "" : fmt::format(", {}", quote(m_last_text)),
                            layout.to_string()));
        }
        return layout;
    }

    void set_unit(std::optional<double>& unit, double found, size_t index, const char* of) const {
        if (unit && *unit != found) {
            fail(index, fmt::format("gives two units of {}, expected one for all", of));
        }
        unit = found;
    }

    /// Units of the columns in use, in a line of titles, or of units alone.
    void units_of(const std::vector<std::string>& titles, size_t index, bool is_alone) {
        const auto unit_in = [&](size_t column) -> std::optional<double> {
            if (column >= titles.size()) {
                return std::nullopt;
            }
            const std::string& title = titles[column];
            const auto direct = is_alone ? length_of_unit(title) : std::nullopt;
            return direct ? direct : parse_column_title(title).unit;
        };
        for (size_t k = 0; k < 3; ++k) {
            if (const auto unit = unit_in(m_head.layout.place[k])) {
                set_unit(m_head.unit, *unit, index, "coordinates");
            }
            if (!m_head.layout.spread) {
                continue;
            }
            if (const auto unit = unit_in((*m_head.layout.spread)[k])) {
                set_unit(m_head.spread_unit, *unit, index, "standard deviations");
            }
        }
    }

    /// "unit: mm" in a text or comment before the points, and a line of units below the header.
    void look_for_units() {
        for (size_t i = 0; i < m_head.first; ++i) {
            const std::string text = in_lower_case(m_lines[i].text);
            for (const std::string_view word : {"units", "unit", "einheiten", "einheit"}) {
                const size_t start = text.find(word);
                if (start == std::string::npos) {
                    continue;
                }
                const std::string_view rest = trimmed(text).substr(0);
                std::string_view name =
                    rest.substr(std::min(rest.find(word) + word.size(), rest.size()));
                name.remove_prefix(std::min(name.find_first_not_of(" \t:=;,"), name.size()));
                name = name.substr(0, name.find_first_of(" \t;,.)"));
                if (const auto unit = length_of_unit(name); unit && i != m_head.header) {
                    set_unit(m_head.unit, *unit, i, "coordinates");
                }
                break;
            }
        }
        for (size_t i = m_head.header.value_or(m_head.first) + 1; i < m_head.first; ++i) {
            if (is_content(i)) {
                units_of(fields(i), i, true);
            }
        }
    }

    const std::vector<TextLine>& m_lines;
    char m_separator;
    const std::string& m_file_name;
    TableHead m_head;
    std::string m_last_text;
};

}  // namespace

TableHead read_table_head(const std::vector<TextLine>& lines, char separator,
                          const SurveyFileOptions& options, bool is_cloud,
                          const std::string& file_name) {
    return HeadFinder(lines, separator, file_name).find(options, is_cloud);
}

}  // namespace taut
