// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/study/settling.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/seed_seq.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <ctime>
#include <exception>
#include <new>
#include <stdexcept>

#include "taut/identification/identify.hpp"
#include "taut/numerical_error.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"
#include "team_work.hpp"

namespace taut {
namespace {

constexpr double small_prior = 0.002;
constexpr double large_prior = 0.005;
constexpr double least_noise = 0.00005;
constexpr double most_noise = 0.002;
constexpr double hidden_part = 0.1;
constexpr double gross_part = 0.05;
constexpr double least_gross_error = 10.0;  // standard deviations of the noise
constexpr double most_gross_error = 50.0;
constexpr int most_draws = 100;

/// Boost's distributions give the same numbers on every platform; the standard's need not.
class Dice {
public:
    Dice(std::uint64_t seed, int number) {
        boost::random::seed_seq words{static_cast<std::uint32_t>(seed),
                                      static_cast<std::uint32_t>(seed >> 32U),
                                      static_cast<std::uint32_t>(number)};
        m_engine.seed(words);
    }

    bool toss() { return uniform(0.0, 1.0) < 0.5; }
    double uniform(double low, double high) { return low + (high - low) * m_uniform(m_engine); }
    Eigen::Vector3d normals() {
        const double x = m_normal(m_engine);
        const double y = m_normal(m_engine);
        return {x, y, m_normal(m_engine)};
    }
    void shuffle(std::vector<int>& values) {
        for (size_t i = values.size(); i > 1; --i) {
            const boost::random::uniform_int_distribution<size_t> below(0, i - 1);
            std::swap(values[i - 1], values[below(m_engine)]);
        }
    }
    std::uint64_t number() { return m_engine(); }

private:
    boost::random::mt19937_64 m_engine;
    boost::random::uniform_01<double> m_uniform;
    boost::random::normal_distribution<double> m_normal;
};

/// Draws lengths until they find an equilibrium, and keeps them.
Equilibrium draw_form(const CableNet& net, Dice& dice, SettlingSurvey& survey) {
    EquilibriumSolver solver(net);
    for (int draw = 0; draw < most_draws; ++draw) {
        survey.deviations = draw_length_deviations(survey.prior, dice.number(),
                                                   static_cast<std::uint64_t>(survey.number),
                                                   net.interior_edge_count());
        Equilibrium found =
            solver.solve(with_length_deviations(net, survey.deviations), net.nodes());
        if (found.balanced()) {
            return found;
        }
    }
    throw NumericalError(fmt::format("{} draws of lengths {} found no equilibrium", most_draws,
                                     survey.prior.to_string()));
}

std::vector<bool> interior_flags(const CableNet& net, const std::vector<int>& edges) {
    std::vector<bool> flags;
    for (const int edge : net.interior_edges()) {
        flags.push_back(std::ranges::find(edges, edge) != edges.end());
    }
    return flags;
}

int part_of(double part, size_t count) {
    return static_cast<int>(std::lround(part * static_cast<double>(count)));
}

/// Noise on every target, the first of the shuffled nodes hidden, gross errors on the last.
void measure(const CableNet& net, const Points& form, bool with_hidden, bool with_gross, Dice& dice,
             SettlingSurvey& survey) {
    std::vector<int> nodes = net.free_nodes();
    dice.shuffle(nodes);
    const int hidden = with_hidden ? part_of(hidden_part, nodes.size()) : 0;
    survey.survey.missing.assign(nodes.begin(), nodes.begin() + hidden);
    nodes.erase(nodes.begin(), nodes.begin() + hidden);
    survey.gross_errors = with_gross ? std::max(1, part_of(gross_part, nodes.size())) : 0;
    survey.survey.form = net.nodes();
    survey.survey.noise_std = Points::Constant(3, net.node_count(), survey.noise_std);
    for (size_t i = 0; i < nodes.size(); ++i) {
        Eigen::Vector3d error = survey.noise_std * dice.normals();
        if (i + survey.gross_errors >= nodes.size()) {
            error += survey.noise_std * dice.uniform(least_gross_error, most_gross_error) *
                     dice.normals().normalized();
        }
        survey.survey.form.col(nodes[i]) = form.col(nodes[i]) + error;
    }
    std::ranges::sort(nodes);
    std::ranges::sort(survey.survey.missing);
    survey.survey.surveyed = std::move(nodes);
}

/// Of all threads of the program [s].
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void hold_against_truth(SettlingOutcome& outcome, const Identification& result,
                        const SettlingSurvey& truth) {
    for (size_t i = 0; i < result.edges.size(); ++i) {
        const IdentifiedEdge& edge = result.edges[i];
        const double deviation = truth.deviations(static_cast<Eigen::Index>(i));
        outcome.inside += edge.lower <= deviation && deviation <= edge.upper ? 1 : 0;
        const bool is_called_slack = edge.status == EdgeStatus::slack;
        outcome.slack_called += is_called_slack ? 1 : 0;
        outcome.taut_as_slack += is_called_slack && !truth.slack[i] ? 1 : 0;
        outcome.slack_as_taut +=
            !is_called_slack && edge.status != EdgeStatus::not_determined && truth.slack[i] ? 1 : 0;
    }
    outcome.tensions_told = static_cast<int>(result.drawn.tensions.size());
    for (const DrawnTension& of_edge : result.drawn.tensions) {
        const double tension = truth.tensions(of_edge.edge);
        outcome.tensions_inside +=
            of_edge.tension.lower <= tension && tension <= of_edge.tension.upper ? 1 : 0;
        outcome.slack_reliability.add(of_edge.slack_probability, tension <= 0.0);
    }
}

SettlingOutcome try_survey(const CableNet& net, const SettlingSurvey& s) {
    SettlingOutcome outcome{.number = s.number,
                            .prior = s.prior,
                            .noise_std = s.noise_std,
                            .hidden_nodes = static_cast<int>(s.survey.missing.size()),
                            .gross_errors = s.gross_errors,
                            .slack_edges = static_cast<int>(std::ranges::count(s.slack, true))};
    const double begin = processor_seconds();
    try {
        const Identification result = identify(net, s.survey,
                                               {.method = IdentificationMethod::map,
                                                .prior = s.prior,
                                                .prior_exact = true,
                                                .draws = default_draws(net)});
        outcome.settled = result.status == IdentificationStatus::converged;
        outcome.message = result.message;
        hold_against_truth(outcome, result, s);
    } catch (const NumericalError& error) {
        outcome.message = error.what();
    }
    outcome.seconds = processor_seconds() - begin;
    return outcome;
}

}  // namespace

template <typename Packing>
static void pack(Packing& packing, SettlingOutcome& outcome) {
    auto& [number, prior, noise_std, hidden_nodes, gross_errors, slack_edges, settled, message,
           seconds, inside, tensions_told, tensions_inside, slack_called, taut_as_slack,
           slack_as_taut, slack_reliability] = outcome;
    packing(number, prior, noise_std, hidden_nodes, gross_errors, slack_edges, settled, message,
            seconds, inside, tensions_told, tensions_inside, slack_called, taut_as_slack,
            slack_as_taut, slack_reliability);
}

void SettlingSettings::check() const {
    if (surveys < 1) {
        throw std::invalid_argument(fmt::format("{} surveys, expected at least 1", surveys));
    }
    if (first < 0) {
        throw std::invalid_argument(
            fmt::format("the first survey is {}, expected at least 0", first));
    }
}

SettlingSurvey settling_survey(const CableNet& net, std::uint64_t seed, int number) {
    Dice dice(seed, number);
    SettlingSurvey result;
    result.number = number;
    result.prior = {.kind = LengthPrior::Kind::uniform,
                    .scale = dice.toss() ? small_prior : large_prior};
    check_prior(net, result.prior);
    result.noise_std = std::exp(dice.uniform(std::log(least_noise), std::log(most_noise)));
    const bool with_hidden = dice.toss();
    const bool with_gross = dice.toss();
    const Equilibrium truth = draw_form(net, dice, result);
    result.slack = interior_flags(net, truth.slack_edges);
    result.tensions = tensions(net, with_length_deviations(net, result.deviations), truth.form);
    measure(net, truth.form, with_hidden, with_gross, dice, result);
    return result;
}

int SettlingRecord::settled() const {
    return static_cast<int>(std::ranges::count(outcomes, true, &SettlingOutcome::settled));
}

double SettlingRecord::median_seconds() const {
    std::vector<double> seconds;
    seconds.reserve(outcomes.size());
    for (const SettlingOutcome& outcome : outcomes) {
        seconds.push_back(outcome.seconds);
    }
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::ranges::nth_element(seconds, middle);
    return seconds.empty() ? 0.0 : *middle;
}

double SettlingRecord::largest_seconds() const {
    double largest = 0.0;
    for (const SettlingOutcome& outcome : outcomes) {
        largest = std::max(largest, outcome.seconds);
    }
    return largest;
}

double SettlingRecord::coverage() const {
    const double lengths = static_cast<double>(settled()) * interior_edges;
    return lengths > 0.0 ? sum(&SettlingOutcome::inside) / lengths : 0.0;
}

int SettlingRecord::sum(int SettlingOutcome::* count) const {
    int result = 0;
    for (const SettlingOutcome& outcome : outcomes) {
        result += outcome.settled ? outcome.*count : 0;
    }
    return result;
}

SlackReliability SettlingRecord::slack_reliability() const {
    SlackReliability result;
    for (const SettlingOutcome& outcome : outcomes) {
        if (outcome.settled) {
            result.add(outcome.slack_reliability);
        }
    }
    return result;
}

SettlingRecord try_settling(const CableNet& net, const SettlingSettings& settings,
                            const Progress& progress) {
    settings.check();
    SettlingRecord record{.net = net.name(),
                          .free_nodes = static_cast<int>(net.free_nodes().size()),
                          .interior_edges = net.interior_edge_count(),
                          .outcomes = {}};
    require_same("net", net.fingerprint());
    for (const size_t share : share_of(settings.surveys)) {
        const auto k = static_cast<int>(share);
        if (progress.stopped()) {
            throw Interrupted();
        }
        record.outcomes.push_back(
            try_survey(net, settling_survey(net, settings.seed, settings.first + k)));
        progress("identification", k + 1, settings.surveys);
    }
    record.outcomes = gathered(settings.surveys, std::move(record.outcomes));
    return record;
}

}  // namespace taut
