// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/frequencies_csv.hpp"

#include <cmath>

#include "io/name_column.hpp"

namespace taut {

std::vector<FrequencyMeasurement> parse_frequencies(const CableNet& net, std::string_view text,
                                                    const std::string& file_name,
                                                    double relative_std) {
    const CsvTable table(text, file_name,
                         {.names = {"edge", "frequency", "mode", "std"}, .optional = 2},
                         "holds no frequency");
    NameColumn edges = NameColumn::of_edges(table, net);
    std::vector<FrequencyMeasurement> result;
    for (const CsvRecord& row : table.rows()) {
        constexpr double slowest = 0.01;
        constexpr double fastest = 1e5;
        constexpr double highest_mode = 50.0;
        FrequencyMeasurement one{.edge = edges.unique_index(row),
                                 .frequency = table.number(row, 1)};
        if (!(one.frequency >= slowest) || !(one.frequency <= fastest)) {
            table.refuse(row, 1, "0.01 to 100,000 Hz");
        }
        if (table.has(2)) {
            const double mode = table.number(row, 2);
            if (!(mode >= 1.0) || !(mode <= highest_mode) || mode != std::floor(mode)) {
                table.refuse(row, 2, "the number of half waves, 1 to 50");
            }
            one.mode = static_cast<int>(mode);
        }
        one.std_dev = table.has(3) ? table.number(row, 3) : relative_std * one.frequency;
        if (!(one.std_dev > 0.0)) {
            table.has(3) ? table.refuse(row, 3, "a positive one")
                         : table.fail(row, "the frequency has no positive standard deviation");
        }
        result.push_back(one);
    }
    return result;
}

}  // namespace taut
