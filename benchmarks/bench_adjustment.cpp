// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// From identified lengths to turns, and the whole loop of a job.
#include <benchmark/benchmark.h>

#include "taut/adjustment/plan.hpp"
#include "taut/adjustment/turn_order.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/identify.hpp"
#include "taut/sampling/built_net.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/study/control.hpp"
#include "taut/survey/simulation.hpp"

namespace {

using taut::CableNet;

constexpr taut::LengthPrior prior{.kind = taut::LengthPrior::Kind::uniform, .scale = 0.005};

taut::Survey survey_of(const CableNet& net, std::uint64_t seed) {
    const CableNet site = taut::built_net(net, prior, 1);
    return taut::match_to_nodes(
        net, taut::simulate_survey(net, taut::solve_equilibrium(site).form,
                                   {.noise_std = 0.5e-3, .dropped_part = 0.1, .seed = seed}));
}

taut::BuiltNet identified(const CableNet& net, int draws) {
    taut::IdentifyOptions options;
    options.prior = prior;
    options.assume_site = false;
    options.draws = draws;
    return taut::built_net_of(net, taut::identify(net, survey_of(net, 1), options));
}

taut::Limits limits_of(const CableNet& net) {
    taut::Limits limits = taut::stroke_limits(net, net.adjustable_edges(), 0.015);
    limits.tension.lower.setConstant(1.5e3);
    limits.tension.upper.setConstant(10e3);
    return limits;
}

/// Arguments: draws; whether in quarter turns of 5 mm.
void plan(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    const taut::BuiltNet built = identified(net, static_cast<int>(state.range(0)));
    const taut::FormTarget target(net, net.nodes());
    const taut::Limits limits = limits_of(net);
    taut::PlanOptions options;
    if (state.range(1) != 0) {
        options.turn = {.pitch = 0.005, .smallest = 0.25};
    }
    for (auto _ : state) {
        const taut::Plan found = taut::plan_strokes(built, target, limits, options);
        state.counters["normal_rms_mm"] = 1e3 * found.planned.normal_rmse;
    }
}
BENCHMARK(plan)->Args({0, 0})->Args({200, 0})->Args({200, 1})->Unit(benchmark::kMillisecond);

void order_of_plan(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    const taut::BuiltNet built = identified(net, 0);
    const taut::Limits limits = limits_of(net);
    const taut::Plan found = taut::plan_strokes(built, taut::FormTarget(net, net.nodes()), limits);
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::order_turns(built, limits, found, {.crews = 3}).is_safe);
    }
}
BENCHMARK(order_of_plan)->Unit(benchmark::kMillisecond);

void two_epochs(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    const std::vector<taut::Epoch> epochs{{.survey = survey_of(net, 1), .turned = {}},
                                          {.survey = survey_of(net, 2), .turned = {}}};
    taut::IdentifyOptions options;
    options.prior = prior;
    options.assume_site = false;
    options.draws = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::identify_epochs(net, epochs, options).edges.data());
    }
}
BENCHMARK(two_epochs)->Unit(benchmark::kMillisecond)->Iterations(1);

/// One round of one job, by all four strategies.
void control(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::simulate_control(net, {.prior = prior,
                                                              .actuator_std = 0.2e-3,
                                                              .least_tension = 1.5e3,
                                                              .most_tension = 10e3,
                                                              .turn = {},
                                                              .rounds = 1,
                                                              .trials = 1})
                                     .data());
    }
}
BENCHMARK(control)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
