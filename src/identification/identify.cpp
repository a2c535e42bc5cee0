// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/identify.hpp"

#include <string>
#include <vector>

#include "identification/assumptions.hpp"
#include "identification/identify_options.hpp"
#include "identification/mean_bias.hpp"
#include "identification/net_balance.hpp"
#include "identification/noise_estimate.hpp"
#include "identification/over_priors.hpp"
#include "identification/under_prior.hpp"
#include "numerics/memory_budget.hpp"
#include "sampling/uncertain_widths.hpp"
#include "taut/identification/model.hpp"

namespace taut {

Identification identify(const CableNet& net, const Survey& survey, const IdentifyOptions& options,
                        const Progress& progress) {
    const LengthPrior prior =
        options.prior.value_or(options.model != nullptr ? options.model->prior : LengthPrior());
    const auto [method, reason] = checked_method(net, survey, prior, options);
    const MemoryCharge of_draws(
        method == IdentificationMethod::map
            ? charge_numbers(numbers_of_draw(net) * draws_wanted(net, options))
            : MemoryCharge());
    std::vector<UncertainParameter> assumed = with_slips(net, options.uncertain);
    IdentifyOptions used = options;
    used.uncertain = assumed;
    const double noise_scale =
        options.estimate_noise ? noise_scale_of(net, survey, prior, used, progress) : 1.0;
    const Survey scaled = with_noise_times(survey, noise_scale);
    if (options.assume_site.value_or(true) && method == IdentificationMethod::map &&
        survey.is_noisy()) {
        assumed = with_site_assumptions(net, options.uncertain, measured_by(options.forces));
        used.uncertain = with_uncertain_widths(assumed, options.uncertain);
    }
    const bool is_exact = options.prior_exact || options.model != nullptr || !survey.is_noisy();
    const AssumedPrior exactly{.prior = prior, .around = {}, .wanted = wanted_by(net, options)};
    Identification result = is_exact
                                ? identify_under_prior(method, net, scaled, exactly, used, progress)
                                : identify_over_priors(method, net, scaled, used, progress);
    if (is_exact) {
        result.prior = exact_prior(prior);
    }
    if (survey.is_noisy()) {
        take_out_mean_bias(result, net, scaled, used.uncertain, progress);
    }
    if (result.status == IdentificationStatus::survey_does_not_fit) {
        const std::string text = net_balance_text(net);
        result.message += (text.empty() ? "" : " ") + text;
    }
    result.noise_scale = noise_scale;
    result.prior_was_given = options.prior.has_value();
    result.method = to_string(method);
    result.method_reason = reason;
    name_assumed_widths(result, assumed, options.uncertain);
    result.assumptions = assumptions_of(assumed, options.uncertain, result);
    result.trust = trust_of(net, scaled, result);
    return result;
}

}  // namespace taut
