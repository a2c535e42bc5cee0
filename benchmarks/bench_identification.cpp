// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// From one survey to lengths with standard deviations, by the two methods without training.
#include <benchmark/benchmark.h>

#include <random>

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/equilibrium.hpp"

namespace {

using taut::CableNet;

constexpr taut::LengthPrior prior{.kind = taut::LengthPrior::Kind::uniform, .scale = 0.005};

/// The form of drawn lengths with normal noise on each free coordinate.
taut::Survey survey_of(const CableNet& net, double noise_std) {
    const Eigen::VectorXd deviations =
        taut::draw_length_deviations(prior, 1, 0, net.interior_edge_count());
    taut::Survey survey{
        .form = taut::EquilibriumSolver(net)
                    .solve(taut::with_length_deviations(net, deviations), net.nodes())
                    .form,
        .noise_std = taut::Points::Constant(3, net.node_count(), noise_std),
        .surveyed = net.free_nodes(),
        .missing = {}};
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(0.0, 1.0);
    for (const int node : net.free_nodes()) {
        for (int k = 0; k < 3; ++k) {
            survey.form(k, node) += noise_std * normal(random);
        }
    }
    return survey;
}

double metres(const benchmark::State& state) {
    return 1e-4 * static_cast<double>(state.range(0));
}

/// Argument: noise in tenths of a millimetre.
void balance(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    const taut::Survey survey = survey_of(net, metres(state));
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            taut::identify(net, survey,
                           {.method = taut::IdentificationMethod::balance, .prior = prior})
                .edges.data());
    }
}
BENCHMARK(balance)->Arg(0)->Arg(5)->Unit(benchmark::kMillisecond);

/// Lengths alone: nothing else uncertain, no samples.
void map_lengths(benchmark::State& state, const CableNet& net, double noise) {
    const taut::Survey survey = survey_of(net, noise);
    const taut::IdentifyOptions options{.method = taut::IdentificationMethod::map,
                                        .prior = prior,
                                        .assume_site = false,
                                        .draws = 0};
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::identify(net, survey, options).edges.data());
    }
}

void map(benchmark::State& state) {
    map_lengths(state, taut::hilo_quarter(), metres(state));
}
BENCHMARK(map)->Arg(0)->Arg(1)->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

/// Argument: side of the net; 158 makes 50,000 edges.
void map_of_hypar(benchmark::State& state) {
    const auto side = static_cast<int>(state.range(0));
    map_lengths(state, taut::hypar(side, side), 0.0005);
}
BENCHMARK(map_of_hypar)->Arg(30)->Arg(158)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
