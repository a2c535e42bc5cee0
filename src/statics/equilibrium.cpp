// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/equilibrium.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "statics/arguments.hpp"
#include "statics/descent.hpp"

namespace taut {
namespace {

/// More Newton steps than nets under tension need from a fair start. Who is not done by then most
/// likely moves along a curved valley of the energy.
constexpr int plain_steps = 30;

/// How far forces must balance under one load before the approach goes on to the next, lighter one.
constexpr double approach_tolerance = 1e-2;

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
    Eigen::VectorXd loads;     ///< 3 n_I, the true ones: approach() changes net.loads [N]
    double heavy_loads = 0.0;  ///< factor on the loads that stretches edges to twice their length
    Descent descent;
    NetState before;  ///< where an approach began

    Workspace(const CableNet& cable_net, EquilibriumSettings with)
        : settings(with),
          net(number_for_elimination(cable_net)),
          loads(net.loads),
          descent(net),
          before(net) {
        // The edges at supports carry the sum of the loads. A guess: only its magnitude matters.
        const double total = loads.reshaped(3, net.free_count).colwise().norm().sum();
        const auto at_supports = std::ranges::count_if(
            net.edges, [&](const Edge& e) { return std::ranges::max(e) >= net.free_count; });
        if (total > 0.0) {
            heavy_loads = net.axial_stiffness.mean() * static_cast<double>(at_supports) / total;
        }
    }

    void set_loads(double factor) {
        net.loads = factor * loads;
        descent.state().update(net);
    }

    /// Takes a slack net under light loads near its equilibrium. There the energy is a curved
    /// valley, steep across (edges that stretch) and flat along (slack edges that swing): a step
    /// can be no longer than some (load / EA)^(1/3) of an edge. Heavier loads open the valley. So
    /// this goes to the equilibrium under very heavy loads, and back through ever lighter ones.
    /// Counts as one step, taken only if it lowers the energy.
    /// @return Newton steps used
    int approach(int max_steps, std::vector<double>& energy_decreases) {
        before = descent.state();
        const size_t steps_before = energy_decreases.size();
        int steps = 0;
        for (double factor = heavy_loads; factor > 1.0 && steps < max_steps; factor *= 0.1) {
            set_loads(factor);
            steps +=
                descent.run(net, approach_tolerance, max_steps - steps, energy_decreases).steps;
        }
        set_loads(1.0);
        energy_decreases.resize(steps_before);
        if (const double decrease = before.energy_above(descent.state(), net); decrease > 0.0) {
            energy_decreases.push_back(decrease);
        } else {
            descent.state() = before;
        }
        return steps;
    }
};

EquilibriumSolver::EquilibriumSolver(const CableNet& net, EquilibriumSettings settings) {
    if (settings.max_iterations < 0) {
        throw std::invalid_argument(
            fmt::format("max_iterations is {}, expected at least 0", settings.max_iterations));
    }
    if (!(settings.relative_tolerance > 0.0) || !std::isfinite(settings.relative_tolerance)) {
        throw std::invalid_argument(
            fmt::format("relative_tolerance is {}, expected a positive and finite number",
                        settings.relative_tolerance));
    }
    m_workspace = std::make_unique<Workspace>(net, settings);
}
EquilibriumSolver::~EquilibriumSolver() = default;
EquilibriumSolver::EquilibriumSolver(EquilibriumSolver&&) noexcept = default;
EquilibriumSolver& EquilibriumSolver::operator=(EquilibriumSolver&&) noexcept = default;

Equilibrium EquilibriumSolver::solve(const Eigen::Ref<const Eigen::VectorXd>& unstressed_lengths,
                                     const Eigen::Ref<const Points>& start) {
    Workspace& w = *m_workspace;
    check_unstressed_lengths(w.net.axial_stiffness.size(), unstressed_lengths);
    check_form("start", w.net.nodes.cols(), start);
    Equilibrium result;
    result.energy_decreases.reserve(static_cast<size_t>(std::max(0, w.settings.max_iterations)));

    NetState& state = w.descent.state();
    state.set_unstressed_lengths(w.net, unstressed_lengths);
    w.net.gather(start, state.form());
    state.update(w.net);

    const auto descend = [&](int max_steps) {
        const auto [balanced, steps] =
            w.descent.run(w.net, w.settings.relative_tolerance, max_steps, result.energy_decreases);
        result.iterations += steps;
        return balanced;
    };
    const int limit = w.settings.max_iterations;
    bool balanced = descend(std::min(plain_steps, limit));
    if (!balanced && result.iterations < limit) {
        result.iterations += w.approach(limit - result.iterations, result.energy_decreases);
        balanced = descend(limit - result.iterations);
    }

    result.out_of_balance = state.largest_force();
    result.mean_tension = state.mean_tension();
    result.form = w.net.scatter(state.form());
    result.slack_edges = state.slack_edges();
    if (balanced) {
        result.status = w.descent.has_loose_nodes(w.net) ? EquilibriumStatus::slack_mechanism
                                                         : EquilibriumStatus::converged;
    }
    return result;
}

Equilibrium solve_equilibrium(const CableNet& net, EquilibriumSettings settings) {
    return EquilibriumSolver(net, settings).solve(net.unstressed_lengths(), net.nodes());
}

}  // namespace taut
