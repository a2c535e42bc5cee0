// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "study/trial.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_set>

#include "numerics/random_numbers.hpp"
#include "taut/statics/equilibrium.hpp"
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

Survey survey_of_kind(const CableNet& net, const Points& form, const SurveyKind& kind,
                      std::uint64_t seed) {
    const SurveySimulation simulation{
        .noise_std = kind.noise_std, .dropped_part = kind.hidden_part, .seed = seed};
    const std::vector<SurveyPoint> points =
        without_supports(simulate_survey(net, form, simulation), net);
    try {
        return match_to_nodes(net, points);
    } catch (const SurveyError&) {
        throw std::invalid_argument(fmt::format(
            "noise of {:.4g} m puts targets further from their nodes than edges are long",
            kind.noise_std));
    }
}

/// Mixes in the upper half of the seed, which `shifted` loses.
std::uint64_t with_upper_half(std::uint64_t shifted, std::uint64_t seed) {
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15ULL;
    return shifted ^ ((seed >> 32U) * odd);
}

}  // namespace

std::vector<Trial> simulate_trials(const CableNet& net, const DataSet& data,
                                   const std::vector<int>& samples, const SurveyKind& kind,
                                   std::uint64_t seed) {
    constexpr int sample_bits = 32;  // two seeds share no noise in the first 2^32 samples
    std::vector<Trial> trials;
    for (const int sample : samples) {
        Trial trial{.deviations = data.length_deviations.col(sample),
                    .form = with_free_coordinates(
                        net, data.nominal_form + data.form_deviations.col(sample))};
        trial.slack = slack_interior_edges(net, trial.deviations, trial.form);
        trial.survey = survey_of_kind(
            net, trial.form, kind,
            with_upper_half((seed << sample_bits) + static_cast<std::uint64_t>(sample), seed));
        trials.push_back(std::move(trial));
    }
    return trials;
}

std::vector<Trial> surveyed_again(const CableNet& net, std::vector<Trial> trials,
                                  const SurveyKind& kind, bool is_turned, std::uint64_t seed) {
    constexpr double longest = 5e-3;  // [m]
    constexpr double most = 0.05;     // of the edge
    constexpr int trial_bits = 32;
    for (size_t k = 0; k < trials.size(); ++k) {
        Trial& trial = trials[k];
        if (trial.epochs.empty()) {
            trial.epochs.push_back({.survey = trial.survey, .turned = {}});
        }
        // A seed of its own, so that no two surveys share noise or strokes.
        const std::uint64_t own =
            with_upper_half(((seed + 1) << trial_bits) * (trial.epochs.size() + 1) + k, seed);
        RandomNumbers random(own, 0);
        Epoch epoch;
        for (const int edge : is_turned ? net.adjustable_edges() : std::vector<int>()) {
            const double reach = std::min(longest, most * net.unstressed_lengths()(edge));
            epoch.turned.push_back(
                {.edge = edge, .stroke = reach * (2.0 * random.uniform() - 1.0), .std_dev = 0.0});
        }
        std::vector<std::vector<EdgeTurned>> steps;
        steps.reserve(trial.epochs.size() + 1);
        for (const Epoch& before : trial.epochs) {
            steps.push_back(before.turned);
        }
        steps.push_back(epoch.turned);
        const CableNet turned = turned_net(net, all_turned(steps));
        const Equilibrium equilibrium = EquilibriumSolver(turned).solve(
            with_length_deviations(turned, trial.deviations), trial.form);
        if (!equilibrium.balanced()) {
            throw std::invalid_argument("a turned net finds no equilibrium");
        }
        trial.form = equilibrium.form;
        trial.slack = slack_interior_edges(turned, trial.deviations, trial.form);
        epoch.survey = trial.survey = survey_of_kind(net, trial.form, kind, own);
        trial.epochs.push_back(std::move(epoch));
    }
    return trials;
}

}  // namespace taut
