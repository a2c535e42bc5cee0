// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/method.hpp"

#include "identification/force_balance.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/processes.hpp"
#include "taut/identification/epochs.hpp"

namespace taut {

Method method_as_in_paper(const CableNet& net, const LengthModel& model) {
    return {.name = "gp_as_in_paper",
            .training_samples = model.training_count(),
            .needs_all_nodes = true,
            .uses_all_threads = true,
            .identify = [&net, &model](const Trial& trial) {
                return identify_as_in_paper(net, model, trial.survey);
            }};
}

Method method_by_processes(const CableNet& net, const LengthModel& model) {
    return {.name = "gp",
            .training_samples = model.training_count(),
            .uses_all_threads = true,
            .identify = [&net, &model](const Trial& trial) {
                return identify_by_processes(net, model, trial.survey);
            }};
}

Method method_by_force_balance(const CableNet& net, const LengthLaw& law) {
    return {
        .name = "balance", .needs_all_nodes = true, .identify = [&net, law](const Trial& trial) {
            return identify_by_force_balance(net, trial.survey, law);
        }};
}

Method method_by_maximum_a_posteriori(const CableNet& net, const LengthLaw& law,
                                      const std::vector<Unknown>& unknowns) {
    Told told(law);
    told.unknowns = unknowns;
    return {.name = "map", .identify = [&net, told](const Trial& trial) {
                return identify_by_maximum_a_posteriori(net, trial.survey, told);
            }};
}

Method method_by_epochs(const CableNet& net, const LengthLaw& law) {
    IdentifyOptions options;
    options.law = law;
    options.draws = 0;
    return {.name = "map", .identify = [&net, options](const Trial& trial) {
                return identify_epochs(net, trial.epochs, options);
            }};
}

}  // namespace taut
