// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "support/random_nets.hpp"
#include "taut/adjustment/built_net.hpp"
#include "taut/adjustment/limits.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"

/// Nets as built, and what is asked of them.
namespace taut::test {

/// A net with other lengths, in equilibrium.
inline CableNet with_lengths(const CableNet& net, const Eigen::VectorXd& lengths) {
    CableNetData data = net.data();
    data.unstressed_lengths = lengths;
    data.nodes = EquilibriumSolver(net).solve(lengths, net.nodes()).form;
    return CableNet(std::move(data));
}

inline BuiltNet without_draws(CableNet net) {
    return {.net = std::move(net),
            .length_draws = {},
            .perturbations = {},
            .no_draws_because = "none were made"};
}

/// Built with interior lengths that are off by up to `reach` [m].
inline BuiltNet random_built(const CableNet& net, std::uint64_t seed, double reach) {
    Random random(seed);
    return without_draws(with_lengths(
        net,
        with_length_deviations(net, uniform_vector(random, net.interior_edge_count(), reach))));
}

/// T of all edges where their lengths are these [N].
inline Eigen::VectorXd solved_tensions(const CableNet& net, const Eigen::VectorXd& lengths,
                                       const Points& start) {
    return tensions_of(net, lengths, EquilibriumSolver(net).solve(lengths, start).form);
}

/// Every adjustable edge may be turned so far [m].
inline Limits strokes_up_to(const CableNet& net, double stroke) {
    return stroke_limits(net, net.adjustable_edges(), stroke);
}

/// And all tensions are to lie between two [N].
inline Limits limits_between(const CableNet& net, double stroke, double lower, double upper) {
    Limits limits = strokes_up_to(net, stroke);
    limits.tension.lower.setConstant(lower);
    limits.tension.upper.setConstant(upper);
    return limits;
}

}  // namespace taut::test
