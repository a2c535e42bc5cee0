// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/evaluation.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <stdexcept>

#include "study/stopwatch.hpp"
#include "taut/identification/best_possible.hpp"

namespace taut {
namespace {

/// One identification, or why there is none.
struct Outcome {
    std::optional<Identification> identification;
    std::string failure;
    double seconds = 0.0;
};

Outcome attempt(const std::function<Identification(size_t)>& identify, size_t k) {
    const Stopwatch stopwatch;
    Outcome outcome;
    try {
        outcome.identification = identify(k);
        const IdentificationStatus status = outcome.identification->status;
        if (status != IdentificationStatus::converged &&
            status != IdentificationStatus::no_equilibrium) {  // that one has lengths
            outcome.failure = to_string(status);
            outcome.identification.reset();
        }
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        outcome.failure = error.what();
    }
    outcome.seconds = stopwatch.seconds();
    return outcome;
}

std::vector<Outcome> attempt_all(const Method& method, const std::vector<Trial>& trials,
                                 const Progress& progress) {
    std::vector<Outcome> outcomes(trials.size());
    const Stopwatch preparing;
    const std::function<Identification(size_t)> identify =
        method.identify_each ? method.identify_each(trials)
                             : [&](size_t k) { return method.identify(trials[k]); };
    const double share =
        preparing.seconds() / static_cast<double>(std::max<size_t>(1, trials.size()));
    std::mutex mutex;
    int done = 0;
    const auto run = [&](size_t k) {
        if (progress.stopped()) {
            throw Interrupted();
        }
        outcomes[k] = attempt(identify, k);
        outcomes[k].seconds += share;
        const std::lock_guard lock(mutex);
        progress("identification", ++done, static_cast<int>(trials.size()));
    };
    if (method.uses_all_threads) {
        for (size_t k = 0; k < trials.size(); ++k) {
            run(k);
        }
    } else {
        tbb::parallel_for(size_t{0}, trials.size(), run);
    }
    return outcomes;
}

/// Sums over the edges and surveys of a mean.
struct Sums {
    double squared_errors_of_taut = 0.0;
    int taut = 0;
    int inside = 0;
};

/// Fills all numbers that need an identification.
void fill(MethodResult& result, const CableNet& net, const std::vector<Trial>& trials,
          const std::vector<std::optional<Identification>>& identifications) {
    const Eigen::Index m = net.interior_edge_count();
    Eigen::MatrixXd truth(m, result.identified());
    Eigen::MatrixXd estimate(m, result.identified());
    Sums sums;
    Eigen::Index column = 0;
    const auto balanced =
        static_cast<int>(std::ranges::count_if(identifications, [](const auto& identification) {
            return identification && identification->predicted.balanced();
        }));
    for (size_t k = 0; k < trials.size(); ++k) {
        if (!identifications[k]) {
            continue;
        }
        const Trial& trial = trials[k];
        for (Eigen::Index i = 0; i < m; ++i) {
            const IdentifiedEdge& edge = identifications[k]->edges[i];
            const double error = trial.deviations(i) - edge.length_deviation;
            estimate(i, column) = edge.length_deviation;
            const bool is_inside =
                edge.lower <= trial.deviations(i) && trial.deviations(i) <= edge.upper;
            sums.inside += is_inside ? 1 : 0;
            if (!trial.slack[i]) {
                sums.squared_errors_of_taut += error * error;
                ++sums.taut;
            }
        }
        truth.col(column++) = trial.deviations;
        if (identifications[k]->predicted.balanced()) {
            add_to_mean(result.form_error,
                        summarise(node_distances(
                            free_coordinates(net, trial.form),
                            free_coordinates(net, identifications[k]->predicted.form))),
                        balanced);
        }
    }
    result.errors = length_errors(truth, estimate);
    result.mse_of_taut = sums.taut > 0 ? sums.squared_errors_of_taut / sums.taut : 0.0;
    result.coverage = sums.inside / static_cast<double>(truth.size());
    result.forms_not_converged = result.identified() - balanced;
}

}  // namespace

Evaluation evaluate(const CableNet& net, const Method& method, const std::vector<Trial>& trials,
                    const Progress& progress) {
    Evaluation evaluation;
    MethodResult& result = evaluation.result;
    result.name = method.name;
    result.surveys = static_cast<int>(trials.size());
    result.training_seconds = method.training_seconds;
    for (Outcome& outcome : attempt_all(method, trials, progress)) {
        result.seconds += outcome.seconds / static_cast<double>(trials.size());
        if (!outcome.identification) {
            ++result.failed;
            if (result.first_failure.empty()) {
                result.first_failure = outcome.failure;
            }
        }
        evaluation.identifications.push_back(std::move(outcome.identification));
    }
    if (result.identified() > 0) {
        fill(result, net, trials, evaluation.identifications);
    }
    return evaluation;
}

std::optional<BestPossible> best_possible(const CableNet& net, const LengthLaw& law,
                                          const std::vector<Trial>& trials) {
    Eigen::MatrixXd variances(net.interior_edge_count(), static_cast<Eigen::Index>(trials.size()));
    try {
        tbb::parallel_for(Eigen::Index{0}, variances.cols(), [&](Eigen::Index k) {
            const Trial& trial = trials[k];
            variances.col(k) = best_possible_variances(
                net, with_length_deviations(net, trial.deviations), trial.form, trial.survey, law);
        });
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
    double sum_of_taut = 0.0;
    int taut = 0;
    for (Eigen::Index k = 0; k < variances.cols(); ++k) {
        for (Eigen::Index i = 0; i < variances.rows(); ++i) {
            if (!trials[k].slack[i]) {
                sum_of_taut += variances(i, k);
                ++taut;
            }
        }
    }
    return BestPossible{.mse = variances.mean(),
                        .mse_of_taut = taut > 0 ? sum_of_taut / taut : 0.0};
}

}  // namespace taut
