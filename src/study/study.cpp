// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/study.hpp"

#include <fmt/core.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>

namespace taut {
namespace {

class Stopwatch {
public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

DataSet draw_samples(const Sampler& sampler, int count, const StudyProgress& progress,
                     const std::stop_token& stop) {
    DataSet data = sampler.empty();
    const int block = std::max(16, count / 50);
    while (data.size() < count) {
        progress("sampling", data.size(), count);
        if (!sampler.extend(data, std::min(count, data.size() + block), stop)) {
            throw Interrupted();
        }
    }
    progress("sampling", count, count);
    return data;
}

LengthModel train_on(const CableNet& net, const DataSet& data, const std::vector<int>& samples,
                     const StudyProgress& progress, const std::stop_token& stop) {
    TrainingSettings settings = TrainingSettings::as_in_paper();
    settings.fit.progress = [&](int made) {
        if (stop.stop_requested()) {
            throw Interrupted();
        }
        progress("training", made, settings.fit.max_spectra);
    };
    return train(net, data, samples, settings);
}

double coverage(const Eigen::MatrixXd& truth, const LengthEstimates& estimates) {
    const auto inside =
        (truth - estimates.mean).array().abs() <= half_interval_95 * estimates.std.array();
    return static_cast<double>(inside.count()) / static_cast<double>(truth.size());
}

void add(FormErrorSummary& sum, const FormErrorSummary& summary, double weight) {
    sum.max += weight * summary.max;
    sum.min += weight * summary.min;
    sum.mean += weight * summary.mean;
    sum.rmse += weight * summary.rmse;
}

/// The errors of the nominal and of the identified form at the free nodes of every validation
/// sample. Fills what the study tells of them.
void compare_forms(Study& study, const Points& nominal_form, const std::stop_token& stop) {
    const CableNet& net = study.net;
    const auto count = static_cast<Eigen::Index>(study.validation.size());
    Eigen::MatrixXd nominal(net.free_node_count(), count);
    Eigen::MatrixXd identified(net.free_node_count(), count);
    std::vector<char> converged(study.validation.size(), 0);
    tbb::enumerable_thread_specific<EquilibriumSolver> solvers(
        [&] { return EquilibriumSolver(net); });
    tbb::parallel_for(Eigen::Index{0}, count, [&](Eigen::Index k) {
        if (stop.stop_requested()) {
            return;
        }
        const Eigen::VectorXd true_form =
            study.data.nominal_form +
            study.data.form_deviations.col(study.validation[static_cast<size_t>(k)]);
        const Equilibrium predicted =
            solvers.local().solve(with_length_deviations(net, study.estimates.mean.col(k)),
                                  with_free_coordinates(net, true_form));
        converged[static_cast<size_t>(k)] = static_cast<char>(predicted.balanced());
        nominal.col(k) = node_distances(true_form, free_coordinates(net, nominal_form));
        identified.col(k) = node_distances(true_form, free_coordinates(net, predicted.form));
        if (k == 0) {
            study.identified_form = predicted.form;
        }
    });
    if (stop.stop_requested()) {
        throw Interrupted();
    }
    const auto usable = std::ranges::count(converged, 1);
    study.forms_not_converged = static_cast<int>(count - usable);
    if (converged.front() == 0) {
        throw std::runtime_error("the first validation sample's identified form did not converge");
    }
    for (Eigen::Index k = 0; k < count; ++k) {
        if (converged[static_cast<size_t>(k)] == 1) {
            const double weight = 1.0 / static_cast<double>(usable);
            add(study.mean_form_errors.nominal, summarise(nominal.col(k)), weight);
            add(study.mean_form_errors.identified, summarise(identified.col(k)), weight);
        }
    }
    study.nominal_form_error = nominal.col(0);
    study.identified_form_error = identified.col(0);
    study.form_errors = {.nominal = summarise(nominal.col(0)),
                         .identified = summarise(identified.col(0))};
}

}  // namespace

void StudySettings::check() const {
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

Study run_study(const CableNet& net, const StudySettings& settings, const StudyProgress& progress,
                const std::stop_token& stop) {
    settings.check();
    const StudyProgress tell = progress ? progress : [](std::string_view, int, int) {};
    const Stopwatch total;
    Study study{.net = net, .settings = settings};

    const Stopwatch sampling;
    const Sampler sampler(net, settings.law, settings.seed);
    study.data = draw_samples(sampler, settings.samples, tell, stop);
    study.seconds.sampling = sampling.seconds();

    const int first_validation = settings.samples - settings.validation;
    const std::vector<int> training_samples = study.data.converged_in(0, first_validation);
    study.validation = study.data.converged_in(first_validation, settings.samples);
    if (training_samples.size() < 2 || study.validation.empty()) {
        throw std::runtime_error(
            fmt::format("only {} training and {} validation samples found their equilibrium",
                        training_samples.size(), study.validation.size()));
    }
    const Stopwatch training;
    study.model = train_on(net, study.data, training_samples, tell, stop);
    study.seconds.training = training.seconds();

    tell("identification", 0, 1);
    const Stopwatch identification;
    const Eigen::MatrixXd truth = study.data.length_deviations(Eigen::all, study.validation);
    study.estimates =
        estimate_lengths(net, study.model, study.data.form_deviations(Eigen::all, study.validation));
    study.gp_as_in_paper = {.name = "gp_as_in_paper",
                            .errors = length_errors(truth, study.estimates.mean),
                            .coverage = coverage(truth, study.estimates)};
    compare_forms(study, sampler.nominal().form, stop);
    study.seconds.identification = identification.seconds();
    tell("identification", 1, 1);
    study.seconds.total = total.seconds();
    return study;
}

}  // namespace taut
