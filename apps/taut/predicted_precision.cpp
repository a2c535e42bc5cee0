// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "predicted_precision.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "command.hpp"
#include "net_summary.hpp"

namespace taut::app {

PredictedSurvey precision_of(const CableNet& net, const Equilibrium& nominal,
                             const SurveyOptions& options, const LengthPrior& prior,
                             const Forces& forces, const UncertainOptions& uncertain,
                             const SuggestionOptions& suggestions, const ForceOptions& noise,
                             const std::string& net_file, bool with_notes) {
    if (options.noise == estimated_noise) {
        throw std::invalid_argument(
            "--noise estimate is for identify: before a survey there is nothing to estimate it "
            "from");
    }
    Survey survey = read_planned_survey(net, options.survey, options.read_options());
    print_survey_notes(options, survey, with_notes);
    if (!nominal.balanced()) {
        throw NumericalFailure(
            fmt::format("{}: no equilibrium was found: {}", net_file, equilibrium_text(nominal)));
    }
    const std::vector<UncertainParameter> given = uncertain.given(net, net_file);
    PredictedPrecision lengths = with_survey_of(options.survey, [&] {
        return predicted_precision(
            net, nominal.form, survey, prior,
            {.forces = forces, .uncertain = given, .assume_site = uncertain.assume_site()});
    });
    std::optional<MeasurementSuggestions> suggested;
    if (!suggestions.quantity.empty()) {
        SuggestOptions further = suggestions.read(noise);
        further.assume_site = uncertain.assume_site();
        suggested =
            suggested_measurements(net, nominal.form, survey, prior, forces, given, further);
    }
    return {.survey = std::move(survey),
            .prior = prior,
            .lengths = std::move(lengths),
            .suggestions = std::move(suggested)};
}

nlohmann::ordered_json to_json(const CableNet& net, const PredictedSurvey& precision,
                               const std::string& file) {
    const PredictedPrecision& lengths = precision.lengths;
    nlohmann::ordered_json edges = nlohmann::ordered_json::array();
    for (const EdgePrecision& e : lengths.edges) {
        edges.push_back({{"edge", e.edge},
                         {"id", net.edge_id(e.edge)},
                         {"std", e.std_dev},
                         {"ratio", e.std_dev / lengths.prior_std},
                         {"status", to_string(e.status)}});
    }
    nlohmann::ordered_json forces = nlohmann::ordered_json::array();
    for (const TensionPrecision& force : lengths.force_candidates) {
        forces.push_back({{"edge", force.edge},
                          {"id", net.edge_id(force.edge)},
                          {"tension", force.tension},
                          {"tension_std", force.std_dev},
                          {"mean_tension_std", force.mean_std_if_measured}});
    }
    nlohmann::ordered_json document{
        {"file", file},
        {"used", precision.survey.surveyed.size()},
        {"missing", precision.survey.missing.size()},
        {"missing_nodes", precision.survey.missing},
        {"prior", to_string(precision.prior)},
        {"prior_std", lengths.prior_std},
        {"rms_std", lengths.rms_std()},
        {"determined", lengths.count(EdgeStatus::determined)},
        {"weakly_determined", lengths.count(EdgeStatus::weakly_determined)},
        {"not_determined", lengths.count(EdgeStatus::not_determined)},
        {"slack", lengths.count(EdgeStatus::slack)},
        {"warnings", precision.survey.warnings},
        {"edges", edges},
        {"mean_tension", {{"mean", lengths.mean_tension}, {"std", lengths.mean_tension_std}}},
        {"forces", forces}};
    if (precision.suggestions) {
        document["suggestions"] = to_json(net, *precision.suggestions);
    }
    return document;
}

std::string precision_text(const CableNet& net, const PredictedSurvey& precision,
                           const SurveyOptions& options) {
    const PredictedPrecision& lengths = precision.lengths;
    std::string text = survey_text(net, options, precision.survey);
    text += fmt::format(
        "predicted precision, prior {}, to first order at the equilibrium:\n"
        "  edges: {} determined, {} weakly determined, {} not determined, {} slack\n"
        "  std of a length deviation: {:.3g} mm RMS over the interior edges, {:.3g} mm by the "
        "prior\n"
        "  {:<12}{:>10}{:>12}  status\n",
        to_string(precision.prior), lengths.count(EdgeStatus::determined),
        lengths.count(EdgeStatus::weakly_determined), lengths.count(EdgeStatus::not_determined),
        lengths.count(EdgeStatus::slack), 1e3 * lengths.rms_std(), 1e3 * lengths.prior_std,
        "worst edges", "std [mm]", "of prior");
    std::vector<EdgePrecision> worst = lengths.edges;
    std::ranges::sort(worst, {},
                      [](const EdgePrecision& e) { return std::pair(-e.std_dev, e.edge); });
    constexpr size_t shown = 8;
    for (size_t i = 0; i < std::min(shown, worst.size()); ++i) {
        const EdgePrecision& e = worst[i];
        text +=
            fmt::format("  {:<12}{:>10.3f}{:>10.1f} %  {}\n", net.edge_id(e.edge), 1e3 * e.std_dev,
                        100.0 * e.std_dev / lengths.prior_std, status_text(e.status));
    }
    if (precision.suggestions) {
        return text + suggestions_text(net, *precision.suggestions);
    }
    text += fmt::format(
        "  mean tension: std {:.3g} % of its {:.4g} kN\n"
        "  with one more force measurement of 2 %, at the edges where it helps most:\n"
        "  {:<12}{:>14}{:>20}\n",
        100.0 * lengths.mean_tension_std / lengths.mean_tension, 1e-3 * lengths.mean_tension,
        "edge", "tension [kN]", "std of the mean [%]");
    constexpr size_t best = 5;
    for (size_t i = 0; i < std::min(best, lengths.force_candidates.size()); ++i) {
        const TensionPrecision& force = lengths.force_candidates[i];
        text += fmt::format("  {:<12}{:>14.4g}{:>20.3g}\n", net.edge_id(force.edge),
                            1e-3 * force.tension,
                            100.0 * force.mean_std_if_measured / lengths.mean_tension);
    }
    return text;
}

}  // namespace taut::app
