// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/lengths_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "files/csv_field.hpp"
#include "io/name_column.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

/// A nominal length that another program wrote has lost digits; that of another net differs.
constexpr double same_length = 1e-6;

}  // namespace

std::string lengths_to_csv(const CableNet& nominal, const CableNet& built) {
    if (nominal.interior_edges() != built.interior_edges()) {
        throw std::invalid_argument("the built net has other interior edges than the nominal one");
    }
    std::string result = "edge,nominal,length_deviation\n";
    const auto add = [&](int edge) {
        const double length = nominal.unstressed_lengths()(edge);
        result += fmt::format("{},{},{}\n", csv_field(nominal.edge_id(edge)), length,
                              built.unstressed_lengths()(edge) - length);
    };
    std::ranges::for_each(nominal.interior_edges(), add);
    for (const int edge : nominal.adjustable_edges()) {
        if (built.unstressed_lengths()(edge) != nominal.unstressed_lengths()(edge)) {
            add(edge);
        }
    }
    return result;
}

Eigen::VectorXd parse_lengths(const CableNet& nominal, std::string_view text,
                              const std::string& file_name) {
    const CsvTable table(
        text, file_name,
        {.names = {"edge", "nominal", "length_deviation"}, .header = CsvColumns::Header::required},
        "");
    NameColumn edges = NameColumn::of_edges(table, nominal);
    Eigen::VectorXd lengths = nominal.unstressed_lengths();
    std::vector<bool> is_given(nominal.edge_count(), false);
    for (const CsvRecord& row : table.rows()) {
        const int edge = edges.unique_index(row);
        is_given[edge] = true;
        const std::string name = quote(table.text(row, 0));
        const double length = table.number(row, 1);
        const double designed = nominal.unstressed_lengths()(edge);
        if (std::abs(length - designed) > same_length * designed) {
            table.fail(row,
                       fmt::format("the nominal length of edge {} is {} m, expected {} m as in "
                                   "the net '{}': are these its lengths?",
                                   name, length, designed, nominal.name()));
        }
        lengths(edge) = designed + table.number(row, 2);
        if (!(lengths(edge) > 0.0)) {
            table.fail(row, fmt::format("edge {} is {} m long, expected a positive length", name,
                                        lengths(edge)));
        }
    }
    for (const int edge : nominal.interior_edges()) {
        if (!is_given[edge]) {
            throw InputError(
                file_name, "",
                fmt::format("holds no length of edge {}, expected one for each of the "
                            "{} interior edges",
                            quote(nominal.edge_id(edge)), nominal.interior_edge_count()));
        }
    }
    return lengths;
}

}  // namespace taut
