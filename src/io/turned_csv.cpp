// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/turned_csv.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "io/name_column.hpp"
#include "taut/files/input_error.hpp"

namespace taut {

std::vector<EdgeTurned> parse_turned(const CableNet& net, std::string_view text,
                                     const std::string& file_name) {
    enum Column : size_t { edge_column, stroke_column, std_column, pass_column = std_column };
    constexpr const char* nothing = "holds no turn (where nothing was turned leave the file out)";
    const std::vector<std::string> first = first_fields(text, file_name);
    const bool is_plan = std::ranges::find(first, "stroke_mm") != first.end();
    const CsvTable table(text, file_name,
                         is_plan ? CsvColumns{.names = {"edge", "stroke_mm", "pass"},
                                              .header = CsvColumns::Header::by_name}
                                 : CsvColumns{.names = {"edge", "stroke", "std"}, .optional = 1},
                         nothing);
    NameColumn edges = NameColumn::of_edges(table, net);
    std::set<std::pair<int, std::string>> passes;
    std::map<int, EdgeTurned> turned_of;
    for (const CsvRecord& row : table.rows()) {
        const int edge = is_plan ? edges.index(row) : edges.unique_index(row);
        const std::string name = quote(table.text(row, edge_column));
        if (!std::ranges::binary_search(net.adjustable_edges(), edge)) {
            table.fail(row, fmt::format("edge {} is not adjustable", name));
        }
        if (is_plan && !passes.emplace(edge, table.text(row, pass_column)).second) {
            table.fail(row, fmt::format("names edge {} a second time in pass {}", name,
                                        table.text(row, pass_column)));
        }
        EdgeTurned& turned = turned_of[edge];
        turned.edge = edge;
        turned.stroke += (is_plan ? 1e-3 : 1.0) * table.number(row, stroke_column);
        turned.std_dev = !is_plan && table.has(std_column) ? table.number(row, std_column) : 0.0;
        const double most = most_turned_part * net.unstressed_lengths()(edge);
        if (!(std::abs(turned.stroke) <= most)) {
            table.fail(row, fmt::format("edge {} is turned by {:g} m, expected at most {:.3g} m, a "
                                        "quarter of its length: strokes are in metres",
                                        name, turned.stroke, most));
        }
        if (!(turned.std_dev >= 0.0 && turned.std_dev <= most)) {
            table.fail(row, fmt::format("std is {:g} m, expected 0 to {:.3g} m, a quarter of the "
                                        "edge's length",
                                        turned.std_dev, most));
        }
    }
    std::vector<EdgeTurned> result;
    result.reserve(turned_of.size());
    for (const auto& [edge, turned] : turned_of) {
        result.push_back(turned);
    }
    return result;
}

}  // namespace taut
