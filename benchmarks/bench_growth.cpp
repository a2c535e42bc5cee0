// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Growth of cost, on all cores: forms over nodes, training over samples, identification over edges.
// The counter "size" is the independent variable.
#include <benchmark/benchmark.h>

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/equilibrium.hpp"

namespace {

using taut::CableNet;

constexpr taut::LengthPrior one_millimetre{.kind = taut::LengthPrior::Kind::uniform,
                                           .scale = 0.001};

Eigen::VectorXd drawn_lengths(const CableNet& net) {
    return taut::with_length_deviations(
        net, taut::draw_length_deviations(one_millimetre, 1, 0, net.interior_edge_count()));
}

void require_converged(benchmark::State& state, const taut::Equilibrium& found) {
    if (found.status != taut::EquilibriumStatus::converged) {
        state.SkipWithError("did not converge");
    }
}

/// Argument: side of a hypar. Symbolic work and one solve.
void form(benchmark::State& state) {
    const auto side = static_cast<int>(state.range(0));
    const CableNet net = taut::hypar(side, side);
    const Eigen::VectorXd lengths = drawn_lengths(net);
    for (auto _ : state) {
        require_converged(state, taut::EquilibriumSolver(net).solve(lengths, net.nodes()));
    }
    state.counters["size"] = net.free_node_count();
}
BENCHMARK(form)
    ->Arg(30)
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->Arg(300)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

/// Argument: samples of the built-in net.
void train(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    const auto samples = static_cast<int>(state.range(0));
    const taut::Sampler sampler(net, {}, 1);
    taut::DataSet data = sampler.no_samples();
    sampler.extend_to(data, samples);
    const std::vector<int> indices = data.converged_in(0, samples);
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::train_model(net, data, indices).processes.weights.data());
    }
    state.counters["size"] = static_cast<double>(indices.size());
}
BENCHMARK(train)
    ->Arg(250)
    ->Arg(500)
    ->Arg(1000)
    ->Arg(2000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

/// Argument: side of a hypar, every free node surveyed with 0.5 mm of noise; no draws.
void identify(benchmark::State& state) {
    const auto side = static_cast<int>(state.range(0));
    const CableNet net = taut::hypar(side, side);
    const taut::Equilibrium built =
        taut::EquilibriumSolver(net).solve(drawn_lengths(net), net.nodes());
    require_converged(state, built);
    taut::Survey survey{.form = built.form,
                        .noise_std = taut::Points::Constant(3, net.node_count(), 0.0005),
                        .surveyed = net.free_nodes(),
                        .missing = {}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::identify(net, survey,
                                                {.method = taut::IdentificationMethod::map,
                                                 .prior = one_millimetre,
                                                 .assume_site = false,
                                                 .draws = 0})
                                     .edges.data());
    }
    state.counters["size"] = net.interior_edge_count();
}
BENCHMARK(identify)
    ->Arg(20)
    ->Arg(40)
    ->Arg(80)
    ->Arg(160)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

}  // namespace
