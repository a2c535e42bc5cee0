// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/method.hpp"

#include <memory>

#include "identification/force_balance.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/processes.hpp"

namespace taut {

Method method_as_in_paper(const CableNet& net, const LengthModel& model) {
    return {.name = "gp_as_in_paper",
            .training_samples = model.training_count(),
            .needs_all_nodes = true,
            .uses_all_threads = true,
            .identify = [&net, &model](const Survey& survey) {
                return identify_as_in_paper(net, model, survey);
            }};
}

Method method_by_processes(const CableNet& net, const LengthModel& model) {
    return {.name = "gp",
            .training_samples = model.training_count(),
            .uses_all_threads = true,
            .identify = [&net, &model,
                         before = std::make_shared<FormDistribution>()](const Survey& survey) {
                if (before->mean.size() == 0) {
                    *before = form_before_survey(net, model);
                }
                return identify_by_processes(net, model, survey, &*before);
            }};
}

Method method_by_force_balance(const CableNet& net, const LengthLaw& law) {
    return {
        .name = "balance", .needs_all_nodes = true, .identify = [&net, law](const Survey& survey) {
            return identify_by_force_balance(net, survey, law);
        }};
}

Method method_by_maximum_a_posteriori(const CableNet& net, const LengthLaw& law,
                                      const std::vector<Unknown>& unknowns) {
    Told told(law);
    told.unknowns = unknowns;
    return {.name = "map", .identify = [&net, told](const Survey& survey) {
                return identify_by_maximum_a_posteriori(net, survey, told);
            }};
}

}  // namespace taut
