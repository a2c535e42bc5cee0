// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "study/method.hpp"

#include <optional>
#include <utility>

#include "identification/force_balance.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/processes.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/length_estimates.hpp"

namespace taut {
namespace {

/// Estimates of a model's processes at the surveyed forms of the trials whose surveys they take as
/// they are. All are predicted at once, so that the large spectra are read once.
std::vector<std::optional<LengthEstimates>> estimates_of(const CableNet& net,
                                                         const LengthModel& model,
                                                         const std::vector<Trial>& trials) {
    std::vector<size_t> asked;
    for (size_t k = 0; k < trials.size(); ++k) {
        const Survey& survey = trials[k].survey;
        if (survey.is_whole() && (model.as_in_paper || !survey.is_noisy())) {
            asked.push_back(k);
        }
    }
    Eigen::MatrixXd forms(model.nominal_form.size(), std::ssize(asked));
    for (size_t i = 0; i < asked.size(); ++i) {
        forms.col(static_cast<Eigen::Index>(i)) =
            free_coordinates(net, trials[asked[i]].survey.form) - model.nominal_form;
    }
    const LengthEstimates all = estimate_lengths(net, model, forms);
    std::vector<std::optional<LengthEstimates>> result(trials.size());
    for (size_t i = 0; i < asked.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        result[asked[i]] = {.mean = all.mean.col(column), .std_dev = all.std_dev.col(column)};
    }
    return result;
}

using IdentifyByModel = Identification (*)(const CableNet&, const LengthModel&, const Survey&,
                                           const LengthEstimates*);

Method method_by_model(std::string name, bool needs_all_nodes, const CableNet& net,
                       const LengthModel& model, IdentifyByModel identify) {
    return {
        .name = std::move(name),
        .training_samples = model.training_count(),
        .needs_all_nodes = needs_all_nodes,
        .identify = [&net, &model, identify](
                        const Trial& trial) { return identify(net, model, trial.survey, nullptr); },
        .identify_each =
            [&net, &model, identify](const std::vector<Trial>& trials) {
                return [&net, &model, &trials, identify,
                        estimates = estimates_of(net, model, trials)](size_t k) {
                    return identify(net, model, trials[k].survey,
                                    estimates[k] ? &*estimates[k] : nullptr);
                };
            }};
}

}  // namespace

Method method_as_in_paper(const CableNet& net, const LengthModel& model) {
    return method_by_model("gp_as_in_paper", true, net, model, identify_as_in_paper);
}

Method method_by_processes(const CableNet& net, const LengthModel& model) {
    return method_by_model("gp", false, net, model, identify_by_processes);
}

Method method_by_force_balance(const CableNet& net, const LengthPrior& prior) {
    return {
        .name = "balance", .needs_all_nodes = true, .identify = [&net, prior](const Trial& trial) {
            return identify_by_force_balance(net, trial.survey, prior);
        }};
}

Method method_by_maximum_a_posteriori(const CableNet& net, const LengthPrior& prior,
                                      const std::vector<UncertainParameter>& uncertain) {
    const Given given(prior, uncertain);
    return {.name = "map", .identify = [&net, given](const Trial& trial) {
                return identify_by_maximum_a_posteriori(net, trial.survey, given);
            }};
}

Method method_by_epochs(const CableNet& net, const LengthPrior& prior) {
    IdentifyOptions options;
    options.prior = prior;
    options.prior_exact = true;
    options.assume_site = false;
    options.draws = 0;
    return {.name = "map", .identify = [&net, options](const Trial& trial) {
                return identify_epochs(net, trial.epochs, options);
            }};
}

}  // namespace taut
