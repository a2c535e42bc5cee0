// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>

#include "files/csv_field.hpp"
#include "taut/io/read_survey.hpp"

namespace taut {

std::string survey_names_csv(const CableNet& net, const Survey& survey) {
    struct Row {
        int line;
        std::string text;
    };
    std::vector<Row> rows;
    const auto add = [&](int line, const std::string& name, int node, double distance,
                         std::string_view status) {
        rows.push_back(
            {line, fmt::format("{},{},{},{:.6g},{}\n", line, name.empty() ? "" : csv_field(name),
                               csv_field(net.node_id(node)), distance, status)});
    };
    for (const PlacedPoint& point : survey.placed) {
        add(point.line, point.name, point.node, point.distance, "used");
    }
    for (const UnmatchedPoint& left : survey.unmatched) {
        add(left.point.line, left.point.id.empty() ? left.point.label : left.point.id, left.nearest,
            left.distance, to_string(left.reason));
    }
    std::ranges::stable_sort(rows, {}, &Row::line);
    std::string text = "line,name,node,distance,status\n";
    for (const Row& row : rows) {
        text += row.text;
    }
    return text;
}

}  // namespace taut
