// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/hypotheses.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <iterator>
#include <utility>

#include "estimation/detectable_error.hpp"

namespace taut {
namespace {
using State = Hypothesis::State;
using Test = Hypothesis::Test;
using Family = Hypotheses::Family;

/// By Suspect.
constexpr std::array families{Family::targets, Family::forces,   Family::forces,  Family::lengths,
                              Family::lengths, Family::boundary, Family::boundary};

Family family_of(const Hypothesis& hypothesis) {
    return families.at(static_cast<size_t>(hypothesis.kind));
}

bool is_of_boundary(const Hypothesis& hypothesis) {
    return family_of(hypothesis) == Family::boundary;
}

/// Whether it is about others, which are hypotheses themselves.
bool is_joint(const Hypothesis& hypothesis) {
    return hypothesis.is_pair() || hypothesis.kind == Suspect::force_scale;
}

/// The nodes where the score of a hypothesis counts.
std::span<const int> nodes_of(const Hypothesis& hypothesis) {
    return {hypothesis.nodes.begin(), std::ranges::find(hypothesis.nodes, -1)};
}

/// @return the largest at each node and the nodes next to it (n)
Eigen::VectorXd largest_nearby(const CableNet& net, const Eigen::VectorXd& scores) {
    Eigen::VectorXd result = scores;
    for (const auto& [s, t] : net.edges()) {
        result(s) = std::max(result(s), scores(t));
        result(t) = std::max(result(t), scores(s));
    }
    return result;
}

/// The largest score within two edges of a node of a hypothesis, of which an edge has two: an error
/// shows in the tests around it, too.
auto largest_around(const CableNet& net, const Eigen::VectorXd& scores) {
    Eigen::VectorXd near = largest_nearby(net, scores);
    Eigen::VectorXd far = largest_nearby(net, near);
    return [near = std::move(near), far = std::move(far)](const Hypothesis& one, int node) {
        return one.nodes[1] < 0 ? far(node) : near(node);
    };
}

/// Counts the values of some hypotheses at their nodes (n), the largest at each.
template <class Value>
Eigen::VectorXd largest_at_nodes(const CableNet& net, const std::vector<Hypothesis>& all,
                                 const Value& value_of) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(net.node_count());
    for (const Hypothesis& hypothesis : all) {
        const double value = value_of(hypothesis);
        for (const int node : nodes_of(hypothesis)) {
            result(node) = std::max(result(node), value);
        }
    }
    return result;
}

}  // namespace

double snooping_threshold(double false_alarm_rate, size_t tests, int degrees_of_freedom) {
    if (!(false_alarm_rate > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const double of_one = -std::expm1(std::log1p(-false_alarm_rate) / static_cast<double>(tests));
    return boost::math::quantile(boost::math::complement(
        boost::math::chi_squared_distribution<>(degrees_of_freedom), of_one));
}

double Hypothesis::score() const {
    constexpr double unit = 20.0;  // about the threshold of one degree of freedom
    return std::max(0.0, 1.0 + (statistic - threshold) / unit);
}

Hypotheses::Hypotheses(const CableNet& net, std::vector<Hypothesis> all)
    : m_net(&net), m_all(std::move(all)) {}

std::span<const Hypothesis> Hypotheses::of(Suspect kind) const {
    return {std::ranges::lower_bound(m_all, kind, {}, &Hypothesis::kind),
            std::ranges::upper_bound(m_all, kind, {}, &Hypothesis::kind)};
}

std::span<Hypothesis> Hypotheses::of(Suspect kind) {
    return {std::ranges::lower_bound(m_all, kind, {}, &Hypothesis::kind),
            std::ranges::upper_bound(m_all, kind, {}, &Hypothesis::kind)};
}

Hypothesis* Hypotheses::find(Suspect kind, int index) {
    const std::span<Hypothesis> same = of(kind);
    const auto found = std::ranges::lower_bound(same, index, {}, &Hypothesis::index);
    return found != same.end() && found->index == index ? &*found : nullptr;
}

bool Hypotheses::release_edge(int edge) {
    const std::vector<int>& interior = m_net->interior_edges();
    const auto found = std::ranges::lower_bound(interior, edge);
    const bool is_interior = found != interior.end() && *found == edge;
    Hypothesis* const length =
        is_interior ? find(Suspect::length, static_cast<int>(found - interior.begin()))
                    : find(Suspect::adjustable_edge, edge);
    if (length == nullptr || length->is_released() || !std::isfinite(length->threshold) ||
        !is_active(family_of(*length)) || (is_interior && released_lengths()[length->index])) {
        return false;
    }
    length->state = State::released;
    return true;
}

bool Hypotheses::is_active(Family family) const {
    return (family != Family::lengths || m_given_up == 0) &&
           std::ranges::any_of(m_all, [&](const Hypothesis& hypothesis) {
               return family_of(hypothesis) == family && std::isfinite(hypothesis.threshold);
           });
}

double Hypotheses::threshold(Suspect kind) const {
    return of(kind).empty() ? std::numeric_limits<double>::infinity() : of(kind)[0].threshold;
}

void Hypotheses::begin_tests() {
    for (Hypothesis& hypothesis : m_all) {
        hypothesis.test = is_of_boundary(hypothesis) ? hypothesis.test : Test::none;
    }
}

void Hypotheses::reopen() {
    for (Hypothesis& hypothesis : m_all) {
        if (hypothesis.state == State::readmitted) {
            hypothesis.state = State::in_use;
        }
    }
}

void Hypotheses::readmit_all() {
    for (Hypothesis& hypothesis : m_all) {
        hypothesis.state = State::in_use;
    }
}

void Hypotheses::release_outliers(Suspect kind) {
    for (Hypothesis& hypothesis : of(kind)) {
        if (!hypothesis.is_released() && hypothesis.is_outlier()) {
            hypothesis.state = State::released;
        }
    }
}

void Hypotheses::release_forces() {
    for (Hypothesis& force : of(Suspect::force)) {
        force.state = State::released_for_good;
    }
}

void Hypotheses::set_pair(Hypothesis& pair, bool is_released) {
    const std::span<Hypothesis> lengths = of(Suspect::length);
    lengths[pair.index].state = State::in_use;
    lengths[pair.other].state = State::in_use;
    pair.state = is_released ? State::released : State::in_use;
}

bool Hypotheses::revise(BoundaryTest boundary) {
    const auto all = [&](const Hypothesis& one) {
        return boundary != BoundaryTest::none || !is_of_boundary(one);
    };
    const Eigen::VectorXd scores = this->scores(all);
    const double largest = std::max(1.0, scores.maxCoeff());
    const bool has_force = release_force(largest);
    const bool has_other = release(scores, 1.0, [&](const Hypothesis& one) {
        return is_of_boundary(one) ? boundary == BoundaryTest::at_once
                                   : !has_force || one.kind != Suspect::target;
    });
    bool has_changed = has_force || has_other;
    if (!has_changed && boundary == BoundaryTest::one_by_one) {
        // A score below this part of the largest may be caused by it, however far away, at the
        // other end of a cable for instance.
        constexpr double least_of_largest = 0.9;
        has_changed = release(scores, std::max(1.0, least_of_largest * largest), is_of_boundary);
    }
    has_changed = has_changed || readmit(all);
    if (has_too_many(Family::lengths)) {
        give_up_lengths();
        has_changed = true;
    }
    return has_changed;
}

/// Whether it may be released: it shares no length with one that is.
bool Hypotheses::is_open(const Hypothesis& hypothesis,
                         const std::vector<bool>& released_lengths) const {
    const bool is_free = family_of(hypothesis) != Family::lengths ||
                         (!released_lengths[hypothesis.index] &&
                          (!hypothesis.is_pair() || !released_lengths[hypothesis.other]));
    return hypothesis.test != Test::none && hypothesis.state == State::in_use && is_free;
}

/// The largest (score) of those that may be released at each node (n).
Eigen::VectorXd Hypotheses::scores(const Filter& is_candidate) const {
    const std::vector<bool> released = released_lengths();
    return largest_at_nodes(*m_net, m_all, [&](const Hypothesis& hypothesis) {
        return is_candidate(hypothesis) && is_open(hypothesis, released) ? hypothesis.score() : 0.0;
    });
}

/// Releases the outliers with the largest score within two edges. A normal prior tolerates what a
/// bounded one does not: where nothing there exceeds its threshold by the normal statistic, the
/// largest core statistic decides.
/// @param least score to exceed
bool Hypotheses::release(const Eigen::VectorXd& scores, double least, const Filter& is_candidate) {
    std::vector<bool> released = released_lengths();
    const auto may_release = [&](const Hypothesis& hypothesis) {
        return is_candidate(hypothesis) && is_open(hypothesis, released) &&
               hypothesis.is_outlier() && (least <= 1.0 || hypothesis.score() > least);
    };
    const auto largest = largest_around(*m_net, scores);
    const auto largest_core =
        largest_around(*m_net, largest_at_nodes(*m_net, m_all, [&](const Hypothesis& hypothesis) {
            return may_release(hypothesis) ? hypothesis.core_statistic : 0.0;
        }));
    bool has_changed = false;
    for (Hypothesis& hypothesis : m_all) {
        const auto stands_out = [&](int node) {
            const double around = largest(hypothesis, node);
            return hypothesis.score() >= around ||
                   (around < 1.0 && hypothesis.core_statistic >= largest_core(hypothesis, node));
        };
        if (family_of(hypothesis) == Family::forces || !may_release(hypothesis) ||
            !std::ranges::all_of(nodes_of(hypothesis), stands_out)) {
            continue;
        }
        hypothesis.state = State::released;
        hypothesis.confounded_with = confounded_with(hypothesis);
        if (family_of(hypothesis) == Family::lengths) {
            released[hypothesis.index] = true;
            released[hypothesis.is_pair() ? hypothesis.other : hypothesis.index] = true;
        }
        has_changed = true;
    }
    return has_changed;
}

/// A force measurement affects the whole net: the largest is released before any target; all of
/// them where they stand out together more than each by itself.
/// @param than score to exceed
bool Hypotheses::release_force(double than) {
    Hypothesis* worst = nullptr;
    for (const Suspect kind : {Suspect::force, Suspect::force_scale}) {
        for (Hypothesis& hypothesis : of(kind)) {
            if (is_open(hypothesis, {}) && hypothesis.score() > than &&
                (worst == nullptr || hypothesis.statistic > worst->statistic)) {
                worst = &hypothesis;
            }
        }
    }
    if (worst == nullptr) {
        return false;
    }
    worst->state = State::released;
    if (worst->kind == Suspect::force_scale) {
        release_forces();
    }
    return true;
}

bool Hypotheses::readmit(const Filter& is_candidate) {
    bool has_changed = false;
    for (Hypothesis& hypothesis : m_all) {
        if (is_candidate(hypothesis) && hypothesis.test != Test::none &&
            hypothesis.state == State::released && !hypothesis.is_outlier()) {
            hypothesis.state = State::readmitted;
            has_changed = true;
        }
    }
    return has_changed;
}

/// Ends the tests of the lengths, with all their priors restored.
void Hypotheses::give_up_lengths() {
    m_given_up = released_count(Family::lengths);
    for (Hypothesis& hypothesis : m_all) {
        if (family_of(hypothesis) == Family::lengths) {
            hypothesis.state = State::in_use;
            hypothesis.test = Test::none;
        }
    }
}

/// A support moved along an edge has the effect of another length of that edge.
/// @return the edge or support that would explain nearly as much; -1: none
int Hypotheses::confounded_with(const Hypothesis& hypothesis) const {
    constexpr double nearly = 0.5;  // of the score
    if (family_of(hypothesis) != Family::boundary) {
        return -1;
    }
    const bool is_support = hypothesis.kind == Suspect::support;
    int result = -1;
    double best = nearly * hypothesis.score();
    for (const Hypothesis& other : of(is_support ? Suspect::adjustable_edge : Suspect::support)) {
        const Hypothesis& support = is_support ? hypothesis : other;
        const Hypothesis& edge = is_support ? other : hypothesis;
        if (std::ranges::find(edge.nodes, support.index) != edge.nodes.end() &&
            other.score() > best) {
            best = other.score();
            result = other.index;
        }
    }
    return result;
}

std::vector<Hypothesis> Hypotheses::found(Suspect kind) const {
    std::vector<Hypothesis> result;
    std::ranges::copy_if(of(kind), std::back_inserter(result), &Hypothesis::is_released);
    std::ranges::stable_sort(result, std::greater{}, &Hypothesis::largest_statistic);
    return result;
}

std::vector<int> Hypotheses::released(Suspect kind) const {
    std::vector<int> result;
    for (const Hypothesis& hypothesis : of(kind)) {
        if (hypothesis.is_released()) {
            result.push_back(hypothesis.index);
        }
    }
    return result;
}

std::vector<bool> Hypotheses::is_released(Suspect kind, int count) const {
    std::vector<bool> result(count, false);
    for (const int index : released(kind)) {
        result[index] = true;
    }
    return result;
}

std::vector<bool> Hypotheses::released_lengths() const {
    std::vector<bool> result =
        is_released(Suspect::length, static_cast<int>(of(Suspect::length).size()));
    for (const Hypothesis& pair : of(Suspect::pair)) {
        if (pair.is_released()) {
            result[pair.index] = true;
            result[pair.other] = true;
        }
    }
    return result;
}

int Hypotheses::released_count(Family family) const {
    return static_cast<int>(std::ranges::count_if(m_all, [&](const Hypothesis& hypothesis) {
        return family_of(hypothesis) == family && hypothesis.is_released();
    }));
}

int Hypotheses::suspicious_count(Family family) const {
    return static_cast<int>(std::ranges::count_if(m_all, [&](const Hypothesis& hypothesis) {
        return family_of(hypothesis) == family && !hypothesis.is_released() &&
               hypothesis.is_outlier();
    }));
}

/// More than a part of all that are tested, and than a few, are too many.
bool Hypotheses::is_too_many(Family family, int count) const {
    struct Limit {
        double part;
        double few;
    };
    constexpr std::array limits{Limit{0.25, 0.0}, Limit{1.0, 0.0}, Limit{0.1, 3.0},
                                Limit{0.25, 3.0}};  // by Family
    const auto [part, few] = limits.at(static_cast<size_t>(family));
    const auto all = std::ranges::count_if(m_all, [&](const Hypothesis& hypothesis) {
        return family_of(hypothesis) == family && !is_joint(hypothesis);
    });
    return count > std::max(few, part * static_cast<double>(all));
}

bool Hypotheses::may_be_boundary() const {
    const Eigen::VectorXd found =
        largest_at_nodes(*m_net, m_all, [&](const Hypothesis& hypothesis) {
            return hypothesis.is_released() && !is_of_boundary(hypothesis) ? 1.0 : 0.0;
        });
    const Eigen::VectorXd near = largest_nearby(*m_net, largest_nearby(*m_net, found));
    return std::ranges::any_of(m_all, [&](const Hypothesis& hypothesis) {
        return is_of_boundary(hypothesis) &&
               (hypothesis.is_outlier() || std::ranges::any_of(nodes_of(hypothesis), [&](int node) {
                    return near(node) > 0.0;
                }));
    });
}

double Hypotheses::cost() const {
    double sum = 0.0;
    for (const Hypothesis& hypothesis : m_all) {
        // A pair beside its target costs nothing more than the target, all forces than each.
        const bool is_counted =
            !is_joint(hypothesis) || (hypothesis.is_pair() && hypothesis.state == State::released);
        sum += hypothesis.is_released() && is_counted ? hypothesis.threshold : 0.0;
    }
    return sum;
}

double Hypotheses::detectable(Suspect kind) const {
    std::vector<TestedItem> tested;
    for (const Hypothesis& hypothesis : of(kind)) {
        if (hypothesis.test == Test::in_use) {
            const int k = hypothesis.degrees_of_freedom;
            tested.push_back({hypothesis.noncentrality.topLeftCorner(k, k)});
        }
    }
    return tested.empty()
               ? std::numeric_limits<double>::infinity()
               : detectable_error(tested, threshold(kind), of(kind)[0].degrees_of_freedom);
}

}  // namespace taut
