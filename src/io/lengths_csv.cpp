// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/lengths_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "files/csv_field.hpp"
#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

const std::vector<std::string> columns{"edge", "nominal", "length_deviation"};

/// A nominal length that another program wrote has lost digits; that of another net differs.
constexpr double same_length = 1e-6;

[[noreturn]] void fail(const std::string& file_name, const CsvRecord& record,
                       const std::string& what) {
    throw InputError(file_name, std::to_string(record.line), what);
}

double number_in(const CsvRecord& record, size_t column, const std::string& file_name) {
    const auto value = parse_number(record.fields[column]);
    if (!value) {
        fail(file_name, record,
             fmt::format("{} is {}, expected a finite number [m]", columns[column],
                         quote(record.fields[column])));
    }
    return *value;
}

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
    CsvReader reader(table_text(text, file_name), file_name);
    const auto head = reader.next();
    if (!head || head->fields != columns) {
        throw InputError(file_name, head ? std::to_string(head->line) : "",
                         "does not start with the header edge,nominal,length_deviation");
    }
    std::map<std::string, int> edge_of;
    for (int edge = 0; edge < nominal.edge_count(); ++edge) {
        edge_of.emplace(nominal.edge_id(edge), edge);
    }
    Eigen::VectorXd lengths = nominal.unstressed_lengths();
    std::vector<int> line_of(nominal.edge_count(), 0);
    while (const auto record = reader.next()) {
        if (record->fields.size() != columns.size()) {
            fail(file_name, *record,
                 fmt::format("has {} fields, expected {}", record->fields.size(), columns.size()));
        }
        const std::string& id = record->fields[0];
        const auto found = edge_of.find(id);
        if (found == edge_of.end()) {
            fail(file_name, *record,
                 fmt::format("{} is no edge of the net '{}'", quote(id), nominal.name()));
        }
        const int edge = found->second;
        if (line_of[edge] != 0) {
            fail(file_name, *record,
                 fmt::format("gives edge {} a second time, first in line {}", quote(id),
                             line_of[edge]));
        }
        line_of[edge] = record->line;
        const double told = number_in(*record, 1, file_name);
        const double designed = nominal.unstressed_lengths()(edge);
        if (std::abs(told - designed) > same_length * designed) {
            fail(file_name, *record,
                 fmt::format("the nominal length of edge {} is {} m, expected {} m as in the net "
                             "'{}': are these its lengths?",
                             quote(id), told, designed, nominal.name()));
        }
        lengths(edge) = designed + number_in(*record, 2, file_name);
        if (!(lengths(edge) > 0.0)) {
            fail(file_name, *record,
                 fmt::format("edge {} is {} m long, expected a positive length", quote(id),
                             lengths(edge)));
        }
    }
    for (const int edge : nominal.interior_edges()) {
        if (line_of[edge] == 0) {
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
