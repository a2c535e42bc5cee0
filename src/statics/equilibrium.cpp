// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/equilibrium.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "statics/line_search.hpp"
#include "statics/net_state.hpp"
#include "statics/stiffness_matrix.hpp"

namespace taut {
namespace {

/// Smallest shift that is tried once the stiffness was not positive definite, in axial stiffnesses.
constexpr double smallest_shift = 1e-12;

/// A shift above this makes steps so short that nothing is left of Newton's method.
constexpr double largest_shift = 1e3;

void check_arguments(const LocalNet& net, const Eigen::Ref<const Eigen::VectorXd>& lengths,
                     const Eigen::Ref<const Points>& start) {
    if (lengths.size() != net.axial_stiffness.size()) {
        throw std::invalid_argument(fmt::format("unstressed_lengths has {} entries, expected {}",
                                                lengths.size(), net.axial_stiffness.size()));
    }
    for (Eigen::Index e = 0; e < lengths.size(); ++e) {
        if (!(std::isfinite(lengths(e)) && lengths(e) > 0.0)) {
            throw std::invalid_argument(
                fmt::format("unstressed length {} is {}, expected a positive and finite number", e,
                            lengths(e)));
        }
    }
    if (start.cols() != net.nodes.cols() || !start.allFinite()) {
        throw std::invalid_argument(
            fmt::format("start must hold {} finite points", net.nodes.cols()));
    }
}

/// Whether slack edges leave nodes loose: the stiffness is singular to rounding.
bool has_loose_nodes(const StiffnessFactor& factor, const Eigen::VectorXd& axial_at_nodes) {
    if (factor.info() != Eigen::Success) {
        return true;
    }
    for (Eigen::Index i = 0; i < factor.pivots().size(); ++i) {
        if (factor.pivots()(i) <= smallest_shift * axial_at_nodes(i / 3)) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::string_view to_string(EquilibriumStatus status) {
    switch (status) {
        case EquilibriumStatus::converged:
            return "converged";
        case EquilibriumStatus::slack_mechanism:
            return "slack mechanism";
        case EquilibriumStatus::iteration_limit:
            return "iteration limit";
    }
    return "unknown";
}

struct EquilibriumSolver::Workspace {
    EquilibriumSettings settings;
    LocalNet net;
    NetState state;  ///< at the current form
    NetState trial;  ///< at the form that the line search looks at
    StiffnessMatrix matrix;
    StiffnessFactor factor;
    Eigen::VectorXd residual;
    Eigen::VectorXd direction;

    Workspace(const CableNet& cable_net, EquilibriumSettings with)
        : settings(with),
          net(number_for_elimination(cable_net)),
          state(net),
          trial(net),
          matrix(net),
          residual(net.loads.size()),
          direction(net.loads.size()) {
        factor.analyzePattern(matrix.upper());
    }

    /// Solves (H + shift D) d = -h. The shift grows until the matrix is positive definite.
    bool newton_direction(double& shift) {
        while (shift <= largest_shift) {
            matrix.assemble(net, state.edges());
            if (shift > 0.0) {
                matrix.add_shift(shift);
            }
            factor.factorize(matrix.upper());
            if (factor.positive_definite()) {
                residual = -state.forces();
                direction = factor.solve(residual);
                if (direction.allFinite() && direction.dot(state.forces()) <= 0.0) {
                    return true;
                }
            }
            shift = std::max(smallest_shift, 10.0 * shift);
        }
        return false;
    }

    /// Whether the equilibrium that was reached is the only one. Where every edge is taut the
    /// stiffness is positive definite: each part of the net hangs on a support.
    EquilibriumStatus status_of_balanced() {
        if (state.slack_count() == 0) {
            return EquilibriumStatus::converged;
        }
        matrix.assemble(net, state.edges());
        factor.factorize(matrix.upper());
        return has_loose_nodes(factor, matrix.axial_at_nodes()) ? EquilibriumStatus::slack_mechanism
                                                                : EquilibriumStatus::converged;
    }
};

EquilibriumSolver::EquilibriumSolver(const CableNet& net, EquilibriumSettings settings)
    : m_workspace(std::make_unique<Workspace>(net, settings)) {}
EquilibriumSolver::~EquilibriumSolver() = default;
EquilibriumSolver::EquilibriumSolver(EquilibriumSolver&&) noexcept = default;
EquilibriumSolver& EquilibriumSolver::operator=(EquilibriumSolver&&) noexcept = default;

Equilibrium EquilibriumSolver::solve(const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                     const Eigen::Ref<const Points>& start) {
    Workspace& w = *m_workspace;
    check_arguments(w.net, unstressed_lengths, start);
    const double tolerance = w.settings.relative_tolerance;
    Equilibrium result;
    result.energy_decreases.reserve(static_cast<size_t>(std::max(0, w.settings.max_iterations)));

    w.state.set_unstressed_lengths(unstressed_lengths);
    w.trial.set_unstressed_lengths(unstressed_lengths);
    w.net.gather(start, w.state.form());
    w.state.update(w.net);

    double shift = 0.0;
    double previous = std::numeric_limits<double>::infinity();
    while (true) {
        const double imbalance = w.state.largest_force();
        const double scale = w.state.force_scale();
        // Balanced, and either far below the tolerance or no longer getting better: rounding
        // errors.
        const bool balanced = imbalance <= tolerance * scale;
        if (balanced && (imbalance <= 0.01 * tolerance * scale || imbalance > 0.5 * previous)) {
            break;
        }
        if (result.iterations >= w.settings.max_iterations || !w.newton_direction(shift)) {
            break;
        }
        const LineSearchStep step = search_line(w.net, w.state, w.direction, w.trial);
        if (!step.accepted) {
            if (balanced) {
                break;
            }
            shift = std::max(smallest_shift, 100.0 * shift);
            if (shift > largest_shift) {
                break;
            }
            continue;
        }
        std::swap(w.state, w.trial);
        previous = imbalance;
        ++result.iterations;
        result.energy_decreases.push_back(step.energy_decrease);
        // A full step shows that the model holds: back towards the pure Newton step. A short one
        // that the slack edges were not foreseen.
        if (step.length == 1.0) {
            shift = shift > 10.0 * smallest_shift ? 0.1 * shift : shift;
        } else if (step.length < 0.05) {
            shift = std::max(1e-6, 10.0 * shift);
        }
    }

    result.out_of_balance = w.state.largest_force();
    result.mean_tension = w.state.mean_tension();
    result.form = w.net.scatter(w.state.form());
    result.slack_edges = w.state.slack_edges();
    if (result.out_of_balance <= tolerance * w.state.force_scale()) {
        result.status = w.status_of_balanced();
    }
    return result;
}

Equilibrium solve_equilibrium(const CableNet& net, EquilibriumSettings settings) {
    return EquilibriumSolver(net, settings).solve(net.unstressed_lengths(), net.nodes());
}

}  // namespace taut
