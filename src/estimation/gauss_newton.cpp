// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/gauss_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace taut {
namespace {

/// A step as small as this part of the one before needs no new linearisation to go on.
constexpr double fast_contraction = 0.3;

/// The search gives up where steps this much shorter still lead astray.
constexpr double shortest_part = 1e-4;

Guess moved(const Guess& guess, const Guess& change, double part) {
    return {.form = guess.form + part * change.form,
            .deviations = guess.deviations + part * change.deviations};
}

double size_of(const Guess& change) {
    const double size =
        std::max(change.form.cwiseAbs().maxCoeff(), change.deviations.cwiseAbs().maxCoeff());
    return std::isfinite(size) ? size : std::numeric_limits<double>::infinity();
}

}  // namespace

GaussNewtonResult fit_under_statics(ConditionedStatics& statics, const Knowledge& knowledge,
                                    Guess start, double tolerance, int max_iterations) {
    GaussNewtonResult result{.guess = std::move(start)};
    const auto linearised_step = [&] {
        if (!statics.linearise(result.guess, knowledge)) {
            throw std::runtime_error(
                "the statics of the net are singular at the surveyed form: are net and law right?");
        }
        return statics.step(result.guess, knowledge);
    };
    Guess step = linearised_step();
    bool is_linearised_here = true;
    while (result.iterations < max_iterations) {
        if (size_of(step) <= tolerance) {
            // The covariance is to be that of the result.
            if (is_linearised_here) {
                result.guess = moved(result.guess, step, 1.0);
                result.converged = true;
                return result;
            }
            step = linearised_step();
            is_linearised_here = true;
            continue;
        }
        if (!std::isfinite(size_of(step))) {
            return result;
        }
        ++result.iterations;
        // Natural monotonicity test (Deuflhard): the step that the same matrix gives from where
        // this one leads must be shorter. It holds forces and misfit against each other in metres.
        double part = 1.0;
        Guess trial = moved(result.guess, step, part);
        Guess next = statics.step(trial, knowledge);
        const auto leads_astray = [&] {
            return size_of(next) > (1.0 - 0.5 * part) * size_of(step) && size_of(next) > tolerance;
        };
        // A matrix from elsewhere need not even give a direction of descent.
        if (!is_linearised_here && leads_astray()) {
            step = linearised_step();
            is_linearised_here = true;
            continue;
        }
        while (part > shortest_part && leads_astray()) {
            part *= 0.5;
            trial = moved(result.guess, step, part);
            next = statics.step(trial, knowledge);
        }
        if (part <= shortest_part) {
            return result;
        }
        result.guess = std::move(trial);
        is_linearised_here = part < 1.0 || size_of(next) > fast_contraction * size_of(step);
        step = is_linearised_here ? linearised_step() : std::move(next);
    }
    return result;
}

}  // namespace taut
