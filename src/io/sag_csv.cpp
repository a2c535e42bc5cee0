// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/sag_csv.hpp"

#include "io/name_column.hpp"

namespace taut {

std::vector<SagPoint> parse_sag_points(const CableNet& net, std::string_view text,
                                       const std::string& file_name, double std_dev) {
    const CsvTable table(text, file_name, {.names = {"edge", "x", "y", "z", "std"}, .optional = 1},
                         "holds no point");
    const NameColumn edges = NameColumn::of_edges(table, net);
    std::vector<SagPoint> result;
    for (const CsvRecord& row : table.rows()) {
        SagPoint point{
            .edge = edges.index(row),
            .position = {table.number(row, 1), table.number(row, 2), table.number(row, 3)},
            .std_dev = table.has(4) ? table.number(row, 4) : std_dev};
        if (!(point.std_dev > 0.0)) {
            table.has(4) ? table.refuse(row, 4, "a positive one")
                         : table.fail(row,
                                      "the point has no standard deviation: give std in the "
                                      "file, or that of the survey");
        }
        result.push_back(point);
    }
    return result;
}

}  // namespace taut
