// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// Sampling, training and prediction with the paper's counts, on all cores.
#include <benchmark/benchmark.h>

#include "taut/design/builtin_nets.hpp"
#include "taut/gp/kernel.hpp"
#include "taut/gp/spectrum.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/sampling/sampler.hpp"

namespace {

constexpr int samples = 1000;
constexpr int training_samples = 950;

const taut::CableNet& net() {
    static const taut::CableNet built_in = taut::hilo_quarter();
    return built_in;
}

const taut::DataSet& data_set() {
    static const taut::DataSet data = [] {
        const taut::Sampler sampler(net(), {}, 1);
        taut::DataSet drawn = sampler.no_samples();
        sampler.extend_to(drawn, samples);
        return drawn;
    }();
    return data;
}

const taut::LengthModel& model() {
    static const taut::LengthModel trained =
        taut::train_model(net(), data_set(), data_set().converged_in(0, training_samples));
    return trained;
}

void sample_1000_forms(benchmark::State& state) {
    const taut::CableNet net = taut::hilo_quarter();
    for (auto _ : state) {
        const taut::Sampler sampler(net, {}, 1);
        taut::DataSet data = sampler.no_samples();
        sampler.extend_to(data, samples);
        benchmark::DoNotOptimize(data.form_deviations.data());
    }
}
BENCHMARK(sample_1000_forms)->Unit(benchmark::kMillisecond)->UseRealTime();

void one_kernel_spectrum(benchmark::State& state) {
    const Eigen::MatrixXd inputs = data_set().form_deviations.leftCols(training_samples);
    const Eigen::MatrixXd distances = taut::gp::squared_distances(inputs);
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::gp::kernel_spectrum(distances, 0.1).eigenvalues.data());
    }
}
BENCHMARK(one_kernel_spectrum)->Unit(benchmark::kMillisecond)->UseRealTime();

void train_536_processes(benchmark::State& state) {
    const std::vector<int> indices = data_set().converged_in(0, training_samples);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            taut::train_model(net(), data_set(), indices).processes.weights.data());
    }
}
BENCHMARK(train_536_processes)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(2);

void estimate_lengths_of_one_form(benchmark::State& state) {
    const taut::LengthModel& trained = model();
    const Eigen::VectorXd form = data_set().form_deviations.col(training_samples);
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::estimate_lengths(net(), trained, form).mean.data());
    }
}
BENCHMARK(estimate_lengths_of_one_form)->Unit(benchmark::kMillisecond)->UseRealTime();

/// With noise in the intervals, the search for gross errors, and the predicted form.
void identify_by_processes_from_a_noisy_survey(benchmark::State& state) {
    const taut::LengthModel& trained = model();
    const taut::Survey survey{
        .form = taut::with_free_coordinates(
            net(), data_set().nominal_form + data_set().form_deviations.col(training_samples)),
        .noise_std = taut::Points::Constant(3, net().node_count(), 0.0005),
        .surveyed = net().free_nodes(),
        .missing = {}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(taut::identify(net(), survey, {.model = &trained}).edges.data());
    }
}
BENCHMARK(identify_by_processes_from_a_noisy_survey)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
