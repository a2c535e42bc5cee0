// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "identification/form_prior.hpp"
#include "sampling/uncertain_widths.hpp"
#include "study/shared_evaluation.hpp"
#include "study/stopwatch.hpp"
#include "taut/numerical_error.hpp"
#include "taut/sampling/sampler.hpp"

namespace taut {
namespace {

template <class T>
void sort_once(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Which methods are tried on surveys of one kind.
struct Cell {
    SurveyKind kind;
    int training_samples = 0;
    bool only_trained = false;  ///< the methods without training were tried already
};

/// The cells in the order of the rows.
std::vector<Cell> cells_of(const ComparisonSettings& settings) {
    std::vector<Cell> cells;
    cells.reserve(settings.noises.size());
    const int training = settings.common_training();
    for (const double noise : settings.noises) {
        cells.push_back({.kind = {.noise_std = noise}, .training_samples = training});
    }
    for (const double noise : settings.noises) {
        if (noise != 0.0 && noise != settings.common_noise()) {
            continue;
        }
        for (const int count : settings.training_samples) {
            if (count != training) {
                cells.push_back({.kind = {.noise_std = noise},
                                 .training_samples = count,
                                 .only_trained = true});
            }
        }
    }
    for (const double hidden : settings.hidden_parts) {
        if (hidden > 0.0) {
            cells.push_back({.kind = {.noise_std = settings.common_noise(), .hidden_part = hidden},
                             .training_samples = training});
        }
    }
    return cells;
}

/// Number of evaluations of a method on a kind of surveys.
int evaluation_count(const std::vector<Cell>& cells) {
    int count = 0;
    for (const Cell& cell : cells) {
        const int trained = 2;
        const int untrained = cell.only_trained ? 0 : 2;
        // With hidden nodes only one of the trained and one of the other methods can be tried.
        const bool takes_all = cell.kind.hidden_part == 0.0;
        count += (trained + untrained) / (takes_all ? 1 : 2);
    }
    return count;
}

/// Fills the rows of a comparison.
class Comparing {
public:
    Comparing(Comparison& comparison, const DataSet& data, std::vector<int> surveyed,
              const Progress& progress)
        : m_comparison(comparison),
          m_data(data),
          m_surveyed(std::move(surveyed)),
          m_cells(cells_of(comparison.settings)),
          m_progress(progress) {
        m_rows.resize(m_cells.size());
    }

    /// One number of training samples after the other, so that only two models are in memory.
    void run() {
        for (const int count : m_comparison.settings.training_samples) {
            run_with(count);
        }
        for (std::vector<ComparisonRow>& rows : m_rows) {
            std::ranges::move(rows, std::back_inserter(m_comparison.rows));
        }
    }

private:
    void run_with(int count) {
        const std::vector<int> samples = m_data.converged_in(0, count);
        if (samples.size() < 2) {
            throw NumericalError(fmt::format(
                "only {} of {} training samples found their equilibrium", samples.size(), count));
        }
        const Stopwatch paper_training;
        const LengthModel paper = train_next(samples, TrainingSettings::paper());
        const double paper_seconds = paper_training.seconds();
        const Stopwatch best_training;
        LengthModel best = train_next(samples, {});
        make_form_prior(m_comparison.net, best);
        const double best_seconds = best_training.seconds();
        m_comparison.seconds.training += paper_seconds + best_seconds;

        const CableNet& net = m_comparison.net;
        const LengthPrior& prior = m_comparison.settings.prior;
        std::vector methods{method_as_in_paper(net, paper), method_by_processes(net, best),
                            method_by_force_balance(net, prior),
                            method_by_maximum_a_posteriori(net, prior)};
        methods[0].training_seconds = paper_seconds;
        methods[1].training_seconds = best_seconds;
        const Stopwatch identification;
        for (size_t c = 0; c < m_cells.size(); ++c) {
            if (m_cells[c].training_samples == count) {
                m_rows[c] = rows_of(m_cells[c], methods);
            }
        }
        m_comparison.seconds.identification += identification.seconds();
        if (count == m_comparison.settings.common_training() &&
            !m_comparison.settings.uncertain.empty()) {
            run_with_model_errors(count, methods);
        }
    }

    /// On nets that differ in more than lengths: the methods as they are, then those that take the
    /// uncertain parameters.
    void run_with_model_errors(int count, const std::vector<Method>& not_given) {
        const CableNet& net = m_comparison.net;
        const ComparisonSettings& settings = m_comparison.settings;
        const Stopwatch sampling;
        const Sampler sampler(net, settings.prior, settings.seed, settings.uncertain);
        const DataSet data = draw_samples(sampler, count + settings.surveys, m_progress);
        m_comparison.seconds.sampling += sampling.seconds();
        const Stopwatch training;
        LengthModel model = train_model(net, data, data.converged_in(0, count), {}, m_progress);
        make_form_prior(net, model);
        const double training_seconds = training.seconds();
        m_comparison.seconds.training += training_seconds;
        std::vector given{method_by_processes(net, model),
                          method_by_maximum_a_posteriori(net, settings.prior, settings.uncertain)};
        given[0].training_seconds = training_seconds;
        const SurveyKind kind{.noise_std = settings.common_noise()};
        const std::vector<Trial> trials =
            simulate_trials(net, data, data.converged_in(count, data.size()), kind, settings.seed);
        const Stopwatch identification;
        const auto add = [&](const std::vector<Method>& methods, ModelErrors errors) {
            for (const Method& method : methods) {
                m_comparison.model_error_rows.push_back(
                    {.kind = kind,
                     .model_errors = errors,
                     .training_samples =
                         method.training_samples ? std::optional(count) : std::nullopt,
                     .result = evaluate_together(net, method, trials, m_progress),
                     .cramer_rao = {}});
            }
        };
        add(not_given, ModelErrors::not_given);
        add(given, ModelErrors::given);
        m_comparison.seconds.identification += identification.seconds();
    }

    [[nodiscard]] LengthModel train_next(const std::vector<int>& samples,
                                         const TrainingSettings& settings) {
        const auto models = static_cast<int>(2 * m_comparison.settings.training_samples.size());
        return train_model(m_comparison.net, m_data, samples, settings,
                           m_progress.part(m_models++, models));
    }

    [[nodiscard]] std::vector<ComparisonRow> rows_of(const Cell& cell,
                                                     const std::vector<Method>& methods) {
        const std::vector<Trial> trials = simulate_trials(m_comparison.net, m_data, m_surveyed,
                                                          cell.kind, m_comparison.settings.seed);
        const std::optional<CramerRaoBound> best =
            cell.kind == SurveyKind{}
                ? std::nullopt
                : cramer_rao_bound(m_comparison.net, m_comparison.settings.prior, trials);
        std::vector<ComparisonRow> rows;
        for (const Method& method : methods) {
            if (cell.only_trained && !method.training_samples) {
                continue;
            }
            rows.push_back({.kind = cell.kind,
                            .training_samples = method.training_samples
                                                    ? std::optional(cell.training_samples)
                                                    : std::nullopt,
                            .result = result_of(method, cell.kind, trials),
                            .cramer_rao = best});
        }
        return rows;
    }

    [[nodiscard]] MethodResult result_of(const Method& method, const SurveyKind& kind,
                                         const std::vector<Trial>& trials) {
        if (method.needs_all_nodes && kind.hidden_part > 0.0) {
            const auto count = static_cast<int>(trials.size());
            return {.name = method.name,
                    .surveys = count,
                    .failed = count,
                    .first_failure = "needs a survey of all free nodes",
                    .training_seconds = method.training_seconds};
        }
        return evaluate_together(m_comparison.net, method, trials,
                                 m_progress.part(m_evaluations++, evaluation_count(m_cells)));
    }

    Comparison& m_comparison;
    const DataSet& m_data;
    std::vector<int> m_surveyed;
    std::vector<Cell> m_cells;
    std::vector<std::vector<ComparisonRow>> m_rows;  ///< of each cell
    const Progress& m_progress;
    int m_models = 0;       ///< begun, for the progress
    int m_evaluations = 0;  ///< likewise
};

/// Rows of more surveys of the same nets, without and with turns in between.
void compare_epochs(Comparison& comparison, const DataSet& data, const std::vector<int>& surveyed,
                    const Progress& progress) {
    const ComparisonSettings& settings = comparison.settings;
    if (settings.epochs < 2) {
        return;
    }
    const CableNet& net = comparison.net;
    const SurveyKind kind{.noise_std = settings.common_noise()};
    const Stopwatch identification;
    const auto add = [&](const Method& method, const std::vector<Trial>& trials, int epochs,
                         bool is_turned) {
        comparison.epoch_rows.push_back({.kind = kind,
                                         .training_samples = {},
                                         .epochs = epochs,
                                         .is_turned = is_turned,
                                         .result = evaluate_together(net, method, trials, progress),
                                         .cramer_rao = {}});
    };
    const std::vector<Trial> first = simulate_trials(net, data, surveyed, kind, settings.seed);
    add(method_by_maximum_a_posteriori(net, settings.prior), first, 1, false);
    std::vector<Trial> as_it_stands = first;
    std::vector<Trial> turned = first;
    const Method method = method_by_epochs(net, settings.prior);
    for (int epochs = 2; epochs <= settings.epochs; ++epochs) {
        as_it_stands = surveyed_again(net, std::move(as_it_stands), kind, false, settings.seed);
        add(method, as_it_stands, epochs, false);
        turned = surveyed_again(net, std::move(turned), kind, true, settings.seed);
        add(method, turned, epochs, true);
    }
    comparison.seconds.identification += identification.seconds();
}

int count_with_slack(const DataSet& data, const std::vector<int>& samples) {
    return static_cast<int>(std::ranges::count_if(
        samples, [&data](int sample) { return data.slack_counts[sample] > 0; }));
}

void refuse_empty(const ComparisonSettings& settings) {
    if (settings.noises.empty() || settings.training_samples.empty()) {
        throw std::invalid_argument(
            "no noise or no number of training samples, expected at least one of each");
    }
}

}  // namespace

std::string_view to_string(ModelErrors errors) {
    switch (errors) {
        case ModelErrors::none:
            return "none";
        case ModelErrors::not_given:
            return "not given";
        case ModelErrors::given:
            return "given";
    }
    return "unknown";
}

int ComparisonSettings::common_training() const {
    refuse_empty(*this);
    constexpr int as_in_paper = 950;
    return std::ranges::find(training_samples, as_in_paper) != training_samples.end()
               ? as_in_paper
               : std::ranges::max(training_samples);
}

double ComparisonSettings::common_noise() const {
    refuse_empty(*this);
    constexpr double of_a_total_station = 0.5e-3;
    constexpr double rounding = 1e-9;
    const auto found = std::ranges::find_if(
        noises, [](double noise) { return std::abs(noise - of_a_total_station) < rounding; });
    return found != noises.end() ? *found : std::ranges::max(noises);
}

void ComparisonSettings::check() const {
    prior.check();
    refuse_empty(*this);
    for (const double noise : noises) {
        if (!(noise >= 0.0) || !std::isfinite(noise)) {
            throw std::invalid_argument(
                fmt::format("noise is {} m, expected at least 0 and finite", noise));
        }
    }
    for (const int count : training_samples) {
        constexpr int most_samples = 20'000;
        if (count < 2 || count > most_samples) {
            throw std::invalid_argument(
                fmt::format("{} training samples, expected 2 to {}", count, most_samples));
        }
    }
    for (const double part : hidden_parts) {
        if (!(part >= 0.0 && part < 1.0)) {
            throw std::invalid_argument(
                fmt::format("the hidden part is {}, expected at least 0 and below 1", part));
        }
    }
    constexpr int most_epochs = 10;
    if (epochs < 1 || epochs > most_epochs) {
        throw std::invalid_argument(
            fmt::format("{} epochs, expected 1 to {}", epochs, most_epochs));
    }
    if (epochs > 1 && !(common_noise() > 0.0)) {
        throw std::invalid_argument("epochs need a noise above 0");
    }
    constexpr int most_surveys = 100'000;
    if (surveys < 1 || surveys > most_surveys) {
        throw std::invalid_argument(
            fmt::format("{} surveys, expected 1 to {}", surveys, most_surveys));
    }
}

Comparison compare_methods(const CableNet& net, const ComparisonSettings& settings,
                           const Progress& progress) {
    settings.check();
    check_for_one_survey(net, settings.uncertain);
    const Stopwatch total;
    Comparison comparison{.net = net, .settings = settings};
    sort_once(comparison.settings.noises);
    sort_once(comparison.settings.training_samples);
    sort_once(comparison.settings.hidden_parts);

    const Stopwatch sampling;
    const Sampler sampler(net, settings.prior, settings.seed);
    const int training = comparison.settings.training_samples.back();
    const DataSet data = draw_samples(sampler, training + settings.surveys, progress);
    comparison.seconds.sampling = sampling.seconds();
    comparison.samples = data.size();
    comparison.not_converged = data.not_converged();
    const std::vector<int> surveyed = data.converged_in(training, data.size());
    if (surveyed.empty()) {
        throw NumericalError("no surveyed sample found its equilibrium");
    }
    comparison.surveys = static_cast<int>(surveyed.size());
    comparison.surveys_with_slack = count_with_slack(data, surveyed);

    Comparing(comparison, data, surveyed, progress).run();
    compare_epochs(comparison, data, surveyed, progress);
    comparison.seconds.total = total.seconds();
    return comparison;
}

}  // namespace taut
