// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/comparison_files.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "files/csv_field.hpp"
#include "results/result_parts.hpp"
#include "taut/version.hpp"

namespace taut {
namespace {

ResultJson row_json(const ComparisonRow& row) {
    const MethodResult& result = row.result;
    const bool any = result.identified() > 0;
    const auto number = [](bool is_there, double value) {
        return is_there ? ResultJson(value) : ResultJson();
    };
    const auto best = row.best_possible.value_or(CramerRaoBound{});
    const bool has_best = row.best_possible.has_value();
    return {{"method", result.name},
            {"noise", row.kind.noise_std},
            {"hidden_fraction", row.kind.hidden_part},
            {"training_samples", or_null(row.training_samples)},
            {"surveys", result.surveys},
            {"failed", result.failed},
            {"first_failure", result.failed > 0 ? ResultJson(result.first_failure) : ResultJson()},
            {"mse", number(any, result.errors.mse)},
            {"best_possible_mse", number(has_best, best.mse)},
            {"mse_of_taut_edges", number(any, result.mse_of_taut)},
            {"best_possible_mse_of_taut_edges", number(has_best, best.mse_of_taut)},
            {"mrse", number(any, result.errors.mrse)},
            {"form_error", number(any && result.forms_not_converged < result.identified(),
                                  result.form_error.mean)},
            {"forms_not_converged", result.forms_not_converged},
            {"coverage", number(any, result.coverage)},
            {"training_seconds", number(row.training_samples.has_value(), result.training_seconds)},
            {"seconds", number(any, result.seconds)},
            {"model_errors", to_string(row.model_errors)},
            {"epochs", row.epochs},
            {"turned", row.is_turned}};
}

ResultJson rows_json(const std::vector<ComparisonRow>& all) {
    ResultJson rows = ResultJson::array();
    for (const ComparisonRow& row : all) {
        rows.push_back(row_json(row));
    }
    return rows;
}

}  // namespace

std::string comparison_to_json(const Comparison& comparison, const RunRecord& run) {
    const ComparisonSettings& settings = comparison.settings;
    ResultJson document{{"format", "taut-comparison"},
                        {"version", 2},
                        {"program", "taut " + std::string(version())},
                        {"net", counts_json(comparison.net)},
                        {"prior", settings.prior.to_string()},
                        {"seed", settings.seed},
                        {"common_noise", settings.common_noise()},
                        {"common_training_samples", settings.common_training()},
                        {"samples",
                         {{"total", comparison.samples},
                          {"not_converged", comparison.not_converged},
                          {"surveyed", comparison.surveys},
                          {"surveyed_with_slack", comparison.surveys_with_slack}}},
                        {"seconds",
                         {{"sampling", comparison.seconds.sampling},
                          {"training", comparison.seconds.training},
                          {"identification", comparison.seconds.identification},
                          {"total", comparison.seconds.total}}}};
    add_run(document, run);
    document["uncertain"] = ResultJson::array();
    for (const UncertainParameter& parameter : settings.uncertain) {
        document["uncertain"].push_back(parameter.to_string());
    }
    document["rows"] = rows_json(comparison.rows);
    document["model_error_rows"] = rows_json(comparison.model_error_rows);
    document["epoch_rows"] = rows_json(comparison.epoch_rows);
    return to_text(document);
}

std::string comparison_to_csv(const Comparison& comparison) {
    std::string csv;
    std::vector<ComparisonRow> all = comparison.rows;
    std::ranges::copy(comparison.model_error_rows, std::back_inserter(all));
    std::ranges::copy(comparison.epoch_rows, std::back_inserter(all));
    for (const ResultJson& row : rows_json(all)) {
        const auto add = [&](const auto& text) {
            const char* separator = "";
            for (const auto& [key, value] : row.items()) {
                csv += separator;
                csv += text(key, value);
                separator = ",";
            }
            csv += '\n';
        };
        if (csv.empty()) {
            add([](const std::string& key, const ResultJson&) { return key; });
        }
        add([](const std::string&, const ResultJson& value) {
            return value.is_null()     ? std::string()
                   : value.is_string() ? csv_field(value.get<std::string>())
                                       : value.dump();
        });
    }
    return csv;
}

}  // namespace taut
