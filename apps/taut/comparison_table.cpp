// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "comparison_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <vector>

namespace taut::app {
namespace {

constexpr const char* row_format =
    " {:>9}  {:<15}{:>9} {:>9} {:>8} {:>8} {:>8} {:>9} {:>9} {:>7}\n";

std::string head(const std::string& axis) {
    return fmt::format(row_format, axis, "", "MSE", "RMSE", "over", "MRSE", "form", "inside",
                       "training", "each") +
           fmt::format(row_format, "", "", "[m2]", "[mm]", "bound", "[%]", "[mm]", "95 % [%]",
                       "[s]", "[ms]");
}

std::string over(double factor) {
    constexpr double large = 1000.0;
    return factor < large ? fmt::format("{:.2f}", factor) : fmt::format("{:.1e}", factor);
}

std::string bound_line(const std::string& place, const std::optional<CramerRaoBound>& best) {
    if (!best) {
        return "";
    }
    return fmt::format(row_format, place, "Cramér-Rao", fmt::format("{:.3g}", best->mse),
                       fmt::format("{:.3g}", 1e3 * std::sqrt(best->mse)), "1", "", "", "", "", "");
}

std::string line(const std::string& place, const ComparisonRow& row) {
    const MethodResult& r = row.result;
    std::string text;
    if (r.identified() > 0) {
        const auto over_best =
            row.cramer_rao ? over(r.errors.mse / row.cramer_rao->mse) : std::string("-");
        const bool has_form = r.forms_not_converged < r.identified();
        text = fmt::format(row_format, place, r.name, fmt::format("{:.3g}", r.errors.mse),
                           fmt::format("{:.3g}", 1e3 * std::sqrt(r.errors.mse)), over_best,
                           fmt::format("{:.3g}", 100.0 * r.errors.mrse),
                           has_form ? fmt::format("{:.2g}", 1e3 * r.form_error.mean) : "-",
                           fmt::format("{:.1f}", 100.0 * r.coverage),
                           row.training_samples ? fmt::format("{:.2f}", r.training_seconds) : "-",
                           fmt::format("{:.0f}", 1e3 * r.seconds));
    }
    if (r.failed == r.surveys) {
        text += fmt::format(" {:>9}  {:<15}{}\n", place, r.name, r.first_failure);
    } else if (r.failed > 0) {
        text += fmt::format(" {:>9}  {:<15}failed on {} of {} surveys, not counted above: {}\n", "",
                            "", r.failed, r.surveys, r.first_failure);
    }
    if (r.forms_not_converged > 0) {
        text += fmt::format(
            " {:>9}  {:<15}{} predicted forms out of balance, not in the form "
            "error\n",
            "", "", r.forms_not_converged);
    }
    return text;
}

/// The rows of one axis, each value on it led by the Cramér-Rao bound.
std::string table(const Comparison& comparison, const std::string& axis,
                  const std::function<bool(const ComparisonRow&)>& is_on,
                  const std::function<double(const ComparisonRow&)>& value_of,
                  std::string_view unit = "") {
    std::vector<const ComparisonRow*> rows;
    for (const ComparisonRow& row : comparison.rows) {
        if (is_on(row)) {
            rows.push_back(&row);
        }
    }
    std::ranges::stable_sort(rows, {}, [&](const ComparisonRow* row) { return value_of(*row); });
    std::string text;
    std::string last;
    for (const ComparisonRow* row : rows) {
        const std::string place = fmt::format("{:.4g}{}", value_of(*row), unit);
        if (place != last) {
            text += bound_line(place, row->cramer_rao);
        }
        text += line(place == last || row->cramer_rao ? "" : place, *row);
        last = place;
    }
    return text.empty() ? "" : head(axis) + text;
}

}  // namespace

std::string comparison_table(const Comparison& comparison) {
    const ComparisonSettings& settings = comparison.settings;
    std::string text = fmt::format(
        "{} surveys of each kind ({}, seed {}), {} of them with slack edges; {} samples drawn, {} "
        "not converged\n",
        comparison.surveys, to_string(settings.prior), settings.seed, comparison.surveys_with_slack,
        comparison.samples, comparison.not_converged);
    const int training = settings.common_training();
    const auto is_common = [training](const ComparisonRow& row) {
        return row.training_samples.value_or(training) == training;
    };
    text += fmt::format("\nOver the noise [mm] of a coordinate, {} training samples\n", training);
    text += table(
        comparison, "noise",
        [&](const ComparisonRow& row) { return row.kind.hidden_part == 0.0 && is_common(row); },
        [](const ComparisonRow& row) { return 1e3 * row.kind.noise_std; });
    for (const double noise : settings.noises) {
        const std::string rows = table(
            comparison, "samples",
            [&](const ComparisonRow& row) {
                return row.kind == SurveyKind{.noise_std = noise} && row.training_samples &&
                       (noise == 0.0 || noise == settings.common_noise());
            },
            [](const ComparisonRow& row) { return *row.training_samples; });
        if (!rows.empty() && settings.training_samples.size() > 1) {
            text +=
                fmt::format("\nOver the training samples, noise {:.4g} mm\n{}", 1e3 * noise, rows);
        }
    }
    const std::string hidden = table(
        comparison, "hidden", [](const ComparisonRow& row) { return row.kind.hidden_part > 0.0; },
        [](const ComparisonRow& row) { return 100.0 * row.kind.hidden_part; }, " %");
    if (!hidden.empty()) {
        text += fmt::format("\nOver the hidden nodes, noise {:.4g} mm, {} training samples\n{}",
                            1e3 * settings.common_noise(), training, hidden);
    }
    if (!comparison.model_error_rows.empty()) {
        text += fmt::format(
            "\nOn nets with model errors, noise {:.4g} mm, {} training samples: {}\n{}",
            1e3 * settings.common_noise(), training, to_string(settings.uncertain), head("these"));
        std::string_view last;
        for (const ComparisonRow& row : comparison.model_error_rows) {
            const std::string_view place = to_string(row.model_errors);
            text += line(std::string(place == last ? "" : place), row);
            last = place;
        }
    }
    if (!comparison.epoch_rows.empty()) {
        text += fmt::format("\nOver the number of surveys used together, noise {:.4g} mm\n{}",
                            1e3 * settings.common_noise(), head("surveys"));
        for (const ComparisonRow& row : comparison.epoch_rows) {
            text += line(fmt::format("{}{}", row.epochs, row.is_turned ? " turned" : ""), row);
        }
    }
    text += fmt::format(
        "\nSeconds: sampling {:.2f}, training {:.2f}, identification {:.2f}, in all {:.2f}\n",
        comparison.seconds.sampling, comparison.seconds.training, comparison.seconds.identification,
        comparison.seconds.total);
    return text;
}

}  // namespace taut::app
