// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "interchange/surveys/table_columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "files/message.hpp"
#include "interchange/surveys/survey_reader.hpp"

namespace taut {
namespace {

using Titles = std::vector<std::pair<std::string_view, TableColumn>>;

/// Names of the axes, alone or behind what stands for a standard deviation.
const Titles& axis_titles() {
    static const Titles titles{{"x", TableColumn::x},          {"east", TableColumn::x},
                               {"easting", TableColumn::x},    {"e", TableColumn::x},
                               {"rechtswert", TableColumn::x}, {"rechts", TableColumn::x},
                               {"rw", TableColumn::x},         {"ost", TableColumn::x},
                               {"ostwert", TableColumn::x},    {"xcoordinate", TableColumn::x},
                               {"xcoord", TableColumn::x},     {"xkoordinate", TableColumn::x},
                               {"y", TableColumn::y},          {"north", TableColumn::y},
                               {"northing", TableColumn::y},   {"n", TableColumn::y},
                               {"hochwert", TableColumn::y},   {"hoch", TableColumn::y},
                               {"hw", TableColumn::y},         {"nord", TableColumn::y},
                               {"nordwert", TableColumn::y},   {"ycoordinate", TableColumn::y},
                               {"ycoord", TableColumn::y},     {"ykoordinate", TableColumn::y},
                               {"z", TableColumn::z},          {"height", TableColumn::z},
                               {"h", TableColumn::z},          {"hoehe", TableColumn::z},
                               {"hohe", TableColumn::z},       {"elevation", TableColumn::z},
                               {"elev", TableColumn::z},       {"level", TableColumn::z},
                               {"kote", TableColumn::z},       {"zcoordinate", TableColumn::z},
                               {"zcoord", TableColumn::z},     {"zkoordinate", TableColumn::z},
                               {"orthoheight", TableColumn::z}};
    return titles;
}

const Titles& name_titles() {
    constexpr TableColumn id = TableColumn::id;
    constexpr TableColumn number = TableColumn::running_number;
    constexpr TableColumn code = TableColumn::code;
    static const Titles titles{
        {"id", id},           {"name", id},        {"punkt", id},       {"punktnummer", id},
        {"punktnr", id},      {"pktnr", id},       {"pkt", id},         {"punktname", id},
        {"punktid", id},      {"pnr", id},         {"point", id},       {"pointid", id},
        {"pointname", id},    {"pointno", id},     {"pointnumber", id}, {"pointnr", id},
        {"pt", id},           {"ptid", id},        {"ptno", id},        {"ptnr", id},
        {"node", id},         {"nodeid", id},      {"knoten", id},      {"knotennr", id},
        {"target", id},       {"targetid", id},    {"ziel", id},        {"zielpunkt", id},
        {"bezeichnung", id},  {"label", id},       {"nr", number},      {"no", number},
        {"nummer", number},   {"number", number},  {"lfdnr", number},   {"index", number},
        {"code", code},       {"pointcode", code}, {"punktcode", code}, {"type", code},
        {"targettype", code}, {"zieltyp", code},   {"punktart", code},  {"pktart", code}};
    return titles;
}

std::optional<TableColumn> find_title(const Titles& titles, std::string_view name) {
    const auto found = std::ranges::find(titles, name, &Titles::value_type::first);
    return found == titles.end() ? std::nullopt : std::optional(found->second);
}

/// In lower case, umlauts as ae, oe, ue, without signs and blanks: "Pkt.-Nr" is "pktnr".
std::string bare_title(std::string_view text) {
    std::string bare;
    const std::string lower = in_lower_case(text);
    for (size_t i = 0; i < lower.size(); ++i) {
        const std::string_view letter = std::string_view(lower).substr(i, 2);
        if (letter == "\xC3\xA4" || letter == "\xC3\x84") {
            bare += "ae";
        } else if (letter == "\xC3\xB6" || letter == "\xC3\x96") {
            bare += "oe";
        } else if (letter == "\xC3\xBC" || letter == "\xC3\x9C") {
            bare += "ue";
        } else if ((lower[i] >= 'a' && lower[i] <= 'z') || (lower[i] >= '0' && lower[i] <= '9')) {
            bare += lower[i];
        }
    }
    return bare;
}

std::optional<TableColumn> column_of_title(const std::string& bare) {
    if (const auto axis = find_title(axis_titles(), bare)) {
        return axis;
    }
    if (const auto id = find_title(name_titles(), bare)) {
        return id;
    }
    for (const std::string_view sign : {"stddev", "stdev", "std", "sigma", "sd", "rms", "s", "m"}) {
        for (const bool is_before : {true, false}) {
            if (bare.size() <= sign.size() ||
                !(is_before ? bare.starts_with(sign) : bare.ends_with(sign))) {
                continue;
            }
            const size_t length = bare.size() - sign.size();
            const std::string axis = bare.substr(is_before ? sign.size() : 0, length);
            // "xs" and "ms" may be anything.
            if (const auto found = find_title(axis_titles(), axis);
                found && (is_before || sign.size() > 1)) {
                constexpr TableColumn spreads[] = {TableColumn::sx, TableColumn::sy,
                                                   TableColumn::sz};
                return spreads[static_cast<int>(*found) - static_cast<int>(TableColumn::x)];
            }
        }
    }
    return std::nullopt;
}

}  // namespace

ColumnTitle parse_column_title(std::string_view field) {
    const std::string_view text = trimmed(field);
    ColumnTitle title;
    std::string_view name = text;
    for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
        const size_t start = text.find(open);
        const size_t end = text.find(close, start == std::string_view::npos ? 0 : start);
        if (start != std::string_view::npos && end != std::string_view::npos) {
            title.unit = length_of_unit(text.substr(start + 1, end - start - 1));
            name = text.substr(0, start);
        }
    }
    if (const size_t behind = text.find_last_of("/_ "); !title.unit && behind < text.size()) {
        title.unit = length_of_unit(text.substr(behind + 1));
        name = title.unit ? text.substr(0, behind) : name;
    }
    title.column = column_of_title(bare_title(name));
    return title;
}

size_t TableLayout::needed() const {
    return 1 + std::ranges::max(place);
}

bool TableLayout::uses(size_t column) const {
    return column == id || column == code || std::ranges::find(place, column) != place.end() ||
           (spread && std::ranges::find(*spread, column) != spread->end());
}

std::string TableLayout::to_string() const {
    std::vector<std::string> names(count, "-");
    if (id) {
        names[*id] = "id";
    }
    if (code) {
        names[*code] = "code";
    }
    for (size_t k = 0; k < 3; ++k) {
        names[place[k]] = "xyz"[k];
        if (spread) {
            names[(*spread)[k]] = std::string("s") + "xyz"[k];
        }
    }
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

TableLayout layout_of_names(const std::vector<std::string>& names) {
    const auto find = [&](std::string_view name) {
        const auto found = std::ranges::find(names, name);
        return found == names.end() ? std::nullopt : std::optional<size_t>(found - names.begin());
    };
    TableLayout layout{.id = find("id"), .code = find("code"), .count = names.size()};
    layout.place = {find("x").value(), find("y").value(), find("z").value()};
    if (find("sx")) {
        layout.spread = {find("sx").value(), find("sy").value(), find("sz").value()};
    }
    return layout;
}

std::vector<std::string> parse_survey_columns(std::string_view text) {
    std::vector<std::string> names;
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(
            fmt::format("the columns {} {}, expected id, x, y, z, sx, sy, sz, code, each once, and "
                        "- for one to leave out: \"id,y,x,z,-\"",
                        quote(text), what));
    };
    const auto has = [&](std::string_view name) {
        return std::ranges::find(names, name) != names.end();
    };
    for (;;) {
        const size_t end = std::min(text.find(','), text.size());
        const std::string name(trimmed(text.substr(0, end)));
        constexpr std::array<std::string_view, 9> known{"id", "x",  "y",    "z", "sx",
                                                        "sy", "sz", "code", "-"};
        if (std::ranges::find(known, name) == known.end()) {
            refuse("hold " + quote(name));
        }
        if (name != "-" && has(name)) {
            refuse("hold " + quote(name) + " twice");
        }
        names.push_back(name);
        if (end == text.size()) {
            break;
        }
        text.remove_prefix(end + 1);
    }
    if (!has("x") || !has("y") || !has("z")) {
        refuse("lack a coordinate");
    }
    if (has("sx") != has("sy") || has("sx") != has("sz")) {
        refuse("lack a standard deviation");
    }
    return names;
}

}  // namespace taut
