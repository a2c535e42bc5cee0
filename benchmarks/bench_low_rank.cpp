// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// Training by decompositions and by low rank over the number of samples: seconds, and the error of
// the lengths of 500 other forms.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "taut/design/builtin_nets.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"

namespace {

constexpr int test_forms = 500;
constexpr int most_samples = 10'000;

const taut::CableNet& net() {
    static const taut::CableNet built_in = taut::hilo_quarter();
    return built_in;
}

/// The test forms come first, so that they do not depend on the number of samples.
const taut::DataSet& data_set() {
    static const taut::DataSet data = [] {
        const taut::Sampler sampler(net(), {}, 1);
        taut::DataSet drawn = sampler.no_samples();
        sampler.extend_to(drawn, test_forms + most_samples);
        return drawn;
    }();
    return data;
}

void train(benchmark::State& state, int most_decomposed) {
    const auto n = static_cast<int>(state.range(0));
    std::vector<int> samples(n);
    std::iota(samples.begin(), samples.end(), test_forms);
    taut::TrainingSettings settings;
    settings.fit.most_decomposed = most_decomposed;
    const Eigen::MatrixXd forms = data_set().form_deviations.leftCols(test_forms);
    const Eigen::MatrixXd lengths = data_set().length_deviations.leftCols(test_forms);
    for (auto _ : state) {
        const taut::LengthModel model = taut::train_model(net(), data_set(), samples, settings);
        state.PauseTiming();
        const taut::LengthEstimates found = taut::estimate_lengths(net(), model, forms);
        double off = 0.0;
        for (const taut::gp::Process& process : model.processes.processes) {
            off += process.approximation_error * process.approximation_error;
        }
        state.counters["squared_error_mm2"] = 1e6 * (found.mean - lengths).cwiseAbs2().mean();
        state.counters["mean_std_mm"] = 1e3 * found.std_dev.mean();
        state.counters["approximation_error_mm"] =
            1e3 * std::sqrt(off / static_cast<double>(model.processes.processes.size()));
        state.ResumeTiming();
    }
}

void by_decompositions(benchmark::State& state) {
    train(state, most_samples);
}
BENCHMARK(by_decompositions)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(3000)
    ->Arg(4000);

void by_low_rank(benchmark::State& state) {
    const auto fewer = static_cast<int>(state.range(0)) - 1;
    train(state, std::min(taut::gp::FitSettings().most_decomposed, fewer));
}
BENCHMARK(by_low_rank)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(3000)
    ->Arg(4000)
    ->Arg(10'000);

}  // namespace
