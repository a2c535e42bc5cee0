// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/slack_marks.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace taut {
namespace {

/// Whether the survey does not contradict the marks of slack and taut edges: whether the fit with
/// them costs no more, beyond chance, than the fit without.
bool is_believable(const SurveyFit& with, const SurveyFit& without, const Forces& seen) {
    constexpr double by_chance = 20.0;    // a normal error of 4.5 standard deviations
    constexpr double a_slack_edge = 9.0;  // may be this far from the mean of its prior
    // An edge kept taut may carry pressure in the fit, which costs nothing.
    constexpr double surely = 4.0;  // standard deviations
    const Eigen::VectorXd tensions = with.at.model().tensions(with.at.iterate);
    const Eigen::VectorXd& variances = with.at.covariance.tensions;
    const bool has_pressure = std::ranges::any_of(seen.taut, [&](int edge) {
        return tensions(edge) < -surely * std::sqrt(std::max(0.0, variances(edge)));
    });
    return !has_pressure && with.cost <= without.cost + by_chance +
                                             a_slack_edge * static_cast<double>(seen.slack.size());
}

/// Reports the marked edges that the fit without marks contradicts; where there are none, all.
void set_contradicted_marks(MarkedFit& result, const LinearisedFit& without, const Forces& seen) {
    constexpr double surely = 3.0;  // standard deviations
    const Eigen::VectorXd tensions = without.model().tensions(without.iterate);
    const Eigen::VectorXd stds = without.covariance.tensions.cwiseMax(0.0).cwiseSqrt();
    std::ranges::copy_if(seen.taut, std::back_inserter(result.contradicted_taut), [&](int edge) {
        return without.model().slack[edge] || tensions(edge) < -surely * stds(edge);
    });
    std::ranges::copy_if(seen.slack, std::back_inserter(result.contradicted_slack),
                         [&](int edge) { return tensions(edge) > surely * stds(edge); });
    if (result.contradicted_taut.empty() && result.contradicted_slack.empty()) {
        result.contradicted_taut = seen.taut;
        result.contradicted_slack = seen.slack;
    }
}

}  // namespace

MarkedFit fit_with_marks(const CableNet& net, const Survey& survey, const PriorKnowledge& knowledge,
                         const SurveyFitSettings& settings) {
    const Forces& seen = knowledge.forces;
    MarkedFit result{.fit = fit_survey(net, survey, knowledge, settings),
                     .contradicted_taut = {},
                     .contradicted_slack = {}};
    if (seen.taut.empty() && seen.slack.empty()) {
        return result;
    }
    PriorKnowledge unseen = knowledge;
    unseen.forces.taut.clear();
    unseen.forces.slack.clear();
    SurveyFit without = fit_survey(net, survey, unseen, settings);
    if (!is_believable(result.fit, without, seen)) {
        set_contradicted_marks(result, without.at, seen);
        result.fit = std::move(without);
    }
    return result;
}

}  // namespace taut
