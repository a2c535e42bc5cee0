// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/epoch_chain.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>

#include "estimation/hypotheses.hpp"
#include "identification/parameter_estimates.hpp"
#include "net/weight_as_load.hpp"
#include "taut/numerical_error.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

/// Prior standard deviation of a length that changed: so wide that the surveys alone determine it
/// [m].
double width_of(const LengthChange& change) {
    constexpr double wide = 4.0;
    return wide * std::max(std::abs(change.change), change.std);
}

double largest_actuator_std(std::span<const Epoch> epochs) {
    double actuator_std = 0.0;
    for (const Epoch& epoch : epochs) {
        for (const EdgeTurned& one : epoch.turned) {
            actuator_std = std::max(actuator_std, one.std);
        }
    }
    return actuator_std;
}

/// Whether chance explains all but a change along one direction of this statistic.
bool is_chance_but_for(Agreement all, double statistic) {
    all.squares = std::max(0.0, all.squares - statistic * statistic);
    --all.rank;
    return all.ratio() <= all.limit();
}

}  // namespace

bool are_too_many_changes(const CableNet& net, size_t changes) {
    constexpr double most = 0.1;  // of all edges
    constexpr double a_few = 3.0;
    return static_cast<double>(changes) > std::max(a_few, most * net.edge_count());
}

double widest_turn(const CableNet& net) {
    constexpr double wide = 0.05;  // [m]
    constexpr double most = 0.25;  // of the shortest edge: no more may be uncertain
    const Eigen::VectorXd lengths = net.unstressed_lengths()(net.adjustable_edges());
    if (lengths.size() == 0) {
        return 0.0;
    }
    const double width = std::min(wide, most * lengths.minCoeff());
    const double digit = std::pow(10.0, std::floor(std::log10(width)));
    return digit * std::floor(width / digit);  // as one would give it
}

std::vector<EdgeTurned> turned_until(std::span<const Epoch> epochs, size_t k) {
    std::vector<std::vector<EdgeTurned>> steps;
    for (const Epoch& epoch : epochs.first(k + 1)) {
        steps.push_back(epoch.turned);
    }
    return all_turned(steps);
}

CableNet net_at_survey(const CableNet& net, std::span<const Epoch> epochs, size_t k) {
    const std::vector<EdgeTurned> turned = turned_until(epochs, k);
    if (turned.empty() && !epochs[k].is_loaded()) {
        return net;
    }
    CableNetData data =
        with_lengths_of_same_weight(net, turned_net(net, turned).unstressed_lengths());
    if (epochs[k].is_loaded()) {
        data.loads = data.loads.cols() > 0 ? Points(data.loads + epochs[k].loads) : epochs[k].loads;
    }
    const Equilibrium equilibrium = solve_equilibrium(CableNet(CableNetData(data)));
    if (!equilibrium.balanced()) {
        throw NumericalError(
            fmt::format("the net finds no equilibrium after the turns of {} edges{}", turned.size(),
                        epochs[k].is_loaded() ? " and under the loads hung on it" : ""));
    }
    data.nodes = equilibrium.form;
    return CableNet(std::move(data));
}

EpochChain::EpochChain(const CableNet& net, std::span<const Epoch> epochs,
                       const IdentifyOptions& options, const LengthPrior& prior,
                       double least_actuator_std, const std::vector<Changes>& changes)
    : m_net(net),
      m_options(options),
      m_prior(prior),
      m_widest_turn(widest_turn(net)),
      m_uncertain(options.uncertain),
      m_common(static_cast<int>(std::ranges::count_if(options.uncertain, is_common))),
      m_reported(static_cast<int>(reported_epoch(epochs))),
      m_changes(epochs.size()) {
    const bool is_given = std_of(m_uncertain, UncertainParameter::Kind::adjustable) > 0.0;
    double actuator_std = std::max(least_actuator_std, largest_actuator_std(epochs));
    for (const Changes& of_survey : changes) {
        actuator_std = std::max(actuator_std, of_survey.excess_actuator_std);
        for (const LengthChange& change : of_survey.lengths) {
            actuator_std =
                std::max(actuator_std, is_adjustable(change.edge) ? width_of(change) : 0.0);
        }
    }
    actuator_std = std::min(actuator_std, m_widest_turn);
    if (actuator_std > 0.0 && !is_given) {
        m_uncertain.push_back(
            {.kind = UncertainParameter::Kind::adjustable, .std = actuator_std, .group = {}});
    }
    m_has_actuator_std = is_given || actuator_std > 0.0;
    m_edges = net_to_fit(net, m_uncertain).interior_edges();
    Eigen::VectorXd stds = adjustable_stds(net, options.uncertain);
    for (size_t k = 0; k < epochs.size(); ++k) {
        m_states.push_back({.net = net_at_survey(net, epochs, k),
                            .survey = &epochs[k].survey,
                            .turned = &epochs[k].turned,
                            .loads = &epochs[k].loads,
                            .prior = first_prior(stds),
                            .added = Eigen::VectorXd::Zero(size()),
                            .earlier = no_evidence(size()),
                            .later = no_evidence(size()),
                            .own = no_evidence(size()),
                            .found = {}});
    }
    for (size_t k = 0; k < m_states.size() && m_has_actuator_std; ++k) {
        for (const int edge : net.adjustable_edges()) {
            add_variance(k, edge, least_actuator_std);
        }
        for (const EdgeTurned& one : epochs[k].turned) {
            add_variance(k, one.edge, one.std);
        }
    }
    let_go(changes);
}

bool EpochChain::is_adjustable(int edge) const {
    return std::ranges::binary_search(m_net.adjustable_edges(), edge);
}

Eigen::Index EpochChain::place_of(int edge) const {
    return std::ranges::lower_bound(m_edges, edge) - m_edges.begin();
}

Eigen::VectorXd EpochChain::first_prior(const Eigen::VectorXd& stds) const {
    Eigen::VectorXd variances = Eigen::VectorXd::Ones(size());
    for (size_t i = 0; i < m_edges.size(); ++i) {
        const double std = is_adjustable(m_edges[i]) ? stds(m_edges[i]) : m_prior.std();
        variances(static_cast<Eigen::Index>(i)) = std * std;
    }
    return variances;
}

/// From a survey on, adds to the variance of a length.
void EpochChain::add_variance(size_t k, int edge, double std) {
    const Eigen::Index place = place_of(edge);
    m_states[k].added(place) += std * std;
    for (size_t j = k; j < m_states.size(); ++j) {
        m_states[j].prior(place) += std * std;
    }
}

EpochStep EpochChain::step_from(size_t k) const {
    EpochStep step{.factor = Eigen::VectorXd::Ones(size()),
                   .added = m_states[k + 1].added,
                   .prior_from = m_states[k].prior,
                   .prior_to = m_states[k + 1].prior};
    auto place = static_cast<Eigen::Index>(m_edges.size());
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

void EpochChain::let_go(const std::vector<Changes>& changes) {
    for (size_t k = 0; k < changes.size(); ++k) {
        for (const LengthChange& change : changes[k].lengths) {
            // As wide as it may be given, so that what is written can be read.
            add_variance(k, change.edge,
                         is_adjustable(change.edge) ? std::min(width_of(change), m_widest_turn)
                                                    : width_of(change));
        }
        for (const int edge :
             changes[k].excess_actuator_std > 0.0 ? turned_edges(k) : std::vector<int>()) {
            add_variance(k, edge, changes[k].excess_actuator_std);
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
            parameter.std *= std::max(hardly_any, std::sqrt(static_cast<double>(k)));
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
    for (size_t i = 0; i < m_edges.size(); ++i) {
        const double std = std::sqrt(state.prior(static_cast<Eigen::Index>(i)));
        if (is_adjustable(m_edges[i]) || std > a_little_more * m_prior.std()) {
            result.own_stds(m_edges[i]) = std;
        }
    }
    if (state.earlier.root.cols() + state.later.root.cols() > 0) {
        LengthEvidence others = sum_of(state.earlier, state.later);
        others.root.resize(size(), state.earlier.root.cols() + state.later.root.cols());
        others.root << state.earlier.root, state.later.root;
        result.evidence = std::make_shared<LengthEvidence>(std::move(others));
    }
    return result;
}

void EpochChain::fit(size_t k, const Given& given, const Progress& progress) {
    if (progress.stopped()) {
        throw Interrupted();
    }
    State& state = m_states[k];
    IdentifiedEpoch epoch = identify_one_epoch(state.net, *state.survey, given, m_common);
    state.found = std::move(epoch.identification);
    const auto is_creep = [](const ParameterEstimate& one) {
        return one.parameter.kind == UncertainParameter::Kind::creep;
    };
    if (k == 0) {
        std::erase_if(state.found.uncertain, is_creep);
    }
    for (ParameterEstimate& one : state.found.uncertain) {  // by its step, as it was given
        one.parameter.std /= is_creep(one) ? std::sqrt(static_cast<double>(k)) : 1.0;
    }
    state.own = std::move(epoch.own);
}

bool EpochChain::has_converged() const {
    return std::ranges::all_of(m_states, [](const State& state) {
        return state.found.status == IdentificationStatus::converged;
    });
}

/// (epoch-change)
std::optional<LengthChange> EpochChain::worst_change(const EvidenceTest::Changes& changes,
                                                     const std::vector<int>& edges) const {
    const auto worst = std::ranges::max_element(
        edges, {}, [&](int edge) { return changes.statistic(place_of(edge)); });
    if (worst == edges.end()) {
        return std::nullopt;
    }
    const Eigen::Index place = place_of(*worst);
    const double statistic = changes.statistic(place);
    if (statistic * statistic <= snooping_threshold(default_false_alarm_rate, edges.size(), 1)) {
        return std::nullopt;
    }
    return LengthChange{.edge = *worst,
                        .change = changes.change(place),
                        .std = changes.std(place),
                        .statistic = statistic};
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

std::vector<int> EpochChain::turned_edges(size_t k) const {
    std::vector<int> edges;
    edges.reserve(m_states[k].turned->size());
    for (const EdgeTurned& one : *m_states[k].turned) {
        edges.push_back(one.edge);
    }
    return edges.empty() ? m_net.adjustable_edges() : edges;
}

bool EpochChain::find_changes(const Progress& progress) {
    for (int k = 0; k < count(); ++k) {
        fit(k, given_for_form_alone(k), progress);
    }
    if (!has_converged()) {
        return false;
    }
    find_changes_at(0, EvidenceTest(m_states[0].prior, no_evidence(size()), m_states[0].own),
                    m_has_actuator_std ? m_net.adjustable_edges() : std::vector<int>());
    for (size_t k = 1; k < m_states.size(); ++k) {
        State& before = m_states[k - 1];
        State& state = m_states[k];
        progress("comparing surveys", static_cast<int>(k), count());
        state.earlier = carried(sum_of(before.earlier, before.own), step_from(k - 1));
        find_changes_at(k, EvidenceTest(state.prior, state.earlier, state.own), m_edges);
        // A change that was let go is not evidence for later surveys.
        state.earlier = carried(sum_of(before.earlier, before.own), step_from(k - 1));
    }
    return true;
}

void EpochChain::find_changes_at(size_t k, EvidenceTest test, const std::vector<int>& edges) {
    Changes& changes = m_changes[k];
    std::optional<LengthChange> worst = worst_change(test.changes(), edges);
    Changes all_at_once;
    if (k > 0) {
        all_at_once.agreement = test.agreement();
        all_at_once.common_strain = common_strain(test, {});
    }
    if (k > 0 && m_states[k].turned->size() > 1) {
        set_stroke_factor(all_at_once, test, *m_states[k].turned);
    }
    while (worst && !are_too_many_changes(m_net, changes.lengths.size())) {
        changes.lengths.push_back(*worst);
        add_variance(k, worst->edge, width_of(*worst));
        test.let_go(place_of(worst->edge));
        worst = worst_change(test.changes(), edges);
    }
    if (k == 0) {
        return;
    }
    if (explains_changes(all_at_once, changes.lengths, *m_states[k].turned)) {
        changes = all_at_once;
        changes.common_strain.reset();
        changes.is_of_all_turns = true;
        return;
    }
    if (all_at_once.common_strain && !all_at_once.are_strokes_off() &&
        is_chance_but_for(all_at_once.agreement, all_at_once.common_strain->statistic())) {
        changes = all_at_once;
        return;
    }
    changes.agreement = test.agreement();
    set_stroke_factor(changes, test, *m_states[k].turned);
    if (!changes.are_strokes_off()) {
        changes.common_strain = common_strain(test, changes.lengths);
    }
    if (changes.common_strain) {
        return;
    }
    std::vector<Eigen::Index> places;
    for (const int edge : m_has_actuator_std ? turned_edges(k) : std::vector<int>()) {
        if (std::ranges::find(changes.lengths, edge, &LengthChange::edge) ==
            changes.lengths.end()) {
            places.push_back(place_of(edge));
        }
    }
    const Agreement of_turns = test.agreement(places);
    if (of_turns.ratio() > of_turns.limit()) {
        changes.excess_actuator_std = test.spread(places);
    }
}

/// Whether a wrong sign, unit or pitch of all turns explains what was let go: most of the turns,
/// with all else as chance has it.
bool EpochChain::explains_changes(const Changes& all_at_once,
                                  const std::vector<LengthChange>& let_go,
                                  const std::vector<EdgeTurned>& turned) const {
    const auto of_turns = std::ranges::count_if(let_go, [&](const LengthChange& change) {
        return std::ranges::find(turned, change.edge, &EdgeTurned::edge) != turned.end();
    });
    return all_at_once.are_strokes_off() && of_turns >= 2 &&
           3 * of_turns >= 2 * std::ssize(turned) &&
           is_chance_but_for(all_at_once.agreement, all_at_once.stroke_factor_statistic());
}

/// (creep) that was not given: the most significant strain of all interior edges, or of a group.
std::optional<EpochChain::Changes::CommonStrain> EpochChain::common_strain(
    const EvidenceTest& test, const std::vector<LengthChange>& let_go) const {
    const std::vector<int>& interior = m_net.interior_edges();
    std::vector<std::pair<std::string, std::vector<int>>> groups{{"", interior}};
    for (const auto& [name, edges] : m_net.data().groups) {
        groups.emplace_back(name, std::vector<int>());
        std::ranges::copy_if(edges, std::back_inserter(groups.back().second),
                             [&](int edge) { return std::ranges::binary_search(interior, edge); });
    }
    std::optional<Changes::CommonStrain> found;
    double least = snooping_threshold(default_false_alarm_rate, groups.size(), 1);
    for (const auto& [name, edges] : groups) {
        Eigen::VectorXd lengths = Eigen::VectorXd::Zero(size());
        for (const int edge : edges) {
            lengths(place_of(edge)) = m_net.unstressed_lengths()(edge);
        }
        for (const LengthChange& change : let_go) {
            lengths(place_of(change.edge)) = 0.0;
        }
        const auto [strain, std] = test.change_along(lengths);
        if (std::pow(strain / std, 2) > least) {
            least = std::pow(strain / std, 2);
            found = {.group = name, .strain = strain, .std = std};
        }
    }
    return found;
}

/// Reports the factor by which all strokes are off, as with a wrong pitch.
void EpochChain::set_stroke_factor(Changes& changes, const EvidenceTest& test,
                                   const std::vector<EdgeTurned>& turned) const {
    Eigen::VectorXd strokes = Eigen::VectorXd::Zero(size());
    for (const EdgeTurned& one : turned) {
        const auto has_changed = std::ranges::find(changes.lengths, one.edge, &LengthChange::edge);
        if (has_changed == changes.lengths.end()) {
            strokes(place_of(one.edge)) = one.stroke;
        }
    }
    const auto [more, std] = test.change_along(strokes);
    if (std::isfinite(std)) {
        changes.stroke_factor = 1.0 + more;
        changes.stroke_factor_std = std;
    }
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
        const double std = m_states.back().found.edges[static_cast<size_t>(i)].std;
        squares += std::pow(moved(i) / std, 2);
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

/// (epoch-repeat)
double EpochChain::difference_ratio(size_t a, size_t b) const {
    constexpr int few = 8;
    const auto errors_of = [&](size_t k, int node) -> Eigen::Vector3d {
        return m_states[k].survey->form.col(node) - m_states[k].found.predicted.form.col(node);
    };
    const auto is_in_use = [&](size_t k, int node) {
        return std::ranges::find(m_states[k].found.outliers, node, &Outlier::node) ==
               m_states[k].found.outliers.end();
    };
    std::vector<int> both;
    std::ranges::set_intersection(m_states[a].survey->surveyed, m_states[b].survey->surveyed,
                                  std::back_inserter(both));
    std::erase_if(both, [&](int node) { return !is_in_use(a, node) || !is_in_use(b, node); });
    if (std::ssize(both) < few) {
        return 0.0;
    }
    double of_difference = 0.0;
    double of_both = 0.0;
    for (const int node : both) {
        const Eigen::Array3d variances = m_states[a].survey->noise_std.col(node).array().square() +
                                         m_states[b].survey->noise_std.col(node).array().square();
        const Eigen::Array3d first = errors_of(a, node);
        const Eigen::Array3d second = errors_of(b, node);
        for (int axis = 0; axis < 3; ++axis) {
            if (variances(axis) > 0.0) {
                of_difference += std::pow(first(axis) - second(axis), 2) / variances(axis);
                of_both += (std::pow(first(axis), 2) + std::pow(second(axis), 2)) / variances(axis);
            }
        }
    }
    return of_both > 0.0 ? std::sqrt(of_difference / of_both) : 0.0;
}

}  // namespace taut
