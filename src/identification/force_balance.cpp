// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/force_balance.hpp"

#include <array>

#include "identification/completion.hpp"
#include "identification/exact_balance.hpp"
#include "identification/maximum_a_posteriori.hpp"

namespace taut {
namespace {

/// Widths of the prior where there is noise: the widest with which form and lengths are found.
/// Without any, noise as large as the extension of the edges makes some of them carry pressure, and
/// the form fall apart. The prior is taken out of each edge's posterior again.
constexpr std::array prior_widths{5.0, 2.0, 1.0};

/// A width that needs more is too wide.
constexpr int max_iterations = 15;

}  // namespace

Identification identify_by_force_balance(const CableNet& net, const Survey& survey,
                                         const LengthPrior& prior) {
    check_survey(net, survey);
    require_whole(net, survey, "all for the force balance");
    Identification result;
    if (survey.is_exact()) {
        result = identify_by_exact_balance(net, survey, prior);
    } else {
        const PriorKnowledge knowledge(net, prior);
        for (const double width : prior_widths) {
            const SurveyFit fit = fit_survey(
                net, survey, knowledge, {.max_iterations = max_iterations, .prior_width = width});
            if (fit.converged || width == prior_widths.back()) {
                result = identification_of(net, net, survey, prior, fit.knowledge, fit, fit.at,
                                           fit.observations);
                predict_form(result, net, survey, fit.at.iterate.form);
                break;
            }
        }
    }
    result.method = "balance";
    return result;
}

}  // namespace taut
