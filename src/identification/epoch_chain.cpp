// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/epoch_chain.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

#include "estimation/data_snooping.hpp"
#include "identification/unknown_estimates.hpp"
#include "taut/statics/equilibrium.hpp"

namespace taut {
namespace {

/// Of a length that changed in between, by anything [m].
constexpr double std_of_change = 0.1;

bool is_common_number(const Unknown& unknown) {
    return unknown.kind == Unknown::Kind::stiffness || unknown.kind == Unknown::Kind::temperature ||
           unknown.kind == Unknown::Kind::loads;
}

double largest_play(std::span<const Epoch> epochs) {
    double play = 0.0;
    for (const Epoch& epoch : epochs) {
        for (const EdgeTurned& one : epoch.turned) {
            play = std::max(play, one.std);
        }
    }
    return play;
}

}  // namespace

bool are_too_many_changes(const CableNet& net, size_t changes) {
    constexpr double most = 0.1;  // of all edges
    constexpr double a_few = 3.0;
    return static_cast<double>(changes) > std::max(a_few, most * net.edge_count());
}

double widest_turn(const CableNet& net) {
    constexpr double wide = 0.05;  // [m]
    constexpr double most = 0.25;  // of the shortest edge: no wider may be unknown
    const Eigen::VectorXd lengths = net.unstressed_lengths()(net.adjustable_edges());
    if (lengths.size() == 0) {
        return 0.0;
    }
    const double width = std::min(wide, most * lengths.minCoeff());
    const double digit = std::pow(10.0, std::floor(std::log10(width)));
    return digit * std::floor(width / digit);  // as one would tell it
}

CableNet settled_net(const CableNet& net, std::span<const EdgeTurned> turned) {
    if (turned.empty()) {
        return net;
    }
    const CableNet changed = turned_net(net, turned);
    const Equilibrium equilibrium = solve_equilibrium(changed);
    if (!equilibrium.balanced()) {
        throw std::invalid_argument("the net as turned finds no equilibrium");
    }
    CableNetData data = changed.data();
    data.nodes = equilibrium.form;
    data.loads = net.loads();
    data.mass.resize(0);  // its weight is among the loads
    return CableNet(std::move(data));
}

EpochChain::EpochChain(const CableNet& net, std::span<const Epoch> epochs,
                       const IdentifyOptions& options, const LengthLaw& law, double least_play)
    : m_net(net),
      m_options(options),
      m_law(law),
      m_widest_turn(widest_turn(net)),
      m_unknowns(options.unknowns),
      m_common(static_cast<int>(std::ranges::count_if(options.unknowns, is_common_number))),
      m_changes(epochs.size()) {
    const double play = std::max(least_play, largest_play(epochs));
    const bool is_told = std_of(m_unknowns, Unknown::Kind::adjustable) > 0.0;
    if (play > 0.0 && !is_told) {
        m_unknowns.push_back({.kind = Unknown::Kind::adjustable, .std = play, .group = {}});
    }
    m_edges = net_to_fit(net, m_unknowns).interior_edges();
    const bool has_adjustable = is_told || play > 0.0;
    Eigen::VectorXd stds = adjustable_stds(net, options.unknowns);
    std::vector<std::vector<EdgeTurned>> steps;
    for (const Epoch& epoch : epochs) {
        for (const int edge : net.adjustable_edges()) {
            stds(edge) = std::hypot(stds(edge), least_play);
        }
        for (const EdgeTurned& one : epoch.turned) {
            stds(one.edge) = std::hypot(stds(one.edge), one.std);
        }
        steps.push_back(epoch.turned);
        m_states.push_back({.net = settled_net(net, all_turned(steps)),
                            .survey = &epoch.survey,
                            .turned = &epoch.turned,
                            .stds = has_adjustable ? stds : Eigen::VectorXd(),
                            .step = {},
                            .earlier = no_evidence(size()),
                            .later = no_evidence(size()),
                            .own = no_evidence(size()),
                            .found = {}});
    }
    for (size_t k = 0; k + 1 < m_states.size(); ++k) {
        m_states[k].step = step_to(k + 1, epochs[k + 1].turned, least_play);
    }
}

/// Of x at an epoch before any survey.
Eigen::VectorXd EpochChain::prior_of(const State& state) const {
    Eigen::VectorXd variances = Eigen::VectorXd::Ones(size());
    for (size_t i = 0; i < m_edges.size(); ++i) {
        const bool is_adjustable = std::ranges::binary_search(m_net.adjustable_edges(), m_edges[i]);
        const double std = is_adjustable ? state.stds(m_edges[i]) : m_law.std();
        variances(static_cast<Eigen::Index>(i)) = std * std;
    }
    return variances;
}

EpochStep EpochChain::step_to(size_t k, const std::vector<EdgeTurned>& turned,
                              double least_play) const {
    EpochStep step{.factor = Eigen::VectorXd::Ones(size()),
                   .added = Eigen::VectorXd::Zero(size()),
                   .prior_from = prior_of(m_states[k - 1]),
                   .prior_to = prior_of(m_states[k])};
    for (size_t i = 0; i < m_edges.size(); ++i) {
        const int edge = m_edges[i];
        if (std::ranges::binary_search(m_net.adjustable_edges(), edge)) {
            const auto one = std::ranges::find(turned, edge, &EdgeTurned::edge);
            const double play = one != turned.end() ? one->std : 0.0;
            step.added(static_cast<Eigen::Index>(i)) = play * play + least_play * least_play;
        }
    }
    auto place = static_cast<Eigen::Index>(m_edges.size());
    for (const Unknown& unknown : m_unknowns) {
        if (unknown.kind == Unknown::Kind::temperature) {  // another day
            step.factor(place) = 0.0;
            step.added(place) = 1.0;
        }
        place += is_common_number(unknown) ? 1 : 0;
    }
    return step;
}

void EpochChain::let_go(size_t k, int edge) {
    const auto place = std::ranges::find(m_edges, edge) - m_edges.begin();
    EpochStep& step = m_states[k - 1].step;
    step.added(place) += std_of_change * std_of_change;
    step.prior_to(place) += std_of_change * std_of_change;
}

void EpochChain::let_go(const std::vector<Changes>& changes) {
    for (size_t k = 1; k < m_states.size(); ++k) {
        for (const LengthChange& change : changes[k].lengths) {
            if (std::ranges::binary_search(m_net.interior_edges(), change.edge)) {
                let_go(k, change.edge);
            }
        }
    }
}

Told EpochChain::told(int k) const {
    const State& state = m_states[k];
    Told result(m_law);
    result.unknowns = m_unknowns;
    if (k + 1 == count()) {
        result.forces = m_options.forces;
    }
    result.adjustable_stds = state.stds;
    if (state.earlier.root.cols() + state.later.root.cols() > 0) {
        LengthEvidence others = sum_of(state.earlier, state.later);
        others.root.resize(size(), state.earlier.root.cols() + state.later.root.cols());
        others.root << state.earlier.root, state.later.root;
        result.evidence = std::make_shared<LengthEvidence>(std::move(others));
    }
    return result;
}

void EpochChain::fit(size_t k, const Told& told, const Progress& progress) {
    if (progress.stopped()) {
        throw Interrupted();
    }
    State& state = m_states[k];
    IdentifiedEpoch epoch = identify_one_epoch(state.net, *state.survey, told, m_common);
    state.found = std::move(epoch.identification);
    state.own = std::move(epoch.own);
}

bool EpochChain::has_settled() const {
    return std::ranges::all_of(m_states, [](const State& state) {
        return state.found.status == IdentificationStatus::converged;
    });
}

/// (epoch-change)
std::optional<LengthChange> EpochChain::worst_change(const EvidenceTest::Changes& changes) const {
    Eigen::Index worst = 0;
    const Eigen::VectorXd lengths = changes.statistic.head(std::ssize(m_edges));
    const double statistic = lengths.maxCoeff(&worst);
    if (statistic * statistic <= snooping_threshold(default_false_alarm_rate, m_edges.size(), 1)) {
        return std::nullopt;
    }
    return LengthChange{.edge = m_edges[static_cast<size_t>(worst)],
                        .change = changes.change(worst),
                        .std = changes.std(worst),
                        .statistic = statistic};
}

/// So that no target is blamed for a turn that was told wrong.
Told EpochChain::told_of_form_alone(int k) const {
    Told result = told(k);
    result.adjustable_stds.setZero();
    for (const int edge : m_net.adjustable_edges()) {
        result.adjustable_stds(edge) = std::max(m_states[k].stds(edge), m_widest_turn);
    }
    return result;
}

void EpochChain::find_changes(const Progress& progress) {
    for (int k = 0; k < count(); ++k) {
        fit(k, told_of_form_alone(k), progress);
    }
    if (!has_settled()) {
        return;
    }
    for (size_t k = 1; k < m_states.size(); ++k) {
        Changes& changes = m_changes[k];
        State& before = m_states[k - 1];
        State& state = m_states[k];
        progress("comparing surveys", static_cast<int>(k), count());
        state.earlier = carried(sum_of(before.earlier, before.own), before.step);
        EvidenceTest test(before.step.prior_to, state.earlier, state.own);
        std::optional<LengthChange> worst = worst_change(test.changes());
        while (worst && !are_too_many_changes(m_net, changes.lengths.size())) {
            changes.lengths.push_back(*worst);
            let_go(k, worst->edge);
            test.let_go(std::ranges::find(m_edges, worst->edge) - m_edges.begin());
            worst = worst_change(test.changes());
        }
        changes.ratio = test.ratio();
        tell_stroke_factor(changes, test, *state.turned);
        // What was let go is not told to later surveys.
        state.earlier = carried(sum_of(before.earlier, before.own), before.step);
    }
}

/// Whether all strokes are off by one factor, as with a pitch that was told wrong.
void EpochChain::tell_stroke_factor(Changes& changes, const EvidenceTest& test,
                                    const std::vector<EdgeTurned>& turned) const {
    Eigen::VectorXd strokes = Eigen::VectorXd::Zero(size());
    for (const EdgeTurned& one : turned) {
        const auto has_changed = std::ranges::find(changes.lengths, one.edge, &LengthChange::edge);
        if (has_changed == changes.lengths.end()) {
            strokes(std::ranges::find(m_edges, one.edge) - m_edges.begin()) = one.stroke;
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

bool EpochChain::settle(const Progress& progress) {
    constexpr int most_sweeps = 4;
    constexpr double still = 0.1;  // of the standard deviation, root mean square
    Eigen::VectorXd before;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        progress("identification", sweep, most_sweeps);
        for (size_t k = 0; k < m_states.size(); ++k) {
            fit(k, told(static_cast<int>(k)), progress);
            const State& state = m_states[k];
            if (state.found.status != IdentificationStatus::converged) {
                return false;
            }
            if (k + 1 < m_states.size()) {
                m_states[k + 1].earlier = carried(sum_of(state.earlier, state.own), state.step);
            }
        }
        const Eigen::VectorXd now = last_lengths();
        if (before.size() > 0) {
            double squares = 0.0;
            for (Eigen::Index i = 0; i < now.size(); ++i) {
                const double std = m_states.back().found.edges[static_cast<size_t>(i)].std;
                squares += std::pow((now(i) - before(i)) / std, 2);
            }
            if (squares < still * still * static_cast<double>(now.size())) {
                break;
            }
        }
        before = now;
        for (size_t k = m_states.size(); k-- > 1;) {
            const State& state = m_states[k];
            State& earlier = m_states[k - 1];
            earlier.later = carried(sum_of(state.own, state.later), earlier.step.reversed());
        }
    }
    progress("identification", most_sweeps, most_sweeps);
    return true;
}

}  // namespace taut
