// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "study/evaluation.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
#include <numeric>
#include <stdexcept>

#include "identification/cramer_rao_bound.hpp"
#include "numerics/parallel.hpp"
#include "shared_work.hpp"
#include "study/error_sums.hpp"
#include "study/shared_evaluation.hpp"
#include "study/stopwatch.hpp"
#include "taut/numerical_error.hpp"

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
            status != IdentificationStatus::no_equilibrium) {  // which has lengths
            outcome.failure = to_string(status);
            outcome.identification.reset();
        }
    } catch (const NumericalError& error) {
        outcome.failure = error.what();
    } catch (const std::invalid_argument& error) {  // the trial is no valid survey of the net
        outcome.failure = error.what();
    }
    outcome.seconds = stopwatch.seconds();
    return outcome;
}

/// Tries the method on some of the trials.
std::vector<Outcome> attempt_all(const Method& method, const std::vector<Trial>& trials,
                                 const std::vector<size_t>& chosen, const Progress& progress) {
    std::vector<Outcome> outcomes(chosen.size());
    const Stopwatch preparing;
    // For all trials, whichever are chosen: work done at once for other trials rounds differently.
    const std::function<Identification(size_t)> identify =
        method.identify_each ? method.identify_each(trials)
                             : [&](size_t k) { return method.identify(trials[k]); };
    const double share =
        preparing.seconds() / static_cast<double>(std::max<size_t>(1, chosen.size()));
    std::mutex mutex;
    int done = 0;
    const auto run = [&](size_t i) {
        if (progress.stopped()) {
            throw Interrupted();
        }
        outcomes[i] = attempt(identify, chosen[i]);
        outcomes[i].seconds += share;
        const std::lock_guard lock(mutex);
        progress("identification", ++done, static_cast<int>(chosen.size()));
    };
    if (method.uses_all_threads) {
        for (size_t i = 0; i < chosen.size(); ++i) {
            run(i);
        }
    } else {
        parallel_for(size_t{0}, chosen.size(), run);
    }
    return outcomes;
}

/// One identification compared with the truth.
struct Judged {
    bool is_identified = false;
    std::string failure;
    double seconds = 0.0;
    Eigen::VectorXd estimate;     // of the length deviations
    int inside = 0;               // true ones in their interval
    bool is_balanced = false;     // the predicted form
    FormErrorSummary form_error;  // of it, where it is balanced
};

Judged judge(const CableNet& net, const Trial& trial, const Outcome& outcome) {
    Judged judged{.is_identified = outcome.identification.has_value(),
                  .failure = outcome.failure,
                  .seconds = outcome.seconds};
    if (!judged.is_identified) {
        return judged;
    }
    const Identification& identification = *outcome.identification;
    judged.estimate.resize(net.interior_edge_count());
    for (Eigen::Index i = 0; i < judged.estimate.size(); ++i) {
        const IdentifiedEdge& edge = identification.edges[i];
        judged.estimate(i) = edge.length_deviation;
        const bool is_inside =
            edge.lower <= trial.deviations(i) && trial.deviations(i) <= edge.upper;
        judged.inside += is_inside ? 1 : 0;
    }
    judged.is_balanced = identification.predicted.balanced();
    if (judged.is_balanced) {
        judged.form_error =
            summarise(node_distances(free_coordinates(net, trial.form),
                                     free_coordinates(net, identification.predicted.form)));
    }
    return judged;
}

/// Sums over edges and surveys.
struct Sums {
    double squared_errors_of_taut = 0.0;
    int taut = 0;
    int inside = 0;
};

/// Fills the numbers that need an identification.
void fill(MethodResult& result, const CableNet& net, const std::vector<Trial>& trials,
          const std::vector<Judged>& all) {
    const Eigen::Index m = net.interior_edge_count();
    Eigen::MatrixXd truth(m, result.identified());
    Eigen::MatrixXd estimate(m, result.identified());
    Sums sums;
    Eigen::Index column = 0;
    const auto balanced = static_cast<int>(std::ranges::count(all, true, &Judged::is_balanced));
    for (size_t k = 0; k < trials.size(); ++k) {
        if (!all[k].is_identified) {
            continue;
        }
        const Trial& trial = trials[k];
        for (Eigen::Index i = 0; i < m; ++i) {
            const double error = trial.deviations(i) - all[k].estimate(i);
            if (!trial.slack[i]) {
                sums.squared_errors_of_taut += error * error;
                ++sums.taut;
            }
        }
        sums.inside += all[k].inside;
        truth.col(column) = trial.deviations;
        estimate.col(column++) = all[k].estimate;
        if (all[k].is_balanced) {
            add_to_mean(result.form_error, all[k].form_error, balanced);
        }
    }
    result.errors = length_errors(truth, estimate);
    result.mse_of_taut = sums.taut > 0 ? sums.squared_errors_of_taut / sums.taut : 0.0;
    result.coverage = sums.inside / static_cast<double>(truth.size());
    result.forms_not_converged = result.identified() - balanced;
}

MethodResult result_of(const CableNet& net, const Method& method, const std::vector<Trial>& trials,
                       const std::vector<Judged>& all) {
    MethodResult result;
    result.name = method.name;
    result.surveys = static_cast<int>(trials.size());
    result.training_seconds = method.training_seconds;
    for (const Judged& judged : all) {
        result.seconds += judged.seconds / static_cast<double>(trials.size());
        if (!judged.is_identified) {
            ++result.failed;
            if (result.first_failure.empty()) {
                result.first_failure = judged.failure;
            }
        }
    }
    if (result.identified() > 0) {
        fill(result, net, trials, all);
    }
    return result;
}

std::vector<Judged> judge_all(const CableNet& net, const std::vector<Trial>& trials,
                              const std::vector<size_t>& chosen,
                              const std::vector<Outcome>& outcomes) {
    std::vector<Judged> judged;
    judged.reserve(chosen.size());
    for (size_t i = 0; i < chosen.size(); ++i) {
        judged.push_back(judge(net, trials[chosen[i]], outcomes[i]));
    }
    return judged;
}

template <typename Packing>
void pack(Packing& packing, Judged& judged) {
    auto& [is_identified, failure, seconds, estimate, inside, is_balanced, form_error] = judged;
    packing(is_identified, failure, seconds, estimate, inside, is_balanced, form_error);
}

}  // namespace

Evaluation evaluate(const CableNet& net, const Method& method, const std::vector<Trial>& trials,
                    const Progress& progress) {
    std::vector<size_t> all(trials.size());
    std::iota(all.begin(), all.end(), size_t{0});
    std::vector<Outcome> outcomes = attempt_all(method, trials, all, progress);
    Evaluation evaluation{
        .result = result_of(net, method, trials, judge_all(net, trials, all, outcomes)),
        .identifications = {}};
    for (Outcome& outcome : outcomes) {
        evaluation.identifications.push_back(std::move(outcome.identification));
    }
    return evaluation;
}

MethodResult evaluate_together(const CableNet& net, const Method& method,
                               const std::vector<Trial>& trials, const Progress& progress) {
    const std::vector<size_t> mine = share_of(trials.size());
    const std::vector<Outcome> outcomes = attempt_all(method, trials, mine, progress);
    return result_of(net, method, trials,
                     all_gather(trials.size(), judge_all(net, trials, mine, outcomes)));
}

std::optional<CramerRaoBound> cramer_rao_bound(const CableNet& net, const LengthPrior& prior,
                                               const std::vector<Trial>& trials) {
    const std::vector<size_t> mine = share_of(trials.size());
    std::vector<Eigen::VectorXd> of_trials(mine.size());
    try {
        parallel_for(size_t{0}, mine.size(), [&](size_t i) {
            const Trial& trial = trials[mine[i]];
            of_trials[i] = cramer_rao_variances(net, with_length_deviations(net, trial.deviations),
                                                trial.form, trial.survey, prior);
        });
    } catch (const NumericalError&) {
        of_trials.assign(mine.size(), Eigen::VectorXd());
    }
    of_trials = all_gather(trials.size(), std::move(of_trials));
    Eigen::MatrixXd variances(net.interior_edge_count(), static_cast<Eigen::Index>(trials.size()));
    for (Eigen::Index k = 0; k < variances.cols(); ++k) {
        if (of_trials[k].size() == 0) {
            return std::nullopt;
        }
        variances.col(k) = of_trials[k];
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
    return CramerRaoBound{.mse = variances.mean(),
                          .mse_of_taut = taut > 0 ? sum_of_taut / taut : 0.0};
}

}  // namespace taut
