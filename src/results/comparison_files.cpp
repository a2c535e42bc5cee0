// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/results/comparison_files.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "files/csv_field.hpp"
#include "results/document_parts.hpp"
#include "results/result_parts.hpp"

namespace taut {
namespace {

/// A number of the lengths, where some were identified.
std::optional<double> of_lengths(const ComparisonRow& row, double number) {
    return when(row.result.identified() > 0, number);
}

/// The best possible by any method, where it is known.
auto best(double CramerRaoBound::* number) {
    return [number](const ComparisonRow& row) {
        return row.cramer_rao ? std::optional(*row.cramer_rao.*number) : std::nullopt;
    };
}

}  // namespace

Description<ComparisonRow> describe(const ComparisonRow* /*type*/) {
    return Description<ComparisonRow>("comparison_row",
                                      "One method at one noise, training size and part of hidden "
                                      "nodes. Values that the method does not have are null.")
        .key("method", TAUT_VALUE(it.result.name))
        .key("noise", TAUT_VALUE(it.kind.noise_std), size, "Std of a surveyed coordinate [m].")
        .newer("hidden_fraction", TAUT_VALUE(std::optional(it.kind.hidden_part)), part)
        .newer("training_samples", &ComparisonRow::training_samples)
        .newer("surveys", TAUT_VALUE(std::optional(it.result.surveys)))
        .newer("failed", TAUT_VALUE(std::optional(it.result.failed)))
        .newer("first_failure", TAUT_VALUE(when(it.result.failed > 0, it.result.first_failure)))
        .newer("mse", TAUT_VALUE(of_lengths(it, it.result.errors.mse)), size)
        .newer("cramer_rao_mse", best(&CramerRaoBound::mse), size)
        .newer("mse_of_taut_edges", TAUT_VALUE(of_lengths(it, it.result.mse_of_taut)), size)
        .newer("cramer_rao_mse_of_taut_edges", best(&CramerRaoBound::mse_of_taut), size)
        .newer("mrse", TAUT_VALUE(of_lengths(it, it.result.errors.mrse)), size)
        .newer("form_error",
               TAUT_VALUE(when(it.result.forms_not_converged < it.result.identified(),
                               it.result.form_error.mean)),
               size)
        .newer("forms_not_converged", TAUT_VALUE(std::optional(it.result.forms_not_converged)))
        .newer("coverage", TAUT_VALUE(of_lengths(it, it.result.coverage)), part)
        .newer("training_seconds",
               TAUT_VALUE(when(it.training_samples.has_value(), it.result.training_seconds)), size)
        .newer("seconds", TAUT_VALUE(of_lengths(it, it.result.seconds)), size)
        .newer("model_errors", &ComparisonRow::model_errors,
               "Whether the surveyed nets differ from the design in more than lengths, and whether "
               "that uncertainty was given to the method.")
        .newer("epochs", &ComparisonRow::epochs,
               Rule(ResultJson{{"type", "integer"}, {"minimum", 1}}),
               "Surveys of each net used at once.")
        .newer("turned", &ComparisonRow::is_turned, "Whether edges were turned between.");
}

Description<Comparison> describe(const Comparison* /*type*/) {
    using All = Comparison;
    auto result = document<All>("comparison", "Result of taut compare.");
    result.key("net", &All::net)
        .newer("prior", TAUT_VALUE(it.settings.prior))
        .newer("seed", TAUT_VALUE(it.settings.seed))
        .newer("common_noise", TAUT_VALUE(it.settings.common_noise()), size)
        .newer("common_training_samples", TAUT_VALUE(std::optional(it.settings.common_training())))
        .newer_object("samples", Description<All>()
                                     .key("total", &All::samples)
                                     .key("not_converged", &All::not_converged)
                                     .key("surveyed", &All::surveys)
                                     .key("surveyed_with_slack", &All::surveys_with_slack))
        .newer_object("seconds", seconds_of<All>());
    return add_run(result)
        .newer("uncertain", TAUT_VALUE(it.settings.uncertain),
               R"(Besides the lengths: ["supports:1mm"].)")
        .key("rows", &All::rows, Rule::list_of(description_of<ComparisonRow>().rule()).not_empty())
        .newer("model_error_rows", &All::model_error_rows,
               "On nets that differ from the design in these.")
        .newer("epoch_rows", &All::epoch_rows, "With several surveys of each net at once.");
}

std::string comparison_to_json(const Comparison& comparison, const RunRecord& run) {
    return to_text(json_of(comparison, {.net = &comparison.net, .run = &run}));
}

std::string comparison_to_csv(const Comparison& comparison) {
    std::string csv;
    std::vector<ComparisonRow> all = comparison.rows;
    std::ranges::copy(comparison.model_error_rows, std::back_inserter(all));
    std::ranges::copy(comparison.epoch_rows, std::back_inserter(all));
    for (const ResultJson& row : json_of(all, {.net = &comparison.net})) {
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
