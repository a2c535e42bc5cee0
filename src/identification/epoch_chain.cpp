// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/epoch_chain.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "identification/epoch_net.hpp"
#include "identification/parameter_estimates.hpp"
#include "sampling/uncertain_widths.hpp"

namespace taut {
namespace {

/// Prior standard deviation of a length that changed: so wide that the surveys alone determine it
/// [m].
double width_of(const LengthChange& change) {
    constexpr double wide = 4.0;
    return wide * std::max(std::abs(change.change), change.std_dev);
}

double largest_actuator_std(std::span<const Epoch> epochs) {
    double actuator_std = 0.0;
    for (const Epoch& epoch : epochs) {
        for (const EdgeTurned& one : epoch.turned) {
            actuator_std = std::max(actuator_std, one.std_dev);
        }
    }
    return actuator_std;
}

}  // namespace

EpochChain::EpochChain(const CableNet& net, std::span<const Epoch> epochs,
                       const IdentifyOptions& options, const LengthPrior& prior,
                       double least_actuator_std, const std::vector<EpochChanges>& changes)
    : m_net(net),
      m_options(options),
      m_prior(prior),
      m_widest_turn(widest_turn(net)),
      m_uncertain(options.uncertain),
      m_reported(static_cast<int>(reported_epoch(epochs))),
      m_changes(epochs.size()) {
    const bool is_given = std_of(m_uncertain, UncertainParameter::Kind::adjustable) > 0.0;
    double actuator_std = std::max(least_actuator_std, largest_actuator_std(epochs));
    for (const EpochChanges& of_survey : changes) {
        actuator_std = std::max(actuator_std, of_survey.excess_actuator_std);
        for (const LengthChange& change : of_survey.lengths) {
            actuator_std =
                std::max(actuator_std, is_adjustable(change.edge) ? width_of(change) : 0.0);
        }
        for (const SlipOrTarget& either : of_survey.slips_or_targets) {
            for (const LengthChange& change : either.lengths) {
                actuator_std =
                    std::max(actuator_std, is_adjustable(change.edge) ? either.width() : 0.0);
            }
        }
    }
    actuator_std = std::min(actuator_std, m_widest_turn);
    if (actuator_std > 0.0 && !is_given) {
        m_uncertain.push_back(
            {.kind = UncertainParameter::Kind::adjustable, .std_dev = actuator_std, .group = {}});
    }
    m_has_actuator_std = is_given || actuator_std > 0.0;
    m_entries = {.edges = net_to_fit(net, m_uncertain).interior_edges(),
                 .common = static_cast<int>(std::ranges::count_if(options.uncertain, is_common))};
    Eigen::VectorXd stds = adjustable_stds(net, options.uncertain);
    for (size_t k = 0; k < epochs.size(); ++k) {
        m_states.push_back({.net = net_at_survey(net, epochs, k),
                            .survey = epochs[k].survey,
                            .turned = &epochs[k].turned,
                            .loads = &epochs[k].loads,
                            .prior = first_prior(stds),
                            .added = Eigen::VectorXd::Zero(m_entries.size()),
                            .earlier = no_evidence(m_entries.size()),
                            .later = no_evidence(m_entries.size()),
                            .own = no_evidence(m_entries.size()),
                            .found = {}});
    }
    for (size_t k = 0; k < m_states.size() && m_has_actuator_std; ++k) {
        for (const int edge : net.adjustable_edges()) {
            add_variance(k, edge, least_actuator_std);
        }
        for (const EdgeTurned& one : epochs[k].turned) {
            add_variance(k, one.edge, one.std_dev);
        }
    }
    allow(changes);
}

bool EpochChain::is_adjustable(int edge) const {
    return std::ranges::binary_search(m_net.adjustable_edges(), edge);
}

Eigen::VectorXd EpochChain::first_prior(const Eigen::VectorXd& stds) const {
    Eigen::VectorXd variances = Eigen::VectorXd::Ones(m_entries.size());
    for (size_t i = 0; i < m_entries.edges.size(); ++i) {
        const double std_dev =
            is_adjustable(m_entries.edges[i]) ? stds(m_entries.edges[i]) : m_prior.std_dev();
        variances(static_cast<Eigen::Index>(i)) = std_dev * std_dev;
    }
    return variances;
}

/// From a survey on, adds to the variance of a length.
void EpochChain::add_variance(size_t k, int edge, double std_dev) {
    const Eigen::Index place = m_entries.place_of(edge);
    m_states[k].added(place) += std_dev * std_dev;
    for (size_t j = k; j < m_states.size(); ++j) {
        m_states[j].prior(place) += std_dev * std_dev;
    }
}

EpochStep EpochChain::step_from(size_t k) const {
    EpochStep step{.factor = Eigen::VectorXd::Ones(m_entries.size()),
                   .added = m_states[k + 1].added,
                   .prior_from = m_states[k].prior,
                   .prior_to = m_states[k + 1].prior};
    auto place = static_cast<Eigen::Index>(m_entries.edges.size());
    for (const UncertainParameter& parameter : m_uncertain) {
        if (parameter.kind == UncertainParameter::Kind::temperature) {  // another day
            step.factor(place) = 0.0;
            step.added(place) = 1.0;
        } else if (parameter.kind == UncertainParameter::Kind::creep) {  // (creep)
            const auto steps = static_cast<double>(k);
            step.factor(place) = std::sqrt(steps / (steps + 1.0));
            step.added(place) = 1.0 / (steps + 1.0);
        }
        place += is_common(parameter) ? 1 : 0;
    }
    return step;
}

void EpochChain::allow(const std::vector<EpochChanges>& changes) {
    for (size_t k = 0; k < changes.size(); ++k) {
        for (const LengthChange& change : changes[k].lengths) {
            // As wide as it may be given, so that what is written can be read.
            add_variance(k, change.edge,
                         is_adjustable(change.edge) ? std::min(width_of(change), m_widest_turn)
                                                    : width_of(change));
        }
        for (const SlipOrTarget& either : changes[k].slips_or_targets) {
            Survey& survey = m_states[k].survey;
            if (std::erase(survey.surveyed, either.node) > 0) {
                survey.missing.insert(std::ranges::upper_bound(survey.missing, either.node),
                                      either.node);
            }
            for (const LengthChange& change : either.lengths) {
                const double width = either.width();
                add_variance(k, change.edge,
                             is_adjustable(change.edge) ? std::min(width, m_widest_turn) : width);
            }
        }
        if (changes[k].excess_actuator_std > 0.0) {
            for (const int edge : scattering_edges(k)) {
                add_variance(k, edge, changes[k].excess_actuator_std);
            }
        }
    }
}

Given EpochChain::given(int k) const {
    const State& state = m_states[k];
    Given result(m_prior);
    result.uncertain = m_uncertain;
    for (UncertainParameter& parameter : result.uncertain) {
        if (parameter.kind == UncertainParameter::Kind::creep) {  // (creep); none at the first
            constexpr double hardly_any = 1e-6;
            parameter.std_dev *= std::max(hardly_any, std::sqrt(static_cast<double>(k)));
        }
    }
    result.has_trend = !m_options.prior_exact;
    result.unturned_std = std_of(m_options.uncertain, UncertainParameter::Kind::adjustable);
    result.test_loads = *state.loads;
    if (k == m_reported) {
        result.forces = m_options.forces;
    }
    constexpr double a_little_more = 1.0 + 1e-6;
    result.own_stds = Eigen::VectorXd::Zero(m_net.edge_count());
    for (size_t i = 0; i < m_entries.edges.size(); ++i) {
        const double std_dev = std::sqrt(state.prior(static_cast<Eigen::Index>(i)));
        if (is_adjustable(m_entries.edges[i]) || std_dev > a_little_more * m_prior.std_dev()) {
            result.own_stds(m_entries.edges[i]) = std_dev;
        }
    }
    if (state.earlier.root.cols() + state.later.root.cols() > 0) {
        LengthEvidence others = sum_of(state.earlier, state.later);
        others.root.resize(m_entries.size(), state.earlier.root.cols() + state.later.root.cols());
        others.root << state.earlier.root, state.later.root;
        result.evidence = std::make_shared<LengthEvidence>(std::move(others));
    }
    return result;
}

void EpochChain::fit(size_t k, const Given& given, const Progress& progress) {
    State& state = m_states[k];
    IdentifiedEpoch epoch =
        identify_one_epoch(state.net, state.survey, given, m_entries.common,
                           {.report = {}, .stop_requested = progress.stop_requested});
    state.found = std::move(epoch.identification);
    const auto is_creep = [](const ParameterEstimate& one) {
        return one.parameter.kind == UncertainParameter::Kind::creep;
    };
    if (k == 0) {
        std::erase_if(state.found.uncertain, is_creep);
    }
    for (ParameterEstimate& one : state.found.uncertain) {  // by its step, as it was given
        one.parameter.std_dev /= is_creep(one) ? std::sqrt(static_cast<double>(k)) : 1.0;
    }
    state.own = std::move(epoch.own);
}

bool EpochChain::has_converged() const {
    return std::ranges::all_of(m_states, [](const State& state) {
        return state.found.status == IdentificationStatus::converged;
    });
}

/// With adjustable lengths uncertain, so that a wrong turn rejects no target, and without measured
/// forces, so that a wrong one is no change of lengths.
Given EpochChain::given_for_form_alone(int k) const {
    Given result = given(k);
    result.forces.measurements.clear();
    for (const int edge : m_net.adjustable_edges()) {
        result.own_stds(edge) = std::max(result.own_stds(edge), m_widest_turn);
    }
    return result;
}

std::vector<int> EpochChain::scattering_edges(size_t k) const {
    if (!m_has_actuator_std) {
        return {};
    }
    std::vector<int> edges;
    edges.reserve(m_states[k].turned->size());
    for (const EdgeTurned& one : *m_states[k].turned) {
        edges.push_back(one.edge);
    }
    return edges.empty() ? m_net.adjustable_edges() : edges;
}

void EpochChain::free_lengths(size_t k, const std::vector<LengthChange>& changed) {
    for (const LengthChange& change : changed) {
        add_variance(k, change.edge, width_of(change));
    }
}

std::vector<SlipOrTarget> EpochChain::slips_or_targets(size_t k) const {
    const State& state = m_states[k];
    std::vector<SlipOrTarget> result;
    const auto is_known = [&](int node) {
        return std::ranges::find(result, node, &SlipOrTarget::node) != result.end();
    };
    for (const LengthOutlier& one : state.found.length_outliers) {
        if (!one.is_beside_target || is_known(one.node)) {
            continue;
        }
        const LengthChange change{.edge = one.edge,
                                  .change = one.deviation,
                                  .std_dev = one.std_dev,
                                  .statistic = std::sqrt(one.statistic)};
        LengthChange opposite = change;
        opposite.edge = one.other;
        opposite.change = -one.deviation;
        result.push_back({.node = one.node, .lengths = {change, opposite}});
    }
    for (const Outlier& one : state.found.outliers) {
        if (std::optional<SlipOrTarget> slip =
                slip_to_target(state.net, state.survey, state.found.predicted.form, one);
            slip && !is_known(one.node)) {
            result.push_back(*std::move(slip));
        }
    }
    return result;
}

bool EpochChain::find_changes(const Progress& progress) {
    for (int k = 0; k < count(); ++k) {
        fit(k, given_for_form_alone(k), progress);
    }
    if (!has_converged()) {
        return false;
    }
    EvidenceTest first(m_states[0].prior, no_evidence(m_entries.size()), m_states[0].own);
    m_changes[0].lengths =
        let_go_changed(first, m_net, m_entries,
                       m_has_actuator_std ? m_net.adjustable_edges() : std::vector<int>());
    free_lengths(0, m_changes[0].lengths);
    for (size_t k = 1; k < m_states.size(); ++k) {
        const State& before = m_states[k - 1];
        State& state = m_states[k];
        progress("comparing surveys", static_cast<int>(k), count());
        const LengthEvidence until_before = sum_of(before.earlier, before.own);
        std::vector<SlipOrTarget> either = slips_or_targets(k);
        for (const SlipOrTarget& one : either) {
            free_lengths(k, one.lengths);
        }
        ComparedEpoch found = compared_epoch(
            EvidenceTest(state.prior, carried(until_before, step_from(k - 1)), state.own), m_net,
            m_entries, *state.turned, scattering_edges(k));
        free_lengths(k, found.let_go);
        m_changes[k] = std::move(found.changes);
        take_out_slips(m_net, m_changes[k].lengths, either);
        m_changes[k].slips_or_targets = std::move(either);
        // A change that was let go is not evidence for later surveys.
        state.earlier = carried(until_before, step_from(k - 1));
    }
    return true;
}

Eigen::VectorXd EpochChain::last_lengths() const {
    const std::vector<IdentifiedEdge>& edges = m_states.back().found.edges;
    Eigen::VectorXd result(std::ssize(edges));
    for (Eigen::Index i = 0; i < result.size(); ++i) {
        result(i) = edges[static_cast<size_t>(i)].length_deviation;
    }
    return result;
}

double EpochChain::movement_since(const Eigen::VectorXd& before) const {
    const Eigen::VectorXd moved = last_lengths() - before;
    double squares = 0.0;
    for (Eigen::Index i = 0; i < moved.size(); ++i) {
        const double std_dev = m_states.back().found.edges[static_cast<size_t>(i)].std_dev;
        squares += std::pow(moved(i) / std_dev, 2);
    }
    return moved.size() > 0 ? std::sqrt(squares / static_cast<double>(moved.size())) : 0.0;
}

std::optional<double> EpochChain::converge(const Progress& progress) {
    constexpr int most_sweeps = 6;
    double movement = 0.0;
    Eigen::VectorXd before;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        progress("identification", sweep, most_sweeps);
        for (size_t k = 0; k < m_states.size(); ++k) {
            fit(k, given(static_cast<int>(k)), progress);
            const State& state = m_states[k];
            if (state.found.status != IdentificationStatus::converged) {
                return std::nullopt;
            }
            if (k + 1 < m_states.size()) {
                m_states[k + 1].earlier = carried(sum_of(state.earlier, state.own), step_from(k));
            }
        }
        if (before.size() > 0) {
            movement = movement_since(before);
            if (movement < still) {
                break;
            }
        }
        before = last_lengths();
        for (size_t k = m_states.size(); k-- > 1;) {
            const State& state = m_states[k];
            m_states[k - 1].later =
                carried(sum_of(state.own, state.later), step_from(k - 1).reversed());
        }
    }
    progress("identification", most_sweeps, most_sweeps);
    return movement;
}

}  // namespace taut
