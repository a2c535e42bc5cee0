// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/gauss_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace taut {
namespace {

/// After a step that contracts to this part of the one before, the matrix is used again.
constexpr double fast_contraction = 0.3;

/// The search gives up where steps this much shorter still lead astray.
constexpr double shortest_part = 1e-4;

/// Infinite where no factor is found.
Iterate linearised_step(LinearisedStatics& statics, const Observations& observations,
                        const Iterate& iterate) {
    if (!statics.linearise(iterate, observations)) {
        Iterate infinite = iterate;
        infinite.form.setConstant(std::numeric_limits<double>::infinity());
        return infinite;
    }
    return statics.step(iterate, observations);
}

/// A part of a step, where it leads, and the step that the same matrix gives from there.
struct Trial {
    double part = 1.0;
    Iterate iterate;
    Iterate next;
};

Trial try_part(const LinearisedStatics& statics, const Observations& observations,
               const Iterate& iterate, const Iterate& step, double part) {
    Trial trial{.part = part, .iterate = iterate.moved(step, part), .next = {}};
    trial.next = statics.step(trial.iterate, observations);
    return trial;
}

/// (monotonicity): by the next step with the same matrix, forces and misfit are compared in metres.
bool leads_astray(const LinearisedStatics& statics, const Trial& trial, const Iterate& step,
                  double tolerance) {
    const double size = statics.size_of(trial.next);
    return size > (1.0 - 0.5 * trial.part) * statics.size_of(step) && size > tolerance;
}

}  // namespace

GaussNewtonResult gauss_newton(LinearisedStatics& statics, const Observations& observations,
                               Iterate start, double tolerance, int max_iterations,
                               const Progress& progress) {
    GaussNewtonResult result{.iterate = std::move(start)};
    Iterate step = linearised_step(statics, observations, result.iterate);  // (normal)
    bool is_linearised_here = true;
    const auto relinearise = [&] {
        step = linearised_step(statics, observations, result.iterate);
        is_linearised_here = true;
    };
    while (result.iterations < max_iterations && std::isfinite(statics.size_of(step))) {
        progress.throw_if_stopped();
        if (statics.size_of(step) <= tolerance) {
            // The covariance is to be that of the result.
            if (is_linearised_here) {
                result.iterate = result.iterate.moved(step);
                result.converged = true;
                return result;
            }
            relinearise();
            continue;
        }
        ++result.iterations;
        Trial trial = try_part(statics, observations, result.iterate, step, 1.0);
        // A matrix from elsewhere need not even give a direction of descent.
        if (!is_linearised_here && leads_astray(statics, trial, step, tolerance)) {
            relinearise();
            continue;
        }
        while (trial.part > shortest_part && leads_astray(statics, trial, step, tolerance)) {
            trial = try_part(statics, observations, result.iterate, step, 0.5 * trial.part);
        }
        if (trial.part <= shortest_part) {
            return result;
        }
        result.iterate = std::move(trial.iterate);
        if (trial.part < 1.0 ||
            statics.size_of(trial.next) > fast_contraction * statics.size_of(step)) {
            relinearise();
        } else {
            step = std::move(trial.next);
            is_linearised_here = false;
        }
    }
    result.has_factor = std::isfinite(statics.size_of(step));
    return result;
}

}  // namespace taut
