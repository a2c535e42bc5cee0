// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "report/figures.hpp"
#include "report/log_chart.hpp"
#include "report/number_text.hpp"

namespace taut::report {
namespace {

using Row = ComparisonResult::Row;
using Rows = std::vector<Row>;

/// An error [mm], or nothing that a logarithmic axis could show.
std::optional<double> root_in_mm(const std::optional<double>& mse) {
    return mse && *mse > 0.0 ? std::optional(1e3 * std::sqrt(*mse)) : std::nullopt;
}

/// The first row of each place counts.
template <class Place, class Value>
std::map<double, double> curve(const Rows& rows, Place place, Value mse) {
    std::map<double, double> result;
    for (const Row& row : rows) {
        const std::optional<double> x = place(row);
        const std::optional<double> y = root_in_mm(mse(row));
        if (x && y) {
            result.emplace(*x, *y);
        }
    }
    return result;
}

/// Methods in the order of the file.
std::vector<std::string> methods_of(const Rows& rows) {
    std::vector<std::string> methods;
    for (const Row& row : rows) {
        if (std::ranges::find(methods, row.method) == methods.end()) {
            methods.push_back(row.method);
        }
    }
    return methods;
}

/// A curve for each method, then the best possible.
/// @param all methods, each of which keeps its style where it has no curve
template <class Place>
std::vector<LogSeries> series_over(const std::vector<std::string>& all, const Rows& rows,
                                   Place place) {
    std::vector<LogSeries> series;
    for (size_t i = 0; i < all.size(); ++i) {
        Rows own;
        std::ranges::copy_if(rows, std::back_inserter(own),
                             [&](const Row& row) { return row.method == all[i]; });
        series.push_back({.name = all[i],
                          .style = fmt::format("series{}", i % 6),
                          .points = curve(own, place, [](const Row& r) { return r.mse; })});
    }
    series.push_back(
        {.name = "best possible", .style = "best", .points = curve(rows, place, [](const Row& r) {
                                                       return r.best_possible_mse;
                                                   })});
    std::erase_if(series, [](const LogSeries& s) { return s.points.empty(); });
    return series;
}

/// The rows with as few nodes hidden as there are.
Rows least_hidden(const Rows& rows) {
    const double least =
        std::ranges::min(rows, {}, [](const Row& r) { return r.hidden_fraction; }).hidden_fraction;
    Rows result;
    std::ranges::copy_if(rows, std::back_inserter(result),
                         [least](const Row& r) { return r.hidden_fraction <= least; });
    return result;
}

/// Of the values that a row can have, the one with the most different partners: the one that the
/// others were held at. Of several the one that is preferred most.
template <class Preference>
double most_varied(const std::map<double, std::set<double>>& partners, Preference preference) {
    return std::ranges::max_element(partners, {},
                                    [&](const auto& entry) {
                                        return std::tuple(entry.second.size(),
                                                          preference(entry.first));
                                    })
        ->first;
}

/// The rows of one noise and one number of training samples for which most shares of hidden nodes
/// were tried; none where that is but one.
Rows hidden_varied(const Rows& rows) {
    std::map<double, std::set<double>> hidden_of_noise;
    for (const Row& row : rows) {
        hidden_of_noise[row.noise].insert(row.hidden_fraction);
    }
    const double noise = most_varied(hidden_of_noise, [](double value) { return -value; });
    if (hidden_of_noise[noise].size() < 2) {
        return {};
    }
    std::map<double, std::set<double>> hidden_of_training;
    for (const Row& row : rows) {
        if (row.noise == noise && row.training_samples) {
            hidden_of_training[*row.training_samples].insert(row.hidden_fraction);
        }
    }
    std::optional<double> training;
    if (!hidden_of_training.empty()) {
        training = most_varied(hidden_of_training, [](double samples) { return samples; });
    }
    Rows result;
    std::ranges::copy_if(rows, std::back_inserter(result), [&](const Row& row) {
        return row.noise == noise && (!row.training_samples || row.training_samples == training);
    });
    const auto differs = [&](const Row& row) {
        return row.hidden_fraction != result.front().hidden_fraction;
    };
    return std::ranges::any_of(result, differs) ? result : Rows();
}

/// A method that learns from no samples is as good with any number: a level line.
Rows levelled(const Rows& rows, const std::set<double>& places) {
    Rows result;
    for (Row row : rows) {
        if (row.training_samples) {
            result.push_back(row);
            continue;
        }
        for (const double place : {*places.begin(), *places.rbegin()}) {
            row.training_samples = place;
            result.push_back(row);
        }
    }
    return result;
}

}  // namespace

Figure comparison_figure(const ComparisonResult& comparison) {
    const Rows rows = least_hidden(comparison.rows);
    const std::vector<std::string> methods = methods_of(comparison.rows);
    std::map<double, std::set<double>> noises_of_training;
    std::map<double, std::set<double>> trainings_of_noise;
    for (const Row& row : rows) {
        if (row.training_samples) {
            noises_of_training[*row.training_samples].insert(row.noise);
            trainings_of_noise[row.noise].insert(*row.training_samples);
        }
    }
    Figure figure{.heading = "Error of each method"};
    const auto add = [&figure](std::optional<Drawing> drawn) {
        if (drawn) {
            figure.drawings.push_back(*std::move(drawn));
        }
    };
    LogChart chart{.name = "error_over_noise",
                   .title = "Error of each method over the noise of the survey",
                   .x_label = "noise of a surveyed coordinate [mm]",
                   .y_label = "root mean squared error",
                   .y_unit = "mm"};
    const auto place_of_noise = [](const Row& row) { return std::optional(1e3 * row.noise); };
    if (noises_of_training.empty()) {
        add(log_chart(chart, series_over(methods, rows, place_of_noise)));
    } else {
        const double training =
            most_varied(noises_of_training, [](double samples) { return samples; });
        chart.x_label += fmt::format(", {} training samples", short_number(training));
        Rows at_training;
        std::ranges::copy_if(rows, std::back_inserter(at_training), [training](const Row& row) {
            return row.training_samples.value_or(training) == training;
        });
        add(log_chart(chart, series_over(methods, at_training, place_of_noise)));

        // Surveys without noise do not exist; of the others the lowest.
        const double noise = most_varied(
            trainings_of_noise, [](double value) { return std::tuple(value > 0.0, -value); });
        Rows at_noise;
        std::ranges::copy_if(rows, std::back_inserter(at_noise),
                             [noise](const Row& row) { return row.noise == noise; });
        chart.name = "error_over_training";
        chart.title = "Error of each method over the number of training samples";
        chart.x_label =
            fmt::format("training samples, at a noise of {} mm", short_number(1e3 * noise));
        add(log_chart(chart, series_over(methods, levelled(at_noise, trainings_of_noise[noise]),
                                         [](const Row& row) { return row.training_samples; })));
    }
    if (const Rows over_hidden = hidden_varied(comparison.rows); !over_hidden.empty()) {
        chart.name = "error_over_hidden";
        chart.title = "Error of each method over the share of hidden nodes";
        chart.x_label = fmt::format("nodes not surveyed [%], at a noise of {} mm",
                                    short_number(1e3 * over_hidden.front().noise));
        chart.x_is_linear = true;
        add(log_chart(chart, series_over(methods, over_hidden, [](const Row& row) {
                          return std::optional(100.0 * row.hidden_fraction);
                      })));
    }
    figure.caption =
        "Root of the mean squared error of the identified lengths. The best possible is the "
        "posterior standard deviation of the problem linearised at the truth: to first order, no "
        "method can do better in the mean. Level lines over the number of training samples: "
        "methods that learn from none.";
    return figure;
}

}  // namespace taut::report
