// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/gauss_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace taut {
namespace {

/// After a step that contracts to this part of the one before, the matrix is used again.
constexpr double fast_contraction = 0.3;

/// The search gives up where steps this much shorter still lead astray.
constexpr double shortest_part = 1e-4;

/// A part of a step, where it leads, and the step that the same matrix gives from there.
struct Trial {
    double part = 1.0;
    Iterate iterate;
    Iterate next;
};

Trial try_part(const Linearisation& linearisation, const Observations& observations,
               const Iterate& iterate, const Iterate& step, double part) {
    Trial trial{.part = part, .iterate = iterate.moved(step, part), .next = {}};
    trial.next = linearisation.step(trial.iterate, observations);
    return trial;
}

/// (monotonicity): by the next step with the same matrix, forces and misfit are compared in metres.
bool leads_astray(const Linearisation& linearisation, const Trial& trial, const Iterate& step,
                  double tolerance) {
    const double size = linearisation.size_of(trial.next);
    return size > (1.0 - 0.5 * trial.part) * linearisation.size_of(step) && size > tolerance;
}

}  // namespace

GaussNewtonResult gauss_newton(const StaticsModel& model, const Observations& observations,
                               Iterate start, double tolerance, int max_iterations,
                               const Progress& progress, std::optional<Linearisation> before) {
    GaussNewtonResult result{.iterate = std::move(start), .linearisation = std::move(before)};
    std::optional<Linearisation>& at = result.linearisation;
    Iterate step;
    bool is_linearised_here = false;
    const auto relinearise = [&] {  // (normal)
        at = linearise(model, result.iterate, observations, std::move(at));
        step = at ? at->step(result.iterate, observations) : Iterate();
        is_linearised_here = true;
    };
    relinearise();
    int iterations = 0;
    while (at && iterations < max_iterations && std::isfinite(at->size_of(step))) {
        progress("identification", iterations, 0);
        if (at->size_of(step) <= tolerance) {
            // The covariance is to be that of the result.
            if (is_linearised_here) {
                result.iterate = result.iterate.moved(step);
                result.converged = true;
                return result;
            }
            relinearise();
            continue;
        }
        ++iterations;
        Trial trial = try_part(*at, observations, result.iterate, step, 1.0);
        // A matrix from elsewhere need not even give a direction of descent.
        if (!is_linearised_here && leads_astray(*at, trial, step, tolerance)) {
            relinearise();
            continue;
        }
        while (trial.part > shortest_part && leads_astray(*at, trial, step, tolerance)) {
            trial = try_part(*at, observations, result.iterate, step, 0.5 * trial.part);
        }
        if (trial.part <= shortest_part) {
            return result;
        }
        result.iterate = std::move(trial.iterate);
        if (trial.part < 1.0 || at->size_of(trial.next) > fast_contraction * at->size_of(step)) {
            relinearise();
        } else {
            step = std::move(trial.next);
            is_linearised_here = false;
        }
    }
    return result;
}

}  // namespace taut
