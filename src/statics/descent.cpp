// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "statics/descent.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "statics/line_search.hpp"

namespace taut {
namespace {

/// Smallest shift that is tried once the stiffness was not positive definite, in axial stiffnesses.
constexpr double smallest_shift = smallest_relative_stiffness;

/// A shift above this makes steps so short that nothing is left of Newton's method.
constexpr double largest_shift = 1e3;

}  // namespace

Descent::Descent(const LocalNet& net)
    : m_state(net),
      m_trial(net),
      m_matrix(net),
      m_residual(net.loads.size()),
      m_direction(net.loads.size()) {
    m_factor.analyzePattern(m_matrix.upper());
}

DescentResult Descent::run(const LocalNet& net, double relative_tolerance, int max_steps,
                           std::vector<double>& energy_decreases) {
    m_trial.set_unstressed_lengths(net, m_state.unstressed_lengths());
    DescentResult result;
    double shift = 0.0;
    double previous = std::numeric_limits<double>::infinity();
    while (true) {
        const double imbalance = m_state.imbalance(net, relative_tolerance);
        result.balanced = imbalance <= 1.0;
        // Balanced, and either far below the tolerance or no longer getting better: rounding
        // errors.
        if (result.balanced && (imbalance <= 0.01 || imbalance > 0.5 * previous)) {
            return result;
        }
        if (result.steps >= max_steps || !find_direction(net, shift)) {
            return result;
        }
        const LineSearchStep step = search_line(net, m_state, m_direction, m_trial);
        if (!step.accepted) {
            shift = std::max(smallest_shift, 100.0 * shift);
            if (result.balanced || shift > largest_shift) {
                return result;
            }
            continue;
        }
        std::swap(m_state, m_trial);
        previous = imbalance;
        ++result.steps;
        energy_decreases.push_back(step.energy_decrease);
        // A full step shows that the model holds: back towards the pure Newton step. A short one
        // that the slack edges were not foreseen.
        if (step.length == 1.0) {
            shift = shift > 10.0 * smallest_shift ? 0.1 * shift : shift;
        } else if (step.length < 0.05) {
            shift = std::max(1e-6, 10.0 * shift);
        }
    }
}

/// Solves (H + shift D) d = -h. The shift grows until the matrix is positive definite.
bool Descent::find_direction(const LocalNet& net, double& shift) {
    while (shift <= largest_shift) {
        m_matrix.assemble(net, m_state.edges());
        if (shift > 0.0) {
            m_matrix.add_shift(shift);
        }
        m_factor.factorize(m_matrix.upper());
        if (m_factor.positive_definite()) {
            m_residual = -m_state.forces();
            m_direction = m_factor.solve(m_residual);
            if (m_direction.allFinite() && m_direction.dot(m_state.forces()) <= 0.0) {
                return true;
            }
        }
        shift = std::max(smallest_shift, 10.0 * shift);
    }
    return false;
}

bool Descent::has_loose_nodes(const LocalNet& net) {
    // Where every edge is taut the stiffness is positive definite, since each part of the net hangs
    // on a support. What is taut by rounding errors alone does not count.
    const auto clearly_taut = [](const EdgeState& e) { return e.extension > 1e-9 * e.length; };
    if (std::ranges::all_of(m_state.edges(), clearly_taut)) {
        return false;
    }
    m_matrix.assemble(net, m_state.edges());
    m_factor.factorize(m_matrix.upper());
    return taut::has_loose_nodes(m_matrix, m_factor);
}

}  // namespace taut
