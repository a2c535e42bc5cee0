// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/study.hpp"

#include <fmt/core.h>

#include <optional>
#include <stdexcept>

#include "identification/train_together.hpp"
#include "study/error_sums.hpp"
#include "study/stopwatch.hpp"
#include "taut/numerical_error.hpp"

namespace taut {
namespace {

/// Mean and std of all identifications, none of which failed.
LengthEstimates estimates_of(const std::vector<std::optional<Identification>>& identifications,
                             Eigen::Index edges) {
    const auto count = static_cast<Eigen::Index>(identifications.size());
    LengthEstimates estimates{.mean = Eigen::MatrixXd(edges, count),
                              .std_dev = Eigen::MatrixXd(edges, count)};
    for (Eigen::Index k = 0; k < count; ++k) {
        for (Eigen::Index i = 0; i < edges; ++i) {
            const IdentifiedEdge& edge = identifications[k]->edges[i];
            estimates.mean(i, k) = edge.length_deviation;
            estimates.std_dev(i, k) = edge.std_dev;
        }
    }
    return estimates;
}

/// Fills the members that are of the paper's method alone.
void fill_as_in_paper(Study& study, const Evaluation& evaluation, const std::vector<Trial>& trials,
                      const Points& nominal_form) {
    const MethodResult& result = evaluation.result;
    if (result.failed > 0) {
        throw NumericalError(fmt::format("{} of {} validation samples were not identified: {}",
                                         result.failed, result.surveys, result.first_failure));
    }
    const Equilibrium& first = evaluation.identifications.front()->predicted;
    if (!first.balanced()) {
        throw NumericalError("the first validation sample's identified form did not converge");
    }
    const CableNet& net = study.net;
    study.estimates = estimates_of(evaluation.identifications, net.interior_edge_count());
    const Eigen::VectorXd nominal = free_coordinates(net, nominal_form);
    const Eigen::VectorXd truth = free_coordinates(net, trials.front().form);
    study.identified_form = first.form;
    study.nominal_form_error = node_distances(truth, nominal);
    study.identified_form_error = node_distances(truth, free_coordinates(net, first.form));
    study.form_errors = {.nominal = summarise(study.nominal_form_error),
                         .identified = summarise(study.identified_form_error)};
    study.mean_form_errors.identified = result.form_error;
    for (size_t k = 0; k < trials.size(); ++k) {
        if (evaluation.identifications[k]->predicted.balanced()) {
            add_to_mean(study.mean_form_errors.nominal,
                        summarise(node_distances(free_coordinates(net, trials[k].form), nominal)),
                        result.surveys - result.forms_not_converged);
        }
    }
}

/// Tries all methods on exact surveys of the validation samples.
void try_methods(Study& study, const LengthModel& best, const Points& nominal_form,
                 const Progress& progress) {
    const CableNet& net = study.net;
    const std::vector<Trial> trials =
        simulate_trials(net, study.data, study.validation, {}, study.settings.seed);
    std::vector methods{method_as_in_paper(net, study.model), method_by_processes(net, best),
                        method_by_force_balance(net, study.settings.prior),
                        method_by_maximum_a_posteriori(net, study.settings.prior)};
    for (Method* const trained : {&methods[0], &methods[1]}) {
        trained->training_seconds = 0.5 * study.seconds.training;
    }
    const auto count = static_cast<int>(methods.size());
    for (int m = 0; m < count; ++m) {
        const Evaluation evaluation = evaluate(net, methods[m], trials, progress.part(m, count));
        if (study.methods.empty()) {
            fill_as_in_paper(study, evaluation, trials, nominal_form);
        }
        study.methods.push_back(evaluation.result);
    }
}

}  // namespace

void StudySettings::check() const {
    prior.check();
    if (samples < 3) {
        throw std::invalid_argument(fmt::format("{} samples, expected at least 3", samples));
    }
    if (validation < 1 || validation > samples - 2) {
        throw std::invalid_argument(
            fmt::format("{} validation samples of {}, expected at least 1, and at least 2 left to "
                        "train on",
                        validation, samples));
    }
}

Study run_study(const CableNet& net, const StudySettings& settings, const Progress& progress) {
    settings.check();
    const Stopwatch total;
    Study study{.net = net, .settings = settings};

    const Stopwatch sampling;
    const Sampler sampler(net, settings.prior, settings.seed);
    study.data = draw_samples(sampler, settings.samples, progress);
    study.seconds.sampling = sampling.seconds();

    const int first_validation = settings.samples - settings.validation;
    const std::vector<int> training_samples = study.data.converged_in(0, first_validation);
    study.validation = study.data.converged_in(first_validation, settings.samples);
    if (training_samples.size() < 2 || study.validation.empty()) {
        throw NumericalError(
            fmt::format("only {} training and {} validation samples found their equilibrium",
                        training_samples.size(), study.validation.size()));
    }
    const Stopwatch training;
    std::vector<LengthModel> models = train_together(net, study.data, training_samples,
                                                     {TrainingSettings::paper(), {}}, progress);
    study.model = std::move(models[0]);
    study.seconds.training = training.seconds();

    const Stopwatch identification;
    try_methods(study, models[1], sampler.nominal().form, progress);
    study.seconds.identification = identification.seconds();
    study.seconds.total = total.seconds();
    return study;
}

}  // namespace taut
