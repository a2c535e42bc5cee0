// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/maximum_a_posteriori.hpp"

#include "estimation/length_likelihoods.hpp"
#include "identification/completion.hpp"
#include "identification/exact_balance.hpp"

namespace taut {

Identification identify_by_maximum_a_posteriori(const CableNet& net, const Survey& survey,
                                                const LengthLaw& law,
                                                const SurveyFitSettings& settings) {
    check_survey(net, survey);
    Identification result;
    if (survey.is_exact() && survey.is_whole()) {
        result = identify_by_exact_balance(net, survey, law);
    } else {
        SurveyFit fit(net, survey, law, settings);  // (map), (slack-set), (snooping)
        result = identification_of(net, survey, law, fit, fit.run());
    }
    result.method = "map";
    return result;
}

Identification identification_of(const CableNet& net, const Survey& survey, const LengthLaw& law,
                                 const SurveyFit& fit, const GaussNewtonResult& fitted) {
    Identification result;
    if (!fitted.converged) {
        result.status = IdentificationStatus::iteration_limit;
        result.message = "found no lengths that settle: iteration limit";
    }
    tell_snooping(result, survey, fit.snooping(), fit.contradicts_too_many());
    complete(result, net, survey, law,
             length_likelihoods(net, fit.statics(), fit.observations(), fitted.iterate),
             fitted.iterate.form);  // (covariance), (likelihood), (posterior)
    return result;
}

}  // namespace taut
