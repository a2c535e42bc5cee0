// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/force_balance.hpp"

#include <fmt/core.h>

#include <array>
#include <stdexcept>

#include "estimation/observations.hpp"
#include "estimation/slack_set.hpp"
#include "identification/exact_balance.hpp"
#include "identification/outcome.hpp"

namespace taut {
namespace {

/// Bounds to the lengths where there is noise, in standard deviations of the law: the loosest with
/// which form and lengths are found. Without any, noise as large as the extension of the edges
/// makes some of them carry pressure, and the form fall apart. They are taken out of each edge's
/// posterior again.
constexpr std::array bounds{5.0, 2.0, 1.0};

}  // namespace

Identification identify_by_force_balance(const CableNet& net, const Survey& survey,
                                         const LengthLaw& law) {
    check_survey(net, survey);
    if (!survey.missing.empty() ||
        static_cast<int>(survey.surveyed.size()) != net.free_node_count()) {
        throw std::invalid_argument(
            fmt::format("the survey holds {} of {} free nodes, expected all for the force balance",
                        survey.surveyed.size(), net.free_node_count()));
    }
    if (is_exact_and_complete(net, survey)) {
        Identification result = identify_by_exact_balance(net, survey, law);
        result.method = "balance";
        return result;
    }
    const std::vector<bool> none_left_out(net.node_count(), false);
    const Points noise = reckoned_noise(net, survey);
    ConditionedStatics statics(net);
    Identification result{.method = "balance"};
    constexpr int max_iterations = 15;
    constexpr double tolerance_in_noise = 1e-3;
    const double tolerance = tolerance_in_noise * noise(Eigen::all, survey.surveyed).minCoeff();
    Knowledge knowledge;
    GaussNewtonResult fit;
    for (const double bound : bounds) {
        knowledge = knowledge_of(net, survey, noise, none_left_out, bound * law.std());
        fit = fit_to_survey(net, statics, knowledge, law, {net.nodes(), knowledge.mean},
                            slack_by_survey(net, knowledge, law), tolerance, max_iterations);
        if (fit.converged) {
            break;
        }
    }
    if (!fit.converged) {
        result.status = IdentificationStatus::iteration_limit;
    }
    statics.invert();
    complete(result, net, survey, law, likelihoods(net, statics, knowledge, fit.guess),
             fit.guess.form);
    return result;
}

}  // namespace taut
