// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
// Equilibrium solves on one core.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>

#include "taut/design/builtin_nets.hpp"
#include "taut/files/file.hpp"
#include "taut/interchange/compas_json.hpp"
#include "taut/interchange/net_import.hpp"
#include "taut/sampling/data_set.hpp"
#include "taut/statics/cone_program.hpp"
#include "taut/statics/duality.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace {

using taut::CableNet;

constexpr taut::LengthPrior five_millimetres{.kind = taut::LengthPrior::Kind::uniform,
                                             .scale = 0.005};
constexpr double spacing = 0.132;  // m, of the built-in nets

Eigen::VectorXd drawn_lengths(const CableNet& net, const taut::LengthPrior& prior,
                              std::uint64_t sample) {
    return taut::with_length_deviations(
        net, taut::draw_length_deviations(prior, 1, sample, net.interior_edge_count()));
}

void solve_from_nominal_form(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    taut::EquilibriumSolver solver(net);
    std::uint64_t sample = 0;
    std::int64_t steps = 0;
    for (auto _ : state) {
        const auto found =
            solver.solve(drawn_lengths(net, five_millimetres, sample++), net.nodes());
        steps += found.iterations;
    }
    state.counters["newton_steps"] =
        static_cast<double>(steps) / static_cast<double>(state.iterations());
}
BENCHMARK(solve_from_nominal_form)->Unit(benchmark::kMillisecond);

void solve_from_linear_prediction(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    taut::EquilibriumSolver solver(net);
    const taut::FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    const Eigen::VectorXd nominal = taut::free_coordinates(net, net.nodes());
    std::uint64_t sample = 0;
    std::int64_t steps = 0;
    for (auto _ : state) {
        const Eigen::VectorXd lengths = drawn_lengths(net, five_millimetres, sample++);
        const auto found = solver.solve(
            lengths, taut::with_free_coordinates(
                         net, nominal + sensitivity.apply(lengths - net.unstressed_lengths())));
        steps += found.iterations;
    }
    state.counters["newton_steps"] =
        static_cast<double>(steps) / static_cast<double>(state.iterations());
}
BENCHMARK(solve_from_linear_prediction)->Unit(benchmark::kMillisecond);

/// The real net of the HiLo roof, stiff steel cables under the weight of the concrete, with length
/// deviations up to 5 mm: far more than they stretch, so that hundreds go slack.
void solve_hilo(benchmark::State& state) {
    const char* const folder = std::getenv("TAUT_REAL_DATA");
    const std::filesystem::path file =
        std::filesystem::path(folder != nullptr ? folder : "../shared/data") / "hilo/cablenet.json";
    if (!std::filesystem::exists(file)) {
        state.SkipWithError("the real file does not exist: set TAUT_REAL_DATA to its folder");
        return;
    }
    const CableNet net = taut::import_net(taut::parse_compas(taut::read_file(file), file.string()),
                                          {.young = 205e9,
                                           .diameter_attribute = "size",
                                           .force_unit = 1e3,
                                           .loads = taut::ImportSettings::Loads::balance})
                             .net;
    taut::EquilibriumSolver solver(net);
    std::uint64_t sample = 0;
    std::int64_t steps = 0;
    for (auto _ : state) {
        const auto found =
            solver.solve(drawn_lengths(net, five_millimetres, sample++), net.nodes());
        steps += found.iterations;
        if (found.status != taut::EquilibriumStatus::converged) {
            state.SkipWithError("did not converge");
        }
    }
    state.counters["newton_steps"] =
        static_cast<double>(steps) / static_cast<double>(state.iterations());
}
BENCHMARK(solve_hilo)->Unit(benchmark::kMillisecond);

/// The same by the paper's cone program, which takes no start.
void solve_cone_program(benchmark::State& state, taut::ConeForm form) {
    if (!taut::cone_solver_available()) {
        state.SkipWithError("built without Clarabel");
        return;
    }
    const CableNet net = taut::hilo_quarter();
    std::uint64_t sample = 0;
    std::int64_t iterations = 0;
    for (auto _ : state) {
        const auto found = taut::solve_cone_program(
            net, drawn_lengths(net, five_millimetres, sample++), {.form = form});
        iterations += found.iterations;
        if (!found.solved()) {
            state.SkipWithError("not solved");
        }
    }
    state.counters["newton_steps"] =
        static_cast<double>(iterations) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(solve_cone_program, quadratic, taut::ConeForm::quadratic)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_cone_program, paper, taut::ConeForm::paper)->Unit(benchmark::kMillisecond);

void certify_a_form(benchmark::State& state) {
    const CableNet net = taut::hilo_quarter();
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            taut::energy_certificate(net, net.unstressed_lengths(), net.nodes()));
    }
}
BENCHMARK(certify_a_form)->Unit(benchmark::kMillisecond);

/// Symbolic work and one solve for lengths within +-1 % of the spacing.
void solve_hypar(benchmark::State& state) {
    const auto side = static_cast<int>(state.range(0));
    const CableNet net = taut::hypar(side, side);
    const Eigen::VectorXd lengths =
        drawn_lengths(net, {.kind = taut::LengthPrior::Kind::uniform, .scale = 0.01 * spacing}, 0);
    for (auto _ : state) {
        taut::EquilibriumSolver solver(net);
        const auto found = solver.solve(lengths, net.nodes());
        state.counters["newton_steps"] = found.iterations;
        if (found.status != taut::EquilibriumStatus::converged) {
            state.SkipWithError("did not converge");
        }
    }
}
BENCHMARK(solve_hypar)->Arg(30)->Arg(100)->Arg(300)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
