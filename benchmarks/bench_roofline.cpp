// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The hot parts compared with the machine's peak. Each part counts the floating-point operations
// ("flops") or the bytes of main memory ("bytes") that the work needs at least, by any method. The
// peaks are measured here, too: products of large matrices (DGEMM), and the triad of STREAM (J. D.
// McCalpin, Memory bandwidth and machine balance in current high performance computers, IEEE TCCA
// Newsletter, 1995), with the write counted once. Argument: number of threads, 0 for all.
#include <benchmark/benchmark.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <Eigen/SparseCholesky>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <vector>

#include "numerics/dense.hpp"
#include "numerics/supernodal_factor.hpp"
#include "statics/net_state.hpp"
#include "statics/stiffness_factor.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/gp/kernel.hpp"
#include "taut/gp/spectrum.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/identification/model.hpp"
#include "taut/io/data_set_h5.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/form_sensitivity.hpp"
#include "taut/threads.hpp"

namespace {

using namespace taut;

constexpr int training_samples = 950;

void count_flops(benchmark::State& state, double needed) {
    state.counters["flops"] =
        benchmark::Counter(needed, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["needed"] = needed;
}

void count_bytes(benchmark::State& state, double needed) {
    state.counters["bytes"] =
        benchmark::Counter(needed, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["needed"] = needed;
}

template <void (*run)(benchmark::State&)>
void on_threads(benchmark::State& state) {
    const auto threads = static_cast<int>(state.range(0));
    if (threads > 0) {
        with_threads(threads, [&] { run(state); });
    } else {
        run(state);
    }
}

// The machine.

void dgemm(benchmark::State& state) {
    constexpr Eigen::Index n = 2000;
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(n, n);
    const Eigen::MatrixXd b = Eigen::MatrixXd::Random(n, n);
    for (auto _ : state) {
        benchmark::DoNotOptimize(product(a, b).data());
    }
    count_flops(state, 2.0 * std::pow(n, 3));
}

void triad(benchmark::State& state) {
    constexpr std::size_t n = std::size_t{1} << 24U;  // 128 MiB each: beyond all caches
    std::vector<double> a(n, 0.0);
    const std::vector<double> b(n, 1.0);
    const std::vector<double> c(n, 2.0);
    for (auto _ : state) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, n / 64), [&](const auto& part) {
            for (std::size_t i = part.begin(); i != part.end(); ++i) {
                a[i] = b[i] + 3.0 * c[i];
            }
        });
        benchmark::ClobberMemory();
    }
    count_bytes(state, 3.0 * sizeof(double) * static_cast<double>(n));
}

// Statics.

struct AssembledStiffness {
    explicit AssembledStiffness(const CableNet& net)
        : local(number_for_elimination(net, Ordering::thorough)), stiffness(local) {
        NetState state(local);
        state.set_unstressed_lengths(local, net.unstressed_lengths());
        state.update(local);
        stiffness.matrix.assemble(local, state.edges());
        lower_factor.analyzePattern(stiffness.matrix.to_sparse());
        lower_factor.factorize(stiffness.matrix.to_sparse());
    }

    /// Sum of c^2 over the columns of Eigen's factor, in the same order.
    [[nodiscard]] double operation_count() const {
        const auto& L = lower_factor.matrixL().nestedExpression();
        double sum = 0.0;
        for (Eigen::Index j = 0; j < L.cols(); ++j) {
            sum +=
                std::pow(static_cast<double>(L.outerIndexPtr()[j + 1] - L.outerIndexPtr()[j]), 2);
        }
        return sum;
    }
    [[nodiscard]] double entry_count() const {
        return static_cast<double>(lower_factor.matrixL().nestedExpression().nonZeros());
    }

    LocalNet local;
    Stiffness stiffness;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>
        lower_factor;
};

void factorise(benchmark::State& state, const CableNet& net) {
    AssembledStiffness assembled(net);
    for (auto _ : state) {
        if (!assembled.stiffness.factorize()) {
            throw std::runtime_error("no factor");
        }
    }
    count_flops(state, assembled.operation_count());
}

void stiffness_of_the_builtin_net(benchmark::State& state) {
    factorise(state, hilo_quarter());
}
void stiffness_of_hypar_300(benchmark::State& state) {
    factorise(state, hypar(300, 300));
}

/// From the linear prediction, lengths within 5 mm: at least one factorisation and one solution.
void form_of_the_builtin_net(benchmark::State& state) {
    const CableNet net = hilo_quarter();
    EquilibriumSolver solver(net);
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    const Eigen::VectorXd nominal = free_coordinates(net, net.nodes());
    std::uint64_t sample = 0;
    for (auto _ : state) {
        const Eigen::VectorXd changes =
            with_length_deviations(
                net, draw_length_deviations({}, 1, sample++, net.interior_edge_count())) -
            net.unstressed_lengths();
        benchmark::DoNotOptimize(
            solver
                .solve(net.unstressed_lengths() + changes,
                       with_free_coordinates(net, nominal + sensitivity.apply(changes)))
                .form.data());
    }
    const AssembledStiffness assembled(net);
    count_flops(state, assembled.operation_count() + 4.0 * assembled.entry_count());
}

/// Of all interior edges: a pair of triangular solves a column.
void sensitivities_of_the_builtin_net(benchmark::State& state) {
    const CableNet net = hilo_quarter();
    const FormSensitivity sensitivity(net, net.unstressed_lengths(), net.nodes());
    for (auto _ : state) {
        benchmark::DoNotOptimize(sensitivity.columns(net.interior_edges()).data());
    }
    count_flops(state, 4.0 * AssembledStiffness(net).entry_count() *
                           static_cast<double>(net.interior_edges().size()));
}

/// Of the stiffness, as an indefinite matrix; Z_qq L_qp of each front, twice the work of its
/// factor.
void selected_inverse_of_hypar_100(benchmark::State& state) {
    const CableNet net = hypar(100, 100);
    const AssembledStiffness assembled(net);
    const StiffnessMatrix& matrix = assembled.stiffness.matrix;
    std::vector<std::vector<int>> couplings(matrix.node_count());
    std::vector<std::vector<const StiffnessMatrix::Block*>> blocks(matrix.node_count());
    for (int j = 0; j < matrix.node_count(); ++j) {
        for (const StiffnessMatrix::Block& block : matrix.column(j)) {
            couplings[block.row].push_back(j);
            blocks[block.row].push_back(&block);
        }
    }
    SupernodalFactor factor(std::vector<int>(couplings.size(), 3), couplings);
    if (!factor.factorize(
            [&](int node, const SupernodalFactor::Places& places, FrontMatrix& front) {
                const int own = places.of(3 * node);
                front.block<3, 3>(own, own) += matrix.diagonal(node);
                for (size_t k = 0; k < blocks[node].size(); ++k) {
                    front.block<3, 3>(places.of(3 * couplings[node][k]), own) +=
                        blocks[node][k]->values;
                }
            })) {
        throw std::runtime_error("no factor");
    }
    for (auto _ : state) {
        factor.selected_inverse([](int, const SupernodalFactor::Places&, const FrontMatrix& Z) {
            benchmark::DoNotOptimize(Z.data());
        });
    }
    count_flops(state, 2.0 * assembled.operation_count());
}

// Learning, the paper's counts.

const CableNet& net() {
    static const CableNet built_in = hilo_quarter();
    return built_in;
}

const DataSet& data_set() {
    static const DataSet data = [] {
        const Sampler sampler(net(), {}, 1);
        DataSet drawn = sampler.no_samples();
        sampler.extend_to(drawn, 1000);
        return drawn;
    }();
    return data;
}

const LengthModel& model() {
    static const LengthModel trained =
        train_model(net(), data_set(), data_set().converged_in(0, training_samples));
    return trained;
}

Eigen::MatrixXd inputs() {
    return data_set().form_deviations.leftCols(training_samples);
}

/// x' x of all pairs, one triangle.
void squared_distances_of_950_forms(benchmark::State& state) {
    const Eigen::MatrixXd x = inputs();
    for (auto _ : state) {
        benchmark::DoNotOptimize(gp::squared_distances(x).data());
    }
    count_flops(state, static_cast<double>(x.rows()) * std::pow(x.cols(), 2));
}

/// Each entry is read and written once, with one exponential.
void correlations_of_950_forms(benchmark::State& state) {
    const Eigen::MatrixXd distances = gp::squared_distances(inputs());
    for (auto _ : state) {
        benchmark::DoNotOptimize(gp::correlation(distances, 0.1).data());
    }
    count_bytes(state, 2.0 * sizeof(double) * static_cast<double>(distances.size()));
}

/// 4/3 n^3 to tridiagonal form, half of it in matrix-vector products; 4/3 n^3 for its vectors by
/// divide and conquer without deflation; 2 n^3 for the back-transformation.
void eigendecomposition_of_950(benchmark::State& state) {
    const Eigen::MatrixXd distances = gp::squared_distances(inputs());
    for (auto _ : state) {
        benchmark::DoNotOptimize(gp::kernel_spectrum(distances, 0.1).eigenvalues.data());
    }
    count_flops(state, 14.0 / 3.0 * std::pow(training_samples, 3));
}

/// Eigenvectors of each spectrum, weights and inputs are read once.
void prediction_of_536_lengths(benchmark::State& state) {
    const LengthModel& trained = model();
    const Eigen::VectorXd form = data_set().form_deviations.col(training_samples);
    for (auto _ : state) {
        benchmark::DoNotOptimize(estimate_lengths(net(), trained, form).mean.data());
    }
    double numbers =
        static_cast<double>(trained.processes.weights.size() + trained.processes.inputs.size());
    for (const gp::KernelSpectrum& spectrum : trained.processes.spectra) {
        numbers += static_cast<double>(spectrum.eigenvectors.size());
    }
    count_bytes(state, sizeof(double) * numbers);
}

// Files.

void hdf5_of_1000_samples(benchmark::State& state) {
    const NetFile file{.net = net()};
    double size = 0.0;
    for (auto _ : state) {
        const std::string bytes = data_set_bytes(data_set(), file);
        benchmark::DoNotOptimize(bytes.data());
        size = static_cast<double>(bytes.size());
    }
    count_bytes(state, size);
}

/// Argument: threads.
template <void (*run)(benchmark::State&)>
void measure(const char* name, std::initializer_list<int> threads) {
    auto* registered = benchmark::RegisterBenchmark(name, on_threads<run>);
    registered->ArgName("threads")->Unit(benchmark::kMillisecond)->UseRealTime();
    for (const int count : threads) {
        registered->Arg(count);
    }
}

const bool registered = [] {
    measure<dgemm>("dgemm", {1, 0});
    measure<triad>("triad", {1, 0});
    measure<stiffness_of_the_builtin_net>("stiffness_of_the_builtin_net", {1});
    measure<stiffness_of_hypar_300>("stiffness_of_hypar_300", {0});
    measure<form_of_the_builtin_net>("form_of_the_builtin_net", {1});
    measure<sensitivities_of_the_builtin_net>("sensitivities_of_the_builtin_net", {0});
    measure<selected_inverse_of_hypar_100>("selected_inverse_of_hypar_100", {0});
    measure<squared_distances_of_950_forms>("squared_distances_of_950_forms", {0});
    measure<correlations_of_950_forms>("correlations_of_950_forms", {0});
    measure<eigendecomposition_of_950>("eigendecomposition_of_950", {0});
    measure<prediction_of_536_lengths>("prediction_of_536_lengths", {0});
    measure<hdf5_of_1000_samples>("hdf5_of_1000_samples", {1});
    return true;
}();

}  // namespace
