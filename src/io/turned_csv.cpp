// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/turned_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "io/edge_column.hpp"

namespace taut {
namespace {

/// Where the columns of a file of turns stand; -1: it has none.
struct TurnedColumns {
    size_t fields = 0;
    int edge = 0;
    int stroke = 1;
    int std = -1;
    int pass = -1;
    double unit = 1.0;  ///< of strokes [m]
};

int column_of(const CsvRecord& header, std::string_view name) {
    const auto found = std::ranges::find(header.fields, name);
    return found == header.fields.end() ? -1 : static_cast<int>(found - header.fields.begin());
}

/// The columns that the first line tells, and whether it is a header.
std::pair<TurnedColumns, bool> columns_of(const EdgeColumn& edges, const CsvRecord& first) {
    TurnedColumns columns{.fields = first.fields.size()};
    if (const int in_mm = column_of(first, "stroke_mm"); in_mm >= 0) {
        columns.edge = column_of(first, "edge");
        columns.stroke = in_mm;
        columns.pass = column_of(first, "pass");
        columns.unit = 1e-3;
        if (columns.edge < 0 || columns.pass < 0) {
            edges.fail(first,
                       "has a column stroke_mm, but none called edge or pass, as the list "
                       "of a plan has");
        }
        return {columns, true};
    }
    if (columns.fields != 2 && columns.fields != 3) {
        edges.fail(first, fmt::format("has {} fields, expected edge,stroke[,std]", columns.fields));
    }
    columns.std = columns.fields == 3 ? 2 : -1;
    return {columns, first.fields[0] == "edge" && first.fields[1] == "stroke" &&
                         (columns.fields == 2 || first.fields[2] == "std")};
}

class TurnedReader {
public:
    TurnedReader(const CableNet& net, const std::string& file_name)
        : m_net(net), m_file_name(file_name), m_lines(net, file_name) {}

    std::vector<EdgeTurned> read(std::string_view text) && {
        CsvReader reader(text, m_file_name);
        bool is_first = true;
        while (const auto record = reader.next()) {
            bool is_header = false;
            if (is_first) {
                std::tie(m_columns, is_header) = columns_of(m_lines, *record);
                is_first = false;
            }
            if (record->fields.size() != m_columns.fields) {
                m_lines.fail(*record, fmt::format("has {} fields, expected {}",
                                                  record->fields.size(), m_columns.fields));
            }
            if (!is_header) {
                add(*record);
            }
        }
        if (m_turned.empty()) {
            throw InputError(
                m_file_name, "",
                "tells of no turn, expected lines edge,stroke[,std]; where nothing was "
                "turned leave it out");
        }
        std::vector<EdgeTurned> result;
        result.reserve(m_turned.size());
        for (const auto& [edge, turned] : m_turned) {
            result.push_back(turned);
        }
        return result;
    }

private:
    double number(const CsvRecord& record, int column, std::string_view name) const {
        const auto value = parse_number(record.fields[static_cast<size_t>(column)]);
        if (!value) {
            m_lines.fail(record, fmt::format("{} is {}, expected a finite number", name,
                                             quote(record.fields[static_cast<size_t>(column)])));
        }
        return *value;
    }

    void add(const CsvRecord& record) {
        const auto of_edge = static_cast<size_t>(m_columns.edge);
        const int edge = m_lines.find(record, record.fields[of_edge]);
        const std::string name = quote(record.fields[of_edge]);
        if (!std::ranges::binary_search(m_net.adjustable_edges(), edge)) {
            m_lines.fail(record, fmt::format("edge {} is not adjustable", name));
        }
        const std::string pass =
            m_columns.pass >= 0 ? record.fields[static_cast<size_t>(m_columns.pass)] : "";
        if (!m_named.emplace(edge, pass).second) {
            m_lines.fail(record, fmt::format("names edge {} a second time{}", name,
                                             pass.empty() ? "" : " in pass " + pass));
        }
        EdgeTurned& turned = m_turned[edge];
        turned.edge = edge;
        turned.stroke += m_columns.unit * number(record, m_columns.stroke, "stroke");
        turned.std = m_columns.std >= 0 ? number(record, m_columns.std, "std") : 0.0;
        const double most = most_turned_part * m_net.unstressed_lengths()(edge);
        if (!(std::abs(turned.stroke) <= most)) {
            m_lines.fail(record, fmt::format("edge {} is turned by {:g} m, expected at most {:.3g} "
                                             "m, a quarter of its length: strokes are in metres",
                                             name, turned.stroke, most));
        }
        if (!(turned.std >= 0.0 && turned.std <= most)) {
            m_lines.fail(record,
                         fmt::format("std is {:g} m, expected 0 to {:.3g} m, a quarter of the "
                                     "edge's length",
                                     turned.std, most));
        }
    }

    const CableNet& m_net;
    const std::string& m_file_name;
    EdgeColumn m_lines;
    TurnedColumns m_columns;
    std::set<std::pair<int, std::string>> m_named;
    std::map<int, EdgeTurned> m_turned;
};

}  // namespace

std::vector<EdgeTurned> parse_turned(const CableNet& net, std::string_view text,
                                     const std::string& file_name) {
    const std::string plain(table_text(text, file_name));
    return TurnedReader(net, file_name).read(plain);
}

}  // namespace taut
