// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "suggestions.hpp"

#include <fast_float/fast_float.h>
#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

#include "command.hpp"
#include "taut/net/units.hpp"

namespace taut::app {
namespace {

std::string place_of(const CableNet& net, const SuggestedMeasurement& one) {
    return one.edge >= 0 ? fmt::format("edge {}", net.edge_id(one.edge))
                         : fmt::format("node {}", net.node_id(one.node));
}

std::string expected_text(const SuggestedMeasurement& one) {
    switch (one.kind) {
        case MeasurementKind::load_cell:
            return fmt::format("{:.3g} kN", 1e-3 * one.expected);
        case MeasurementKind::frequency:
            return fmt::format("{:.3g} Hz", one.expected);
        case MeasurementKind::sag:
            return fmt::format("{:.3g} mm", 1e3 * one.expected);
        case MeasurementKind::load:
            return one.expected < 1e3 ? fmt::format("{:.3g} N down", one.expected)
                                      : fmt::format("{:.4g} kN down", 1e-3 * one.expected);
        case MeasurementKind::target:
            break;
    }
    return "-";
}

}  // namespace

SuggestOptions SuggestionOptions::read(const ForceOptions& forces) const {
    SuggestOptions result{.quantity = parse_sought_quantity(quantity),
                          .frequency_std = frequency_part(forces),
                          .free_length_std = parse_length(forces.free_length_std)};
    for (const std::string& text : costs) {
        const size_t colon = text.find(':');
        const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
        double cost = 0.0;
        const auto [end, error] =
            fast_float::from_chars(number.data(), number.data() + number.size(), cost);
        if (error != std::errc() || end != number.data() + number.size() || !(cost > 0.0) ||
            !std::isfinite(cost)) {
            throw std::invalid_argument(
                fmt::format("--cost is '{}', expected KIND:NUMBER, such as load:5", text));
        }
        result.costs[parse_measurement_kind(text.substr(0, colon))] = cost;
    }
    if (!load.empty()) {
        result.load = parse_force(load);
        if (!(result.load > 0.0)) {
            throw std::invalid_argument(
                fmt::format("--load is '{}', expected a force above 0", load));
        }
    }
    return result;
}

std::vector<CLI::Option*> add_suggestion_options(CLI::App& command, SuggestionOptions& options,
                                                 ForceOptions& forces) {
    CLI::Option* const suggest =
        command
            .add_option("--suggest", options.quantity,
                        "Suggest which measurements to make besides the survey, the best first: "
                        "those that lower the standard deviation of the mean-tension, of the "
                        "worst-tension or of the form most")
            ->expected(0, 1)
            ->type_name("[TEXT]")
            ->default_str("mean-tension");
    CLI::Option* const cost =
        command
            .add_option("--cost", options.costs,
                        "Cost of one measurement, KIND:NUMBER of load-cell, frequency, sag, "
                        "target or load (default: 1 each). May be repeated")
            ->allow_extra_args(false)
            ->needs(suggest);
    CLI::Option* const load =
        command
            .add_option("--load", options.load,
                        "Load that could be hung on a node, such as 250N (default: a twentieth of "
                        "the mean tension)")
            ->needs(suggest);
    std::vector<CLI::Option*> all{suggest, cost, load};
    for (CLI::Option* option : add_frequency_noise_options(command, forces)) {
        all.push_back(option->needs(suggest));
    }
    return all;
}

nlohmann::ordered_json to_json(const CableNet& net, const MeasurementSuggestions& suggestions) {
    nlohmann::ordered_json steps = nlohmann::ordered_json::array();
    for (const SuggestedMeasurement& one : suggestions.steps) {
        nlohmann::ordered_json step{{"kind", to_string(one.kind)}};
        if (one.edge >= 0) {
            step["edge"] = one.edge;
            step["id"] = net.edge_id(one.edge);
        } else {
            step["node"] = one.node;
            step["id"] = net.node_id(one.node);
        }
        if (one.expected > 0.0) {
            step["expected"] = one.expected;
        }
        if (one.std_dev > 0.0) {
            step["measurement_std"] = one.std_dev;
        }
        step["remaining_std"] = one.remaining_std;
        step["total_cost"] = one.total_cost;
        steps.push_back(std::move(step));
    }
    return {{"quantity", to_string(suggestions.quantity)},
            {"mean_tension", suggestions.mean_tension},
            {"std", suggestions.std_dev},
            {"steps", steps},
            {"left_out", suggestions.left_out}};
}

std::string suggestions_text(const CableNet& net, const MeasurementSuggestions& suggestions) {
    const bool is_form = suggestions.quantity == SoughtQuantity::form;
    const char* const name = is_form ? "form"
                             : suggestions.quantity == SoughtQuantity::mean_tension
                                 ? "mean tension"
                                 : "least known tension";
    const auto std_text = [&](double std_dev) {
        return is_form ? fmt::format("{:.3g} mm", 1e3 * std_dev)
                       : fmt::format("{:.3g} % of {:.4g} kN",
                                     100.0 * std_dev / suggestions.mean_tension,
                                     1e-3 * suggestions.mean_tension);
    };
    std::string text = fmt::format("{}: std {} after the survey{}\n", name,
                                   std_text(suggestions.std_dev), is_form ? ", RMS" : "");
    if (suggestions.steps.empty()) {
        text += "  no further measurement by itself lowers it by 1 %\n";
    } else {
        text += fmt::format(
            "  measure next, each with those above it:\n  {:<12}{:<16}{:>14}{:>16}{:>10}\n", "kind",
            "at", "expected", is_form ? "std left [mm]" : "std left [%]", "cost");
    }
    for (const SuggestedMeasurement& one : suggestions.steps) {
        text += fmt::format("  {:<12}{:<16}{:>14}{:>16.3g}{:>10.4g}\n", to_string(one.kind),
                            place_of(net, one), expected_text(one),
                            is_form ? 1e3 * one.remaining_std
                                    : 100.0 * one.remaining_std / suggestions.mean_tension,
                            one.total_cost);
    }
    if (!suggestions.steps.empty() && std::ssize(suggestions.steps) < SuggestOptions{}.most) {
        text += "  no other one lowers it by 1 %\n";
    }
    for (const std::string& why : suggestions.left_out) {
        text += fmt::format("  not suggested: {}\n", why);
    }
    return text;
}

}  // namespace taut::app
