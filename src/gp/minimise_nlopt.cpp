// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <exception>
#include <nlopt.hpp>
#include <stdexcept>

#include "gp/minimise.hpp"

namespace taut::gp {
namespace {

/// NLopt passes few kinds of exceptions on, so a failure is kept.
struct Guarded {
    const Objective& objective;
    std::exception_ptr failure;
};

double evaluate(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
    auto& guarded = *static_cast<Guarded*>(data);
    if (guarded.failure) {  // its line search does not end at once
        throw nlopt::forced_stop();
    }
    try {
        return guarded.objective(x, gradient);
    } catch (...) {
        guarded.failure = std::current_exception();
        throw nlopt::forced_stop();
    }
}

}  // namespace

void minimise(const Objective& objective, const std::vector<double>& start,
              const MinimiseSettings& settings) {
    Guarded guarded{.objective = objective, .failure = {}};
    nlopt::opt optimizer(nlopt::LD_LBFGS, static_cast<unsigned>(start.size()));
    optimizer.set_min_objective(evaluate, &guarded);
    optimizer.set_lower_bounds(settings.lower);
    optimizer.set_upper_bounds(settings.upper);
    optimizer.set_ftol_rel(settings.relative_tolerance);
    optimizer.set_maxeval(settings.most_evaluations);
    try {
        (void)optimizer.optimize(start);
    } catch (const std::runtime_error&) {
        // Unless the objective failed, the line search found nothing lower: it is at the minimum up
        // to rounding.
        if (guarded.failure) {
            std::rethrow_exception(guarded.failure);
        }
    }
}

}  // namespace taut::gp
