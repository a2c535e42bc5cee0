// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/interchange/stress_strain_csv.hpp"

#include <fmt/core.h>

#include <iterator>

#include "files/csv_table.hpp"

namespace taut {
namespace {

constexpr double softest = 1e8;  ///< steepest slope of a cable's material [Pa]
constexpr double stiffest = 1e12;

}  // namespace

StressStrain parse_stress_strain(std::string_view text, const std::string& file_name) {
    const CsvTable table(text, file_name,
                         {.names = {"strain", "stress"}, .header = CsvColumns::Header::required},
                         "holds no point");
    const auto count = std::ssize(table.rows());
    StressStrain result{.strain = Eigen::VectorXd(count), .stress = Eigen::VectorXd(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const CsvRecord& row = table.rows()[i];
        result.strain(i) = table.number(row, 0);
        result.stress(i) = table.number(row, 1);
    }
    const TensionLaw law{.name = "", .strain = result.strain, .tension = result.stress};
    if (const std::string problem = problem_of(law); !problem.empty()) {
        table.fail(table.rows().back(), "the table of stress over strain " + problem);
    }
    if (const double slope = law.steepest(); slope < softest || slope > stiffest) {
        table.fail(
            table.rows().back(),
            fmt::format("rises by {:.3g} Pa over strain at most, expected {:g} to {:g}: are its "
                        "stresses in Pa, and its strains without unit?",
                        slope, softest, stiffest));
    }
    return result;
}

}  // namespace taut
