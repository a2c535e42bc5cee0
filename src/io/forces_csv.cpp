// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/forces_csv.hpp"

#include <algorithm>
#include <cmath>

#include "io/name_column.hpp"
#include "net/check_index.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

double force_in(const CsvTable& table, const CsvRecord& row, size_t column, bool is_strut) {
    const double force = table.number(row, column);
    if (force < 0.0 && !is_strut) {
        table.refuse(row, column, "0 or more");
    }
    return force;
}

}  // namespace

std::vector<ForceMeasurement> parse_force_measurements(const CableNet& net, std::string_view text,
                                                       const std::string& file_name,
                                                       const ForceFormat& format) {
    const CsvTable table(text, file_name, {.names = {"edge", "tension", "std"}, .optional = 1},
                         "holds no force measurement");
    const bool has_std = table.has(2);
    NameColumn edges = NameColumn::of_edges(table, net);
    std::vector<ForceMeasurement> measurements;
    for (const CsvRecord& row : table.rows()) {
        ForceMeasurement measurement{.edge = edges.unique_index(row)};
        measurement.tension = format.unit * force_in(table, row, 1, net.is_strut(measurement.edge));
        const double tension = std::abs(measurement.tension);
        const double std_dev = has_std                ? format.unit * force_in(table, row, 2, false)
                               : format.std_dev > 0.0 ? format.std_dev
                                                      : format.relative_std * tension;
        constexpr double largest = 1e12;  // no cable bears it, and its square is a number
        if (tension > largest || std_dev > largest) {
            table.fail(row, fmt::format("the tension is {:.3g} N, with a standard deviation of "
                                        "{:.3g} N, expected less than 1e12 N",
                                        tension, std_dev));
        }
        constexpr double finest = 1e-6;  // no instrument is finer, and rounding errors are not far
        if (std_dev > 0.0 && std_dev < finest * std::max(1.0, tension)) {
            table.fail(row, fmt::format("the standard deviation is {:.3g} N, expected at least a "
                                        "millionth of the force",
                                        std_dev));
        }
        if (!(std_dev > 0.0)) {
            table.fail(row, has_std ? "std is 0, expected a positive one"
                                    : "tension is 0, of which no part is a standard deviation: "
                                      "give std in the file, or one for all in newtons");
        }
        measurement.std_dev = std_dev;
        measurements.push_back(measurement);
    }
    return measurements;
}

std::vector<int> parse_edge_list(const CableNet& net, std::string_view text,
                                 const std::string& file_name) {
    const CsvTable table(text, file_name, {.names = {"edge"}}, "names no edge");
    NameColumn edges = NameColumn::of_edges(table, net);
    std::vector<int> result;
    for (const CsvRecord& row : table.rows()) {
        result.push_back(edges.unique_index(row));
    }
    return result;
}

bool is_edge_list(std::string_view text, const std::string& file_name) {
    return first_fields(text, file_name).size() == 1;
}

}  // namespace taut
