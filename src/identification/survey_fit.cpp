// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/survey_fit.hpp"

#include <algorithm>
#include <utility>

#include "taut/statics/tensions.hpp"

namespace taut {

std::vector<bool> slack_by_form(const CableNet& net, const Guess& guess, const LengthLaw& law) {
    constexpr double reach = 3.0;
    const Eigen::VectorXd lengths = edge_lengths(net, guess.form);
    std::vector<bool> slack(static_cast<size_t>(net.edge_count()));
    for (int e = 0; e < net.edge_count(); ++e) {
        const bool is_adjustable = std::ranges::binary_search(net.adjustable_edges(), e);
        const double shortest =
            net.unstressed_lengths()(e) - (is_adjustable ? 0.0 : reach * law.std());
        slack[static_cast<size_t>(e)] = lengths(e) < shortest;
    }
    return slack;
}

GaussNewtonResult fit_to_survey(const CableNet& net, ConditionedStatics& statics,
                                const Knowledge& knowledge, const LengthLaw& law, Guess start,
                                double tolerance, int max_iterations) {
    GaussNewtonResult fit{.guess = std::move(start)};
    // Few rounds do: which edges the form shows as slack changes little with the fit.
    constexpr int most_rounds = 5;
    for (int round = 0; round < most_rounds; ++round) {
        statics.set_slack(slack_by_form(net, fit.guess, law));
        fit =
            fit_under_statics(statics, knowledge, std::move(fit.guess), tolerance, max_iterations);
        if (!fit.converged || slack_by_form(net, fit.guess, law) == statics.slack()) {
            break;
        }
    }
    return fit;
}

}  // namespace taut
