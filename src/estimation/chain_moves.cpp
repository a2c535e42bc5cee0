// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/chain_moves.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace taut {
namespace {

struct SlackLength {
    int interior;  ///< index of the edge among the interior ones
    double from;   ///< least length that is slack, in standard deviations of the prior
};

/// A length deviation from its prior mean, in standard deviations of the prior.
double standardised(const ChainTarget& target, const Iterate& iterate, int i) {
    return (iterate.deviations(i) - target.observations().mean(i)) /
           std::sqrt(target.variances()(i));
}

std::vector<SlackLength> slack_lengths(const ChainTarget& target, const Iterate& iterate) {
    std::vector<SlackLength> result;
    const StaticsModel& model = target.model();
    const CableNet& net = model.net();
    for (int i = 0; i < net.interior_edge_count() && !net.sags(); ++i) {
        const int e = net.interior_edges()[i];
        const auto [s, t] = net.edges()[e];
        const double extension = (iterate.form.col(s) - iterate.form.col(t)).norm() -
                                 model.unstressed_length(e, iterate);
        if (extension < 0.0 && net.can_be_slack(e) && !model.slack[e]) {
            const double heated = 1.0 + model.common.thermal_strain(e, iterate.common);
            result.push_back({.interior = i,
                              .from = standardised(target, iterate, i) +
                                      extension / heated / std::sqrt(target.variances()(i))});
        }
    }
    return result;
}

/// Above this bound erfc is near the smallest number, and a standard normal number z has the tail
/// exp(-z^2 / 2) / z, to a part of 1 / z^2.
constexpr double far_bound = 35.0;

/// Logarithm of the density of a standard normal number above a bound, up to a constant.
double log_density_above(double from, double z) {
    const double root = std::numbers::sqrt2;
    const double log_above =
        from < far_bound ? std::log(std::erfc(from / root))
                         : -0.5 * from * from - std::log(from / root * std::sqrt(std::numbers::pi));
    return z > from ? -0.5 * z * z - log_above : -std::numeric_limits<double>::infinity();
}

/// A standard normal number above a bound.
double drawn_above(double from, RandomNumbers& random) {
    const double root = std::numbers::sqrt2;
    return from < far_bound
               ? root * boost::math::erfc_inv(random.uniform() * std::erfc(from / root))
               : std::sqrt(from * from - 2.0 * std::log(random.uniform()));
}

}  // namespace

std::optional<ChainState> start_of_chain(ChainTarget& target, RandomNumbers& random) {
    constexpr double farther = 2.0;
    constexpr double least = 0.1;
    const Iterate direction = target.drawn_velocity(random);
    for (double distance = farther; distance > least; distance *= 0.5) {
        std::optional<ChainState> state =
            target.state_at(target.centre().moved(direction, distance));
        if (state && target.is_as_seen(state->iterate)) {
            return state;
        }
    }
    return target.state_at(target.centre());
}

double follow_trajectory(ChainTarget& target, ChainState& state, double step, int steps,
                         RandomNumbers& random) {
    Iterate velocity = target.drawn_velocity(random);
    const double before = state.potential + target.kinetic_energy(velocity);
    const double chance = random.uniform();
    ChainState at = state;
    velocity = velocity.moved(at.force, 0.5 * step);
    for (int k = 1; k <= steps; ++k) {
        std::optional<ChainState> next = target.state_at(at.iterate.moved(velocity, step));
        if (!next) {
            return 0.0;
        }
        at = *std::move(next);
        velocity = velocity.moved(at.force, k < steps ? step : 0.5 * step);
    }
    const double after = at.potential + target.kinetic_energy(velocity);
    if (!std::isfinite(after)) {
        return 0.0;
    }
    const double taken = std::exp(std::min(0.0, before - after));
    if (taken <= chance || !target.is_as_seen(at.iterate)) {
        return taken;
    }
    state = std::move(at);
    return taken;
}

void renew_slack_lengths(ChainTarget& target, ChainState& state, RandomNumbers& random) {
    const std::vector<SlackLength> slack = slack_lengths(target, state.iterate);
    if (slack.empty()) {
        return;
    }
    const double chance = random.uniform();
    Iterate drawn = state.iterate;
    for (const auto& [i, from] : slack) {
        drawn.deviations(i) = target.observations().mean(i) +
                              drawn_above(from, random) * std::sqrt(target.variances()(i));
    }
    std::optional<ChainState> next = target.state_at(std::move(drawn));
    if (!next || !target.is_as_seen(next->iterate)) {
        return;
    }
    const std::vector<SlackLength> back = slack_lengths(target, next->iterate);
    if (!std::ranges::equal(back, slack, {}, &SlackLength::interior, &SlackLength::interior)) {
        return;
    }
    double log_ratio = state.potential - next->potential;
    for (size_t k = 0; k < slack.size(); ++k) {
        const int i = slack[k].interior;
        log_ratio += log_density_above(back[k].from, standardised(target, state.iterate, i)) -
                     log_density_above(slack[k].from, standardised(target, next->iterate, i));
    }
    if (std::log(chance) < log_ratio) {
        state = *std::move(next);
    }
}

}  // namespace taut
