// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "statics/line_search.hpp"

namespace taut {
namespace {

/// Smallest shift tried if the stiffness is not positive definite, in axial stiffnesses.
constexpr double smallest_shift = smallest_relative_stiffness;

/// A larger shift makes steps too short to be of use.
constexpr double largest_shift = 1e3;

/// A step cut by the line search below this length counts as short.
constexpr double shortest_fair_step = 0.05;

/// If the last full step left at most this share of the imbalance, the next step reuses its factor,
/// for a fifth of a Newton step's time. A Newton step reduces an error e to C e^2; a step with the
/// old factor reduces that by a factor of 2 C e: twice the share that the last step left.
constexpr double fast_contraction = 0.02;

}  // namespace

Descent::Descent(const LocalNet& net)
    : m_trial(net),
      m_direction(net.loads.size()),
      m_reach(std::numeric_limits<double>::infinity()) {
    if (!net.is_convex()) {
        constexpr double part_of_edge = 0.25;
        double sum = 0.0;
        for (const auto& [s, t] : net.edges) {
            sum += (net.nodes.col(s) - net.nodes.col(t)).norm();
        }
        m_reach = part_of_edge * sum / static_cast<double>(net.edges.size());
    }
}

DescentResult Descent::run(const LocalNet& net, Stiffness& stiffness, NetState& state,
                           double relative_tolerance, DescentLimits limits,
                           std::vector<double>& energy_decreases) {
    m_trial.set_unstressed_lengths(net, state.unstressed_lengths());
    DescentResult result;
    double shift = 0.0;
    int short_steps = 0;
    double previous = std::numeric_limits<double>::infinity();
    bool is_fast = false;  // the last step was full, and without a shift
    while (true) {
        const double imbalance = state.imbalance(net, relative_tolerance);
        result.balanced = imbalance <= 1.0;
        // Balanced, and either far below the tolerance or no longer improving: rounding errors.
        if (result.balanced && (imbalance <= 0.01 || imbalance > 0.5 * previous)) {
            return result;
        }
        const bool may_keep = is_fast && imbalance <= fast_contraction * previous;
        is_fast = false;
        if (result.steps >= limits.max_steps || short_steps >= limits.max_short_steps) {
            return result;
        }
        const bool keeps_factor = may_keep && solve(stiffness, state);
        if (!keeps_factor && !find_direction(net, stiffness, state, shift)) {
            return result;
        }
        bool is_cut = false;
        if (!net.is_convex()) {
            const double farthest =
                m_direction.reshaped(3, net.free_count).colwise().norm().maxCoeff();
            is_cut = farthest > m_reach;
            m_direction *= is_cut ? m_reach / farthest : 1.0;
        }
        const LineSearchStep step = search_line(net, state, m_direction, m_trial);
        if (!step.accepted) {
            if (keeps_factor) {  // retry with a new factor
                continue;
            }
            shift = std::max(smallest_shift, 100.0 * shift);
            if (result.balanced || shift > largest_shift) {
                return result;
            }
            continue;
        }
        std::swap(state, m_trial);
        previous = imbalance;
        ++result.steps;
        energy_decreases.push_back(step.energy_decrease);
        // A full step shows that the quadratic model is good: back towards the pure Newton step. A
        // short one shows that edges went slack or taut on the way.
        is_fast = step.length == 1.0 && shift == 0.0 && !is_cut;
        if (step.length == 1.0) {
            shift = shift > 10.0 * smallest_shift ? 0.1 * shift : shift;
        } else if (step.length < shortest_fair_step) {
            shift = std::clamp(10.0 * shift, 1e-6, largest_shift);
        }
        short_steps = step.length < shortest_fair_step ? short_steps + 1 : 0;
    }
}

/// Solves H d = -h with the present factor.
bool Descent::solve(const Stiffness& stiffness, const NetState& state) {
    m_direction = -state.forces();
    stiffness.factor.solve(m_direction);
    return m_direction.allFinite() && m_direction.dot(state.forces()) <= 0.0;
}

/// Solves (H + shift D) d = -h. The shift grows until the matrix is positive definite.
bool Descent::find_direction(const LocalNet& net, Stiffness& stiffness, const NetState& state,
                             double& shift) {
    while (shift <= largest_shift) {
        stiffness.matrix.assemble(net, state.edges());
        if (shift > 0.0) {
            stiffness.matrix.add_shift(shift);
        }
        if (stiffness.factorize() && solve(stiffness, state)) {
            return true;
        }
        shift = std::max(smallest_shift, 10.0 * shift);
    }
    return false;
}

bool is_unstable(const LocalNet& net, Stiffness& stiffness, const NetState& state) {
    if (net.is_convex()) {
        return false;
    }
    // A loose node has no stiffness, but no negative one: a shift above rounding errors holds it.
    stiffness.matrix.assemble(net, state.edges());
    stiffness.matrix.add_shift(smallest_shift);
    return !stiffness.factorize();
}

Eigen::VectorXd direction_of_collapse(const LocalNet& net, Stiffness& stiffness,
                                      const NetState& state) {
    // Inverse iteration with the least shift that makes the stiffness positive definite.
    constexpr int rounds = 8;
    double shift = smallest_shift;
    do {
        shift *= 3.0;
        stiffness.matrix.assemble(net, state.edges());
        stiffness.matrix.add_shift(shift);
    } while (!stiffness.factorize() && shift < largest_shift);
    // Without a pattern that a net could share.
    Eigen::VectorXd direction = Eigen::VectorXd::NullaryExpr(net.loads.size(), [](Eigen::Index i) {
        return std::sin(12.9898 * static_cast<double>(i + 1));
    });
    for (int round = 0; round < rounds; ++round) {
        stiffness.factor.solve(direction);
        direction /= direction.reshaped(3, net.free_count).colwise().norm().maxCoeff();
    }
    return direction;
}

bool is_mechanism(const LocalNet& net, Stiffness& stiffness, const NetState& state) {
    // If every edge is taut the stiffness is positive definite, since each part of the net hangs on
    // a support. Edges that are taut by rounding errors alone do not count.
    const auto clearly_taut = [](const EdgeState& e) { return e.extension > 1e-9 * e.length; };
    if (net.is_convex() && std::ranges::all_of(state.edges(), clearly_taut)) {
        return false;
    }
    stiffness.matrix.assemble(net, state.edges());
    stiffness.factorize();
    return stiffness.has_loose_nodes();
}

}  // namespace taut
