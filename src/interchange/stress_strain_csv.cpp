// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/interchange/stress_strain_csv.hpp"

#include <fmt/core.h>

#include <vector>

#include "files/csv_reader.hpp"
#include "files/message.hpp"
#include "files/parse_number.hpp"
#include "files/plain_text.hpp"
#include "taut/files/input_error.hpp"

namespace taut {
namespace {

constexpr double softest = 1e8;  ///< of a cable's material, rise of stress over strain [Pa]
constexpr double stiffest = 1e12;

[[noreturn]] void fail(const std::string& file_name, int line, const std::string& what) {
    throw InputError(file_name, std::to_string(line), what);
}

double number_in(const CsvRecord& record, size_t column, const char* name,
                 const std::string& file_name) {
    const auto value = parse_number(record.fields[column]);
    if (!value) {
        fail(file_name, record.line,
             fmt::format("{} is {}, expected a finite number", name, quote(record.fields[column])));
    }
    return *value;
}

}  // namespace

StressStrain parse_stress_strain(std::string_view text, const std::string& file_name) {
    CsvReader reader(table_text(text, file_name), file_name);
    const auto head = reader.next();
    if (!head || head->fields != std::vector<std::string>{"strain", "stress"}) {
        throw InputError(file_name, head ? std::to_string(head->line) : "",
                         "does not start with the header strain,stress");
    }
    std::vector<double> strain;
    std::vector<double> stress;
    int line = head->line;
    while (const auto record = reader.next()) {
        line = record->line;
        if (record->fields.size() != 2) {
            fail(file_name, line,
                 fmt::format("has {} fields, expected strain and stress", record->fields.size()));
        }
        strain.push_back(number_in(*record, 0, "strain", file_name));
        stress.push_back(number_in(*record, 1, "stress", file_name));
    }
    const auto count = static_cast<Eigen::Index>(strain.size());
    StressStrain result{.strain = Eigen::Map<const Eigen::VectorXd>(strain.data(), count),
                        .stress = Eigen::Map<const Eigen::VectorXd>(stress.data(), count)};
    const TensionLaw law{.name = "", .strain = result.strain, .tension = result.stress};
    if (const std::string problem = problem_of(law); !problem.empty()) {
        fail(file_name, line, "the table of stress over strain " + problem);
    }
    if (const double slope = law.steepest(); slope < softest || slope > stiffest) {
        fail(file_name, line,
             fmt::format("rises by {:.3g} Pa over strain at most, expected {:g} to {:g}: are its "
                         "stresses in Pa, and its strains without unit?",
                         slope, softest, stiffest));
    }
    return result;
}

}  // namespace taut
