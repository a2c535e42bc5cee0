// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/feasible_descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "estimation/imagined_observations.hpp"

namespace taut {
namespace {

/// A projection ends when a step moves the iterate by less than this, in standard deviations of
/// observations and prior; it fails where a step contracts no faster than this factor.
constexpr double balanced_to = 1e-3;
constexpr double slowest_contraction = 0.5;
constexpr int most_projections = 20;
constexpr int most_restorations = 10;

constexpr double first_damping = 1e-2;
constexpr double least_damping = 1e-6;
constexpr double most_damping = 1e8;

/// A step is taken where it lowers the objective by this part of the prediction; from the second
/// part on the damping is reduced.
constexpr double least_gain = 0.1;
constexpr double good_gain = 0.5;

/// In standard deviations of observations and priors; of unobserved places in those of the lengths.
double length_of(const Linearisation& linearisation, const Observations& observations,
                 const Iterate& change) {
    const Eigen::ArrayXXd unobserved =
        (observations.weights.array() + observations.support_weights.array() == 0.0)
            .select(change.form.array().abs(), 0.0);
    return std::max(std::sqrt(linearisation.squared_norm(observations, change)),
                    unobserved.maxCoeff() / std::sqrt(observations.variance.mean()));
}

/// The observations with P (1 + damping) for P and the same slope P (mean - d) at the iterate.
Observations damped(const Observations& observations, const Iterate& iterate, double damping) {
    Observations result = observations;
    result.length_damping = damping;
    result.mean = iterate.deviations + (observations.mean - iterate.deviations) / (1.0 + damping);
    return result;
}

/// (projection): back to equilibrium by the matrix as linearised.
std::optional<Iterate> projected(const Linearisation& linearisation,
                                 const Observations& observations, Iterate iterate) {
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_projections; ++k) {
        const Iterate change =
            linearisation.step(iterate, satisfied(linearisation.model(), observations, iterate));
        const double size = length_of(linearisation, observations, change);
        if (!(size <= slowest_contraction * before)) {
            return std::nullopt;
        }
        iterate = iterate.moved(change);
        if (size < balanced_to) {
            return iterate;
        }
        before = size;
    }
    return std::nullopt;
}

/// An iterate in equilibrium near a given one; nothing where there is no factor.
/// @param at on return linearised nearby
std::optional<Iterate> balanced(const StaticsModel& model, const Observations& observations,
                                Iterate iterate, std::optional<Linearisation>& at) {
    for (int k = 0; k < most_restorations; ++k) {
        const Observations here = satisfied(model, observations, iterate);
        at = linearise(model, iterate, here, std::move(at));
        if (!at) {
            return std::nullopt;
        }
        if (auto found = projected(*at, here, iterate)) {
            return found;
        }
        iterate = iterate.moved(at->step(iterate, here));
    }
    return iterate;
}

}  // namespace

GaussNewtonResult feasible_descent(const StaticsModel& model, const Observations& observations,
                                   Iterate start, double small_decrement, int max_iterations,
                                   const Progress& progress, std::optional<Linearisation> before) {
    GaussNewtonResult result{.iterate = std::move(start), .linearisation = std::move(before)};
    std::optional<Linearisation>& at = result.linearisation;
    auto begin = balanced(model, observations, result.iterate, at);
    if (!begin) {
        return result;
    }
    result.iterate = std::move(*begin);
    double F = model.objective(observations, result.iterate);
    double damping = first_damping;
    for (int k = 0; k < max_iterations && damping < most_damping; ++k) {
        progress("identification", k, 0);
        const Observations here = damped(observations, result.iterate, damping);
        at = linearise(model, result.iterate, here, std::move(at));
        if (!at) {
            return result;
        }
        const Iterate step = at->step(result.iterate, here);  // (damped)
        const double predicted = 0.5 * at->squared_norm(here, step);
        // Bounds the length of the undamped step.
        if (std::sqrt((1.0 + damping) * at->squared_norm(here, step)) <= small_decrement) {
            at = linearise(model, result.iterate, observations, std::move(at));
            if (!at) {
                return result;
            }
            const Iterate last = at->step(result.iterate, observations);
            result.converged =
                length_of(*at, observations, last) <= small_decrement;  // (decrement)
            if (result.converged) {
                return result;
            }
        }
        // Damping shortens the step of the lengths alone: where it is large, a part of it for all.
        bool is_taken = false;
        for (const double part : {1.0, 1.0 / (1.0 + damping)}) {
            if (part < 1.0 && damping < 1.0) {
                break;
            }
            const auto trial = projected(*at, here, result.iterate.moved(step, part));
            const double decrease = trial ? F - model.objective(observations, *trial) : -1.0;
            const double expected = part * (2.0 - part) * predicted;
            is_taken = decrease > least_gain * expected;
            if (is_taken) {
                result.iterate = *trial;
                F -= decrease;
                damping = decrease > good_gain * expected ? std::max(least_damping, 0.1 * damping)
                                                          : damping;
                break;
            }
        }
        damping *= is_taken ? 1.0 : 8.0;
    }
    return result;
}

}  // namespace taut
