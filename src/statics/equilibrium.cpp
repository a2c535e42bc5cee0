// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/statics/equilibrium.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "statics/arguments.hpp"
#include "statics/descent.hpp"
#include "statics/interior_point.hpp"
#include "statics/sliding.hpp"

namespace taut {
namespace {

/// Newton's method is interrupted for interior-point steps after this number of steps, or of
/// consecutive short steps. Tense nets need fewer from a fair start.
constexpr DescentLimits plain_descent{.max_steps = 30, .max_short_steps = 1};

/// The residual forces may be rounding errors of the coordinates. If these are as large as the
/// tensions, the tensions are not known. Strains below a billionth do not count as tension.
bool is_small_beside_tensions(double out_of_balance, const LocalNet& net, double mean_force) {
    constexpr double largest_share = 1e-4;
    constexpr double least_strain = 1e-9;
    const double loads = net.loads.reshaped(3, net.free_count).colwise().norm().mean();
    const double scale = std::max({mean_force, loads, least_strain * net.axial_stiffness.mean()});
    return out_of_balance <= largest_share * scale;
}

}  // namespace

std::string_view to_string(EquilibriumStatus status) {
    switch (status) {
        case EquilibriumStatus::converged:
            return "converged";
        case EquilibriumStatus::slack_mechanism:
            return "slack mechanism";
        case EquilibriumStatus::unstable:
            return "unstable";
        case EquilibriumStatus::iteration_limit:
            return "iteration limit";
    }
    return "unknown";
}

struct EquilibriumSolver::Workspace {
    EquilibriumSettings settings;
    LocalNet net;
    Stiffness stiffness;
    Descent descent;
    InteriorPoint interior_point;
    NetState state;
    NetState before;  ///< where the interior-point steps began
    RunSliding sliding;

    Workspace(const CableNet& cable_net, EquilibriumSettings with)
        : settings(with),
          net(number_for_elimination(cable_net)),
          stiffness(net),
          descent(net),
          interior_point(net),
          state(net),
          before(net),
          sliding(cable_net.sliding_nodes()) {}

    /// Brings the forces of the state into balance, for its unstressed lengths; whether that
    /// succeeds.
    bool balance(Equilibrium& result) {
        const auto descend = [&](DescentLimits limits) {
            const auto [balanced, steps] =
                descent.run(net, stiffness, state, settings.relative_tolerance, limits,
                            result.energy_decreases);
            result.iterations += steps;
            return balanced;
        };
        const int limit = settings.max_iterations;
        // The path of the interior-point steps leads through straight parts of laws.
        const bool has_path = net.is_convex() && !net.sags;
        DescentLimits at_first = has_path ? plain_descent : DescentLimits{.max_steps = limit};
        at_first.max_steps = std::min(at_first.max_steps, limit - result.iterations);
        bool balanced = descend(at_first);
        if (!balanced && has_path && result.iterations < limit) {
            // Half of what is left: Newton's method has the last word.
            result.iterations +=
                approach((limit - result.iterations + 1) / 2, result.energy_decreases);
            balanced = descend({.max_steps = limit - result.iterations});
        }
        if (balanced && is_unstable(net, stiffness, state)) {
            leave_saddle(result);
        }
        return balanced;
    }

    /// A search by symmetry may end where struts give way. Goes on from a little beside it, to
    /// either side; taken if a stable form is found within the reach of a step. Farther ones are
    /// those of a net that has collapsed.
    void leave_saddle(Equilibrium& result) {
        constexpr double nudge = 1e-3;
        const Eigen::VectorXd collapse = direction_of_collapse(net, stiffness, state);
        before = state;
        for (const double side : {1.0, -1.0}) {
            state = before;
            state.form().reshaped().head(collapse.size()) +=
                side * nudge * descent.reach() * collapse;
            state.update(net);
            const auto [balanced, steps] =
                descent.run(net, stiffness, state, settings.relative_tolerance,
                            {.max_steps = std::max(0, settings.max_iterations - result.iterations)},
                            result.energy_decreases);
            result.iterations += steps;
            const double moved = (state.form() - before.form()).colwise().norm().maxCoeff();
            if (balanced && moved <= descent.reach() && !is_unstable(net, stiffness, state)) {
                return;
            }
        }
        state = before;
    }

    /// Interior-point steps. Together they count as one step, which is taken only if it lowers the
    /// energy.
    /// @return their number
    int approach(int max_steps, std::vector<double>& energy_decreases) {
        before = state;
        const int steps = interior_point.run(net, stiffness, state, max_steps);
        if (const double decrease = before.energy_above(state, net); decrease > 0.0) {
            energy_decreases.push_back(decrease);
        } else {
            state = before;
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
    result.energy_decreases.reserve(std::max(0, w.settings.max_iterations));

    NetState& state = w.state;
    state.set_unstressed_lengths(w.net, unstressed_lengths);
    w.net.gather(start, state.form());
    state.update(w.net);

    bool balanced = w.balance(result);
    double not_slid = 0.0;
    if (balanced && !w.sliding.is_empty()) {
        not_slid = w.sliding.run(w.net, w.stiffness, state, [&] { return w.balance(result); });
        balanced = not_slid == 0.0;
    }
    result.unstressed_lengths = state.unstressed_lengths();
    result.form = w.net.scatter(state.form());
    if (!w.net.origin.isZero(0.0)) {
        // The coordinates of a net far from the origin are rounded once more. Report the forces at
        // the rounded coordinates.
        w.net.gather(result.form, state.form());
        state.update(w.net);
    }
    result.out_of_balance = std::max(state.largest_force(), not_slid);
    result.mean_tension = state.mean_tension();
    result.slack_edges = state.slack_edges();
    if (balanced && is_small_beside_tensions(result.out_of_balance, w.net, state.mean_force())) {
        result.status = is_unstable(w.net, w.stiffness, state) ? EquilibriumStatus::unstable
                        : is_mechanism(w.net, w.stiffness, state)
                            ? EquilibriumStatus::slack_mechanism
                            : EquilibriumStatus::converged;
    }
    return result;
}

Equilibrium solve_equilibrium(const CableNet& net, EquilibriumSettings settings) {
    return EquilibriumSolver(net, settings).solve(net.unstressed_lengths(), net.nodes());
}

}  // namespace taut
