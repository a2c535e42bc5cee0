// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// Gain by several threads of the caller, each calling taut on one thread.
#include <benchmark/benchmark.h>

#include <functional>
#include <random>

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/threads.hpp"

namespace {

using taut::CableNet;

constexpr taut::LengthPrior prior{.kind = taut::LengthPrior::Kind::uniform, .scale = 0.005};

/// Read by all threads.
struct Shared {
    CableNet net = taut::hilo_quarter();
    taut::Survey survey;
    taut::LengthModel model;

    Shared() {
        const Eigen::VectorXd deviations =
            taut::draw_length_deviations(prior, 1, 0, net.interior_edge_count());
        survey.form = taut::EquilibriumSolver(net)
                          .solve(taut::with_length_deviations(net, deviations), net.nodes())
                          .form;
        survey.noise_std = taut::Points::Constant(3, net.node_count(), 5e-4);
        survey.surveyed = net.free_nodes();
        std::mt19937_64 random(1);
        std::normal_distribution<double> normal(0.0, 5e-4);
        for (const int node : net.free_nodes()) {
            for (int k = 0; k < 3; ++k) {
                survey.form(k, node) += normal(random);
            }
        }
        const taut::Sampler sampler(net, prior, 1);
        taut::DataSet data = sampler.no_samples();
        sampler.extend_to(data, 200);
        model = taut::train_model(net, data, data.converged_in(0, data.size()));
    }
};

const Shared& shared() {
    static const Shared instance;
    return instance;
}

void on_one_thread_a_call(benchmark::State& state, const std::function<void(int call)>& work) {
    static_cast<void>(shared());
    int call = state.thread_index();
    for (auto _ : state) {
        taut::with_threads(1, [&] { work(call += state.threads()); });
    }
    state.SetItemsProcessed(state.iterations());
}

void equilibria(benchmark::State& state) {
    taut::EquilibriumSolver solver(shared().net);  // one a thread
    on_one_thread_a_call(state, [&](int call) {
        const CableNet& net = shared().net;
        const Eigen::VectorXd deviations =
            taut::draw_length_deviations(prior, 2, call, net.interior_edge_count());
        benchmark::DoNotOptimize(
            solver.solve(taut::with_length_deviations(net, deviations), net.nodes()).form.data());
    });
}

void map(benchmark::State& state) {
    on_one_thread_a_call(state, [](int /*call*/) {
        taut::IdentifyOptions options;
        options.method = taut::IdentificationMethod::map;
        options.prior = prior;
        options.assume_site = false;
        options.draws = 0;
        benchmark::DoNotOptimize(
            taut::identify(shared().net, shared().survey, options).edges.data());
    });
}

void processes(benchmark::State& state) {
    on_one_thread_a_call(state, [](int /*call*/) {
        taut::IdentifyOptions options;
        options.method = taut::IdentificationMethod::gp;
        options.model = &shared().model;
        benchmark::DoNotOptimize(
            taut::identify(shared().net, shared().survey, options).edges.data());
    });
}

void one_and_two(benchmark::internal::Benchmark* run) {
    run->Threads(1)->Threads(2)->UseRealTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK(equilibria)->Apply(one_and_two);
BENCHMARK(map)->Apply(one_and_two);
BENCHMARK(processes)->Apply(one_and_two);

}  // namespace
