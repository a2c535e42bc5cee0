// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/epoch_changes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "estimation/hypotheses.hpp"
#include "taut/estimation/diagnostics.hpp"

namespace taut {
namespace {

/// By how many of its standard deviations the factor on all strokes is not 1.
double stroke_factor_statistic(const EpochChanges& changes) {
    return changes.stroke_factor_std > 0.0
               ? std::abs(changes.stroke_factor - 1.0) / changes.stroke_factor_std
               : 0.0;
}

/// Whether chance explains all but a change along one direction of this statistic.
bool is_chance_but_for(Agreement all, double statistic) {
    all.squares = std::max(0.0, all.squares - statistic * statistic);
    --all.rank;
    return all.ratio() <= all.limit();
}

bool is_among(const std::vector<LengthChange>& changes, int edge) {
    return std::ranges::find(changes, edge, &LengthChange::edge) != changes.end();
}

/// (epoch-change)
std::optional<LengthChange> worst_change(const EvidenceTest::Changes& changes,
                                         const EpochEntries& entries,
                                         const std::vector<int>& edges) {
    const auto worst = std::ranges::max_element(
        edges, {}, [&](int edge) { return changes.statistic(entries.place_of(edge)); });
    if (worst == edges.end()) {
        return std::nullopt;
    }
    const Eigen::Index place = entries.place_of(*worst);
    const double statistic = changes.statistic(place);
    if (statistic * statistic <= snooping_threshold(default_false_alarm_rate, edges.size(), 1)) {
        return std::nullopt;
    }
    return LengthChange{.edge = *worst,
                        .change = changes.change(place),
                        .std_dev = changes.std_dev(place),
                        .statistic = statistic};
}

/// Whether a wrong sign, unit or pitch of all turns explains what was let go: most of the turns,
/// with all else as chance has it.
bool are_explained_by_strokes(const std::vector<LengthChange>& let_go,
                              const EpochChanges& all_at_once,
                              const std::vector<EdgeTurned>& turned) {
    const auto of_turns = std::ranges::count_if(let_go, [&](const LengthChange& change) {
        return std::ranges::find(turned, change.edge, &EdgeTurned::edge) != turned.end();
    });
    return all_at_once.are_strokes_off() && of_turns >= 2 &&
           3 * of_turns >= 2 * std::ssize(turned) &&
           is_chance_but_for(all_at_once.agreement, stroke_factor_statistic(all_at_once));
}

/// Whether a strain in common explains all, and better than the change of one length: of a run that
/// slides, both are a change of its sum.
bool is_explained_by_strain(const EpochChanges& all_at_once,
                            const std::vector<LengthChange>& let_go) {
    constexpr double better = 1.05;
    const std::optional<EpochChanges::CommonStrain>& strain = all_at_once.common_strain;
    if (!strain || all_at_once.are_strokes_off()) {
        return false;
    }
    const double statistic = std::abs(strain->strain) / strain->std_dev;
    return is_chance_but_for(all_at_once.agreement, statistic) &&
           (let_go.empty() || statistic > better * let_go.front().statistic);
}

/// (creep) that was not given: the most significant strain of all interior edges, or of a group,
/// but for lengths let go.
std::optional<EpochChanges::CommonStrain> common_strain(const EvidenceTest& test,
                                                        const CableNet& net,
                                                        const EpochEntries& entries,
                                                        const std::vector<LengthChange>& let_go) {
    const std::vector<int>& interior = net.interior_edges();
    std::vector<std::pair<std::string, std::vector<int>>> groups{{"", interior}};
    for (const auto& [name, edges] : net.data().groups) {
        groups.emplace_back(name, std::vector<int>());
        std::ranges::copy_if(edges, std::back_inserter(groups.back().second),
                             [&](int edge) { return std::ranges::binary_search(interior, edge); });
    }
    std::optional<EpochChanges::CommonStrain> found;
    double least = snooping_threshold(default_false_alarm_rate, groups.size(), 1);
    for (const auto& [name, edges] : groups) {
        Eigen::VectorXd lengths = Eigen::VectorXd::Zero(entries.size());
        for (const int edge : edges) {
            if (!is_among(let_go, edge)) {
                lengths(entries.place_of(edge)) = net.unstressed_lengths()(edge);
            }
        }
        const auto [strain, std_dev] = test.change_along(lengths);
        if (std::pow(strain / std_dev, 2) > least) {
            least = std::pow(strain / std_dev, 2);
            found = {.group = name, .strain = strain, .std_dev = std_dev};
        }
    }
    return found;
}

/// Sets the factor by which all strokes are off, as with a wrong pitch, but those of lengths let
/// go.
void set_stroke_factor(EpochChanges& changes, const EvidenceTest& test, const EpochEntries& entries,
                       const std::vector<EdgeTurned>& turned) {
    Eigen::VectorXd strokes = Eigen::VectorXd::Zero(entries.size());
    for (const EdgeTurned& one : turned) {
        if (!is_among(changes.lengths, one.edge)) {
            strokes(entries.place_of(one.edge)) = one.stroke;
        }
    }
    const auto [more, std_dev] = test.change_along(strokes);
    if (std::isfinite(std_dev)) {
        changes.stroke_factor = 1.0 + more;
        changes.stroke_factor_std = std_dev;
    }
}

/// Standard deviation of the turns besides the one given; 0 where chance explains them [m].
double excess_actuator_std(const EvidenceTest& test, const EpochEntries& entries,
                           const std::vector<LengthChange>& let_go,
                           const std::vector<int>& scattering) {
    std::vector<Eigen::Index> places;
    for (const int edge : scattering) {
        if (!is_among(let_go, edge)) {
            places.push_back(entries.place_of(edge));
        }
    }
    const Agreement of_turns = test.agreement(places);
    return of_turns.ratio() > of_turns.limit() ? test.spread(places) : 0.0;
}

}  // namespace

bool EpochChanges::are_strokes_off() const {
    return stroke_factor_statistic(*this) > significant_std;
}

Eigen::Index EpochEntries::place_of(int edge) const {
    return std::ranges::lower_bound(edges, edge) - edges.begin();
}

bool are_too_many_changes(const CableNet& net, size_t changes) {
    constexpr double most = 0.1;  // of all edges
    constexpr double a_few = 3.0;
    return static_cast<double>(changes) > std::max(a_few, most * net.edge_count());
}

std::optional<SlipOrTarget> slip_to_target(const CableNet& net, const Survey& survey,
                                           const Points& form, const Outlier& target) {
    constexpr double along = 0.87;       // cosine: 30 degrees
    constexpr double straight = -0.866;  // 30 degrees
    const int node = target.node;
    const Eigen::Vector3d moved = survey.form.col(node) - form.col(node);
    const auto direction = [&](int edge) -> Eigen::Vector3d {
        const auto [s, t] = net.edges()[edge];
        return (form.col(s == node ? t : s) - form.col(node)).normalized();
    };
    // Where a run slides, each survey has lengths of its own anyway.
    const bool slides = std::ranges::any_of(net.sliding_nodes(),
                                            [&](const SlidingNode& at) { return at.node == node; });
    if (net.is_support(node) || slides || !(moved.norm() > 0.0)) {
        return std::nullopt;
    }
    for (const int towards : net.edges_at(node)) {
        for (const int from : net.edges_at(node)) {
            const Eigen::Vector3d d = direction(towards);
            if (net.is_strut(towards) || net.is_strut(from) ||
                d.dot(moved) < along * moved.norm() || d.dot(direction(from)) > straight) {
                continue;
            }
            const LengthChange shorter{.edge = towards,
                                       .change = -d.dot(moved),
                                       .std_dev = survey.noise_std.col(node).norm(),
                                       .statistic = std::sqrt(target.statistic)};
            LengthChange longer = shorter;
            longer.edge = from;
            longer.change = d.dot(moved);
            return SlipOrTarget{.node = node, .lengths = {shorter, longer}};
        }
    }
    return std::nullopt;
}

void take_out_slips(const CableNet& net, std::vector<LengthChange>& changes,
                    std::vector<SlipOrTarget>& found) {
    constexpr double nearly = 3.0;  // standard deviations
    for (size_t a = 0; a < changes.size(); ++a) {
        for (size_t b = a + 1; b < changes.size(); ++b) {
            const LengthChange one = changes[a];
            const LengthChange other = changes[b];
            const auto [s, t] = net.edges()[one.edge];
            const Edge& ends = net.edges()[other.edge];
            const int node = std::ranges::find(ends, s) != ends.end() ? s : t;
            if (one.change * other.change < 0.0 && !net.is_support(node) &&
                std::ranges::find(ends, node) != ends.end() &&
                std::abs(one.change + other.change) <
                    nearly * std::hypot(one.std_dev, other.std_dev)) {
                found.push_back({.node = node, .lengths = {one, other}});
                std::erase_if(changes, [&](const LengthChange& change) {
                    return change.edge == one.edge || change.edge == other.edge;
                });
                take_out_slips(net, changes, found);
                return;
            }
        }
    }
}

std::vector<LengthChange> let_go_changed(EvidenceTest& test, const CableNet& net,
                                         const EpochEntries& entries,
                                         const std::vector<int>& edges) {
    std::vector<LengthChange> result;
    std::optional<LengthChange> worst = worst_change(test.changes(), entries, edges);
    while (worst && !are_too_many_changes(net, result.size())) {
        result.push_back(*worst);
        test.let_go(entries.place_of(worst->edge));
        worst = worst_change(test.changes(), entries, edges);
    }
    return result;
}

ComparedEpoch compared_epoch(EvidenceTest test, const CableNet& net, const EpochEntries& entries,
                             const std::vector<EdgeTurned>& turned,
                             const std::vector<int>& scattering) {
    EpochChanges all_at_once;
    all_at_once.agreement = test.agreement();
    all_at_once.common_strain = common_strain(test, net, entries, {});
    if (turned.size() > 1) {
        set_stroke_factor(all_at_once, test, entries, turned);
    }
    std::vector<LengthChange> let_go = let_go_changed(test, net, entries, entries.edges);
    if (are_explained_by_strokes(let_go, all_at_once, turned)) {
        all_at_once.common_strain.reset();
        all_at_once.is_of_all_turns = true;
        return {.changes = std::move(all_at_once), .let_go = std::move(let_go)};
    }
    if (is_explained_by_strain(all_at_once, let_go)) {
        return {.changes = std::move(all_at_once), .let_go = std::move(let_go)};
    }
    EpochChanges changes;
    changes.lengths = let_go;
    changes.agreement = test.agreement();
    set_stroke_factor(changes, test, entries, turned);
    if (!changes.are_strokes_off()) {
        changes.common_strain = common_strain(test, net, entries, let_go);
    }
    if (!changes.common_strain) {
        changes.excess_actuator_std = excess_actuator_std(test, entries, let_go, scattering);
    }
    return {.changes = std::move(changes), .let_go = std::move(let_go)};
}

}  // namespace taut
