// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/survey_prospect.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "taut/estimation/length_posterior.hpp"
#include "taut/identification/best_possible.hpp"
#include "taut/statics/tensions.hpp"

namespace taut {
namespace {

/// The status that a taut edge most probably gets: over deviations from the law and errors of the
/// survey, at evenly spaced quantiles of both.
/// @param std of the length deviation after the survey, to first order [m]
EdgeStatus probable_status(const LengthLaw& law, double std) {
    LengthLikelihood likelihood = without_prior(0.0, law.std(), 0.0, std);
    if (!std::isfinite(likelihood.std)) {
        return EdgeStatus::unobserved;
    }
    constexpr int count = 10;
    const LengthLaw errors{LengthLaw::Kind::normal, likelihood.std};
    int unobserved = 0;
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < count; ++k) {
            likelihood.mean = law.draw((i + 0.5) / count) + errors.draw((k + 0.5) / count);
            const EdgeStatus status = status_of(law, posterior_of(law, likelihood));
            unobserved += status == EdgeStatus::unobserved ? 1 : 0;
        }
    }
    return 2 * unobserved > count * count ? EdgeStatus::unobserved : EdgeStatus::identified;
}

}  // namespace

int SurveyProspect::count(EdgeStatus status) const {
    return static_cast<int>(std::ranges::count(edges, status, &EdgeProspect::status));
}

double SurveyProspect::rms_std() const {
    double sum = 0.0;
    for (const EdgeProspect& e : edges) {
        sum += e.std * e.std;
    }
    return edges.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(edges.size()));
}

SurveyProspect survey_prospect(const CableNet& net, const Eigen::Ref<const Points>& form,
                               const Survey& survey, const LengthLaw& law) {
    if (net.interior_edge_count() == 0) {
        throw std::invalid_argument(
            "the net has no interior edge: every unstressed length is known and set");
    }
    check_survey(net, survey);
    if (survey.is_exact()) {
        require_whole(net, survey, "all, or their noise (--noise, or sx, sy, sz in the file)");
    }
    const Eigen::VectorXd& lengths = net.unstressed_lengths();
    const Eigen::VectorXd variances = best_possible_variances(net, lengths, form, survey, law);
    const std::vector<int> slack = slack_edges(net, lengths, form);
    SurveyProspect result{.prior_std = law.std(), .edges = {}};
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const int edge = net.interior_edges()[i];
        const double std = std::sqrt(variances(i));
        const bool is_slack = std::ranges::binary_search(slack, edge);
        result.edges.push_back(
            {.edge = edge,
             .std = std,
             .status = is_slack ? EdgeStatus::slack : probable_status(law, std)});
    }
    return result;
}

}  // namespace taut
