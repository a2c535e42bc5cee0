// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/forces_csv.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "io/edge_column.hpp"
#include "net/check_index.hpp"
#include "taut/files/input_error.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// @throws InputError where the field is no finite number of 0 or more
double force_in(const EdgeColumn& edges, const CsvRecord& record, size_t column,
                std::string_view name) {
    const auto value = parse_number(record.fields[column]);
    if (!value || *value < 0.0) {
        edges.fail(record, fmt::format("{} is {}, expected a finite number of 0 or more", name,
                                       quote(record.fields[column])));
    }
    return *value;
}

}  // namespace

std::vector<ForceMeasurement> parse_force_measurements(const CableNet& net, std::string_view text,
                                                       const std::string& file_name,
                                                       const ForceFormat& format) {
    CsvReader reader(table_text(text, file_name), file_name);
    EdgeColumn edges(net, file_name);
    std::vector<ForceMeasurement> readings;
    size_t columns = 0;
    while (const auto record = reader.next()) {
        const bool is_first = columns == 0;
        const size_t found = record->fields.size();
        if (is_first) {
            columns = found;
        }
        if (found != columns || (found != 2 && found != 3)) {
            edges.fail(*record, is_first || found == 2 || found == 3
                                    ? fmt::format("has {} fields, expected edge,tension[,std]{}",
                                                  found, is_first ? "" : " as in the lines before")
                                    : fmt::format("has {} fields, expected {}", found, columns));
        }
        if (is_first && record->fields[0] == "edge" && record->fields[1] == "tension" &&
            (columns == 2 || record->fields[2] == "std")) {
            continue;
        }
        ForceMeasurement reading{.edge = edges.edge(*record),
                                 .tension = format.unit * force_in(edges, *record, 1, "tension")};
        reading.std = columns == 3       ? format.unit * force_in(edges, *record, 2, "std")
                      : format.std > 0.0 ? format.std
                                         : format.relative_std * reading.tension;
        constexpr double largest = 1e12;  // no cable bears it, and its square is a number
        if (reading.tension > largest || reading.std > largest) {
            edges.fail(*record, fmt::format("the tension is {:.3g} N, with a standard deviation of "
                                            "{:.3g} N, expected less than 1e12 N",
                                            reading.tension, reading.std));
        }
        constexpr double finest = 1e-6;  // no reading is finer, and rounding errors are not far
        if (reading.std > 0.0 && reading.std < finest * std::max(1.0, reading.tension)) {
            edges.fail(*record, fmt::format("the standard deviation is {:.3g} N, expected at least "
                                            "a millionth of the reading",
                                            reading.std));
        }
        if (!(reading.std > 0.0)) {
            edges.fail(*record,
                       columns == 3
                           ? "std is 0, expected a positive one"
                           : "tension is 0, of which no part is a standard deviation: tell std in "
                             "the file, or --force-noise in newtons");
        }
        readings.push_back(reading);
    }
    if (readings.empty()) {
        throw InputError(file_name, "", "holds no reading, expected lines edge,tension[,std]");
    }
    return readings;
}

std::vector<int> parse_edge_list(const CableNet& net, std::string_view text,
                                 const std::string& file_name) {
    CsvReader reader(table_text(text, file_name), file_name);
    EdgeColumn edges(net, file_name);
    std::vector<int> result;
    bool is_first = true;
    while (const auto record = reader.next()) {
        if (record->fields.size() != 1) {
            edges.fail(*record, fmt::format("has {} fields, expected the name of one edge",
                                            record->fields.size()));
        }
        if (!is_first || record->fields[0] != "edge") {
            result.push_back(edges.edge(*record));
        }
        is_first = false;
    }
    if (result.empty()) {
        throw InputError(file_name, "", "names no edge, expected one a line");
    }
    return result;
}

bool is_edge_list(std::string_view text, const std::string& file_name) {
    CsvReader reader(plain_text(text, file_name), file_name);
    const auto first = reader.next();
    return first && first->fields.size() == 1;
}

std::string force_unit_warning(const CableNet& net, const std::vector<ForceMeasurement>& readings,
                               const std::string& file_name) {
    const Eigen::VectorXd designed = tensions(net, net.unstressed_lengths(), net.nodes());
    std::vector<double> ratios;
    for (const ForceMeasurement& reading : readings) {
        check_index("edge", reading.edge, net.edge_count());
        if (designed(reading.edge) > 0.0 && reading.tension > 0.0) {
            ratios.push_back(reading.tension / designed(reading.edge));
        }
    }
    if (ratios.empty()) {
        return {};
    }
    std::ranges::sort(ratios);
    const double median = ratios[ratios.size() / 2];
    constexpr double far = 2.5;
    constexpr double impossible = 50.0;
    if (median >= 1.0 / far && median <= far) {
        return {};
    }
    constexpr double kilo = 1e3;
    const bool is_kilo = median * kilo > 1.0 / far && median * kilo < far;
    const std::string text = fmt::format(
        "the tensions read are {:.2g} times those designed, in the middle: {}", median,
        is_kilo ? "are they in kN? --force-unit kN tells it" : "is their unit the one told?");
    if (median < 1.0 / impossible || median > impossible) {
        throw InputError(file_name, "", text);
    }
    return text;
}

}  // namespace taut
