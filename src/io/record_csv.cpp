// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/record_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "files/csv_field.hpp"
#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "files/plain_text.hpp"
#include "interchange/surveys/table_lines.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

using RecordTitles = std::vector<std::string>;

bool is_time_title(const std::string& title) {
    return title.find("time") != std::string::npos || title.find("zeit") != std::string::npos ||
           title.find("elapsed") != std::string::npos || title == "t" || title.starts_with("t ") ||
           title.starts_with("t(") || title.starts_with("t[");
}

/// Of the first column where no title says another.
size_t time_column(const RecordTitles& titles) {
    auto found = std::ranges::find_if(titles, [](const std::string& title) {
        return title.find("elapsed") != std::string::npos;
    });
    found = found != titles.end() ? found : std::ranges::find_if(titles, is_time_title);
    return found != titles.end() ? static_cast<size_t>(found - titles.begin()) : 0;
}

double time_unit(const std::string& title) {
    const auto has = [&](std::string_view unit) {
        return title.find(fmt::format("({})", unit)) != std::string::npos ||
               title.find(fmt::format("[{}]", unit)) != std::string::npos ||
               title.ends_with(fmt::format("_{}", unit));
    };
    return has("ms") ? 1e-3 : has("us") || has("\u00B5s") ? 1e-6 : has("ns") ? 1e-9 : 1.0;
}

/// The numbers of a file by rows, and what stands above them.
struct RecordTable {
    RecordTitles titles;  ///< in lower case; none where they are not one for each column
    size_t columns = 0;
    std::vector<double> numbers;
    std::vector<int> lines;  ///< of each row

    [[nodiscard]] Eigen::VectorXd column(size_t c) const {
        Eigen::VectorXd values(std::ssize(lines));
        for (size_t i = 0; i < lines.size(); ++i) {
            values(static_cast<Eigen::Index>(i)) = numbers[i * columns + c];
        }
        return values;
    }
};

RecordTable read_record_table(std::string_view text, const std::string& file_name) {
    RecordTable table;
    CsvReader reader(table_text(text, file_name), file_name);
    for (auto row = reader.next(); row; row = reader.next()) {
        const auto fail = [&](const std::string& what) {
            throw InputError(file_name, std::to_string(row->line), what);
        };
        const bool is_first = table.columns == 0;
        if (is_first && table.titles.empty() && count_numbers(row->fields) == 0) {
            table.titles = std::move(row->fields);
            for (std::string& title : table.titles) {
                std::ranges::transform(title, title.begin(), [](char c) {
                    return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
                });
            }
            continue;
        }
        table.columns = is_first ? row->fields.size() : table.columns;
        if (row->fields.size() != table.columns) {
            fail(fmt::format("has {} fields, expected {} as in the lines before",
                             row->fields.size(), table.columns));
        }
        for (const std::string& field : row->fields) {
            const auto number = parse_number_field(field);
            if (!number || !number->value) {
                fail(fmt::format("holds {}, expected a finite number", quote(field)));
            }
            table.numbers.push_back(*number->value);
        }
        table.lines.push_back(row->line);
    }
    if (table.lines.empty()) {
        throw InputError(file_name, "", "holds no sample, expected lines of a time and signals");
    }
    if (table.titles.size() != table.columns) {
        table.titles.clear();
    }
    return table;
}

}  // namespace

VibrationRecord parse_vibration_record(std::string_view text, const std::string& file_name,
                                       std::optional<double> rate) {
    const RecordTable table = read_record_table(text, file_name);
    const bool has_time_title = std::ranges::any_of(table.titles, is_time_title);
    if (rate && has_time_title) {
        throw InputError(file_name, "", "has a column of times, and a rate is given: leave it out");
    }
    if (!rate && table.columns == 1) {
        throw InputError(file_name, "", "has one column, and no times: give the rate of samples");
    }
    const size_t time_at = rate ? table.columns : time_column(table.titles);
    std::vector<size_t> signals;
    for (size_t c = 0; c < table.columns; ++c) {
        if (c != time_at && !(has_time_title && is_time_title(table.titles[c]))) {
            signals.push_back(c);
        }
    }
    Eigen::MatrixXd values(std::ssize(table.lines), std::ssize(signals));
    for (size_t k = 0; k < signals.size(); ++k) {
        values.col(static_cast<Eigen::Index>(k)) = table.column(signals[k]);
    }
    Eigen::VectorXd time =
        rate ? Eigen::VectorXd::LinSpaced(values.rows(), 0.0,
                                          static_cast<double>(values.rows() - 1) / *rate)
             : table.column(time_at);
    if (!table.titles.empty() && !rate) {
        time *= time_unit(table.titles[time_at]);
    }
    if (signals.empty()) {
        throw InputError(file_name, "", "has no column of signals beside the times");
    }
    if (const auto fault = record_fault(time, values)) {
        const int line = table.lines[static_cast<size_t>(fault->sample)];
        throw InputError(file_name, std::to_string(line), fault->what);
    }
    return evenly_sampled(time, values);
}

std::string frequency_to_csv(const std::string& edge, const Fundamental& fundamental) {
    return fmt::format("edge,frequency,mode,std\n{},{:.6g},1,{:.3g}\n", csv_field(edge),
                       fundamental.frequency, fundamental.std_dev);
}

}  // namespace taut
