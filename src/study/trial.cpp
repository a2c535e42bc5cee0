// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/trial.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_set>

#include "taut/statics/tensions.hpp"
#include "taut/survey/simulation.hpp"

namespace taut {
namespace {

/// Supports are known, and no method of identification uses their targets.
std::vector<SurveyPoint> without_supports(std::vector<SurveyPoint> points, const CableNet& net) {
    std::unordered_set<std::string> names;
    for (const int node : net.supports()) {
        names.insert(net.node_id(node));
    }
    std::erase_if(points, [&names](const SurveyPoint& p) { return names.contains(p.id); });
    return points;
}

std::vector<bool> slack_interior_edges(const CableNet& net, const Eigen::VectorXd& deviations,
                                       const Points& form) {
    const std::vector<int> slack = slack_edges(net, with_length_deviations(net, deviations), form);
    std::vector<bool> result;
    for (const int edge : net.interior_edges()) {
        result.push_back(std::ranges::find(slack, edge) != slack.end());
    }
    return result;
}

}  // namespace

std::vector<Trial> simulate_trials(const CableNet& net, const DataSet& data,
                                   const std::vector<int>& samples, const SurveyKind& kind,
                                   std::uint64_t seed) {
    constexpr int sample_bits = 32;  // two seeds share no noise before so many samples
    std::vector<Trial> trials;
    for (const int sample : samples) {
        Trial trial{.deviations = data.length_deviations.col(sample),
                    .form = with_free_coordinates(
                        net, data.nominal_form + data.form_deviations.col(sample))};
        trial.slack = slack_interior_edges(net, trial.deviations, trial.form);
        const SurveySimulation simulation{
            .noise_std = kind.noise_std,
            .dropped_part = kind.hidden_part,
            .seed = (seed << sample_bits) + static_cast<std::uint64_t>(sample)};
        const std::vector<SurveyPoint> points =
            without_supports(simulate_survey(net, trial.form, simulation), net);
        try {
            trial.survey = match_to_nodes(net, points);
        } catch (const SurveyError&) {
            throw std::invalid_argument(fmt::format(
                "noise of {:.4g} m puts targets further from their nodes than edges are long",
                kind.noise_std));
        }
        trials.push_back(std::move(trial));
    }
    return trials;
}

}  // namespace taut
