// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// The two factorisations of taut and those of other libraries, on one core, without the symbolic
// work. Argument: side of a hypar; 0 is the built-in net. scripts/bench.sh leaves out the stiffness
// of side 300, which is for runs by hand.
#include <benchmark/benchmark.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <stdexcept>

#include "numerics/serial_blas.hpp"
#include "numerics/supernodal_factor.hpp"
#include "saddle_point_problem.hpp"
#include "statics/net_state.hpp"
#include "statics/stiffness_factor.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/threads.hpp"
#ifdef TAUT_HAS_MUMPS
#include "peers/mumps.hpp"
#endif

namespace {

using namespace taut;
using SparseMatrix = Eigen::SparseMatrix<double>;

CableNet net_of(const benchmark::State& state) {
    const auto side = static_cast<int>(state.range(0));
    return side == 0 ? hilo_quarter() : hypar(side, side);
}

void require(bool factorised) {
    if (!factorised) {
        throw std::runtime_error("no factor");
    }
}

/// The right side of a solution of ones.
Eigen::VectorXd right_side(const SparseMatrix& lower) {
    return lower.selfadjointView<Eigen::Lower>() * Eigen::VectorXd::Ones(lower.rows());
}

void require_balance(const SparseMatrix& lower, const Eigen::VectorXd& x,
                     const Eigen::VectorXd& b) {
    const Eigen::VectorXd residual = lower.selfadjointView<Eigen::Lower>() * x - b;
    if (!(residual.norm() < 1e-8 * b.norm())) {
        throw std::runtime_error("wrong solution");
    }
}

// The stiffness of a net at its nominal form: factor and one solution.

struct StiffnessProblem {
    explicit StiffnessProblem(const CableNet& net)
        : local(number_for_elimination(net)), stiffness(local) {
        NetState state(local);
        state.set_unstressed_lengths(local, net.unstressed_lengths());
        state.update(local);
        stiffness.matrix.assemble(local, state.edges());
        sparse = stiffness.matrix.to_sparse();
        b = right_side(sparse);
    }

    LocalNet local;
    Stiffness stiffness;
    SparseMatrix sparse;
    Eigen::VectorXd b;
};

void stiffness_taut(benchmark::State& state) {
    StiffnessProblem problem(net_of(state));
    Eigen::VectorXd x;
    for (auto _ : state) {
        require(problem.stiffness.factorize());
        x = problem.b;
        problem.stiffness.factor.solve(x);
    }
    require_balance(problem.sparse, x, problem.b);
}

/// By each of the two factors of StiffnessFactor, whatever the size.
void stiffness_nodal(benchmark::State& state) {
    const StiffnessProblem problem(net_of(state));
    NodalFactor factor(problem.stiffness.matrix);
    Eigen::VectorXd x;
    for (auto _ : state) {
        require(factor.factorize(problem.stiffness.matrix));
        x = problem.b;
        factor.solve(x);
    }
    require_balance(problem.sparse, x, problem.b);
}

void stiffness_supernodal(benchmark::State& state) {
    const StiffnessProblem problem(net_of(state));
    const StiffnessMatrix& matrix = problem.stiffness.matrix;
    std::vector<std::vector<int>> couplings(matrix.node_count());
    std::vector<std::vector<const StiffnessMatrix::Block*>> blocks(matrix.node_count());
    for (int j = 0; j < matrix.node_count(); ++j) {
        for (const StiffnessMatrix::Block& block : matrix.column(j)) {
            couplings[block.row].push_back(j);
            blocks[block.row].push_back(&block);
        }
    }
    SupernodalFactor factor(std::vector<int>(couplings.size(), 3), couplings,
                            Definiteness::positive_definite);
    const auto assemble = [&](int node, const SupernodalFactor::Places& places,
                              FrontMatrix& front) {
        const int own = places.of(3 * node);
        front.block<3, 3>(own, own) += matrix.diagonal(node);
        for (size_t k = 0; k < blocks[node].size(); ++k) {
            front.block<3, 3>(places.of(3 * couplings[node][k]), own) += blocks[node][k]->values;
        }
    };
    Eigen::VectorXd x;
    for (auto _ : state) {
        require(factor.factorize(assemble));
        x = factor.solve(problem.b);
    }
    require_balance(problem.sparse, x, problem.b);
    state.counters["gflop"] = 1e-9 * factor.operation_count();
}

void stiffness_eigen_ldlt(benchmark::State& state) {
    const StiffnessProblem problem(net_of(state));
    Eigen::SimplicialLDLT<SparseMatrix> factor;  // its own order: AMD
    factor.analyzePattern(problem.sparse);
    Eigen::VectorXd x;
    for (auto _ : state) {
        factor.factorize(problem.sparse);
        require(factor.info() == Eigen::Success);
        x = factor.solve(problem.b);
    }
    require_balance(problem.sparse, x, problem.b);
}

// The factor of the saddle-point matrix, and one solution.

void saddle_point_taut(benchmark::State& state) {
    SaddlePointProblem problem(net_of(state));
    const Eigen::VectorXd b = right_side(problem.lower);
    const auto parts = problem.by_parts(b);
    SaddlePointFactor::Vector x;
    for (auto _ : state) {
        require(problem.factor.factorize());
        x = problem.factor.solve(parts);
    }
    require_balance(problem.lower, problem.together(x), b);
}

/// In taut's order, in which no pivot is zero. In Eigen's own order pivots vanish.
void saddle_point_eigen_ldlt(benchmark::State& state) {
    const SaddlePointProblem problem(net_of(state));
    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor;
    factor.analyzePattern(problem.lower);
    const Eigen::VectorXd b = right_side(problem.lower);
    Eigen::VectorXd x;
    for (auto _ : state) {
        factor.factorize(problem.lower);
        require(factor.info() == Eigen::Success);
        x = factor.solve(b);
    }
    require_balance(problem.lower, x, b);
}

void saddle_point_eigen_lu(benchmark::State& state) {
    const SaddlePointProblem problem(net_of(state));
    const SparseMatrix whole = problem.lower.selfadjointView<Eigen::Lower>();
    Eigen::SparseLU<SparseMatrix> factor;
    factor.analyzePattern(whole);
    const Eigen::VectorXd b = right_side(problem.lower);
    Eigen::VectorXd x;
    for (auto _ : state) {
        factor.factorize(whole);
        require(factor.info() == Eigen::Success);
        x = factor.solve(b);
    }
    require_balance(problem.lower, x, b);
}

// Entries of the inverse, after the factor: the covariances of all places and lengths (by taut also
// of extensions).

void covariance_taut(benchmark::State& state) {
    SaddlePointProblem problem(net_of(state));
    require(problem.factor.factorize());
    for (auto _ : state) {
        benchmark::DoNotOptimize(problem.factor.covariance());
    }
}

#ifdef TAUT_HAS_MUMPS
void saddle_point_mumps(benchmark::State& state) {
    const SaddlePointProblem problem(net_of(state));
    Mumps factor(problem.lower);
    const Eigen::VectorXd b = right_side(problem.lower);
    Eigen::VectorXd x;
    for (auto _ : state) {
        factor.factorize();
        x = factor.solve(b);
    }
    require_balance(problem.lower, x, b);
}

void covariance_mumps(benchmark::State& state) {
    SaddlePointProblem problem(net_of(state));
    const SaddlePointLayout& layout = problem.layout;
    std::vector<std::vector<int>> rows(problem.lower.rows());
    for (const int place : layout.place) {
        for (int k = 0; k < 3; ++k) {
            for (int a = 0; a <= k; ++a) {
                rows[place + k].push_back(place + a);
            }
        }
    }
    for (const int length : layout.length) {
        if (length >= 0) {
            rows[length].push_back(length);
        }
    }
    Mumps factor(problem.lower);
    factor.factorize();
    std::vector<double> entries;
    for (auto _ : state) {
        entries = factor.inverse_entries(rows);
    }
    require(problem.factor.factorize());
    const auto covariance = problem.factor.covariance();
    // The diagonal entry is the last of each column.
    Eigen::VectorXd diagonal(problem.lower.rows());
    size_t end = 0;
    for (size_t j = 0; j < rows.size(); ++j) {
        end += rows[j].size();
        diagonal[j] = rows[j].empty() ? 0.0 : entries[end - 1];
    }
    const auto found = problem.by_parts(diagonal);
    require((found.lengths - covariance.lengths).cwiseAbs().maxCoeff() < 1e-6);
}
#else
void saddle_point_mumps(benchmark::State& state) {
    state.SkipWithError("built without MUMPS: libmumps-seq-dev");
}

void covariance_mumps(benchmark::State& state) {
    saddle_point_mumps(state);
}
#endif

/// On one thread, as the other libraries.
template <void (*run)(benchmark::State&)>
void on_one_thread(benchmark::State& state) {
    const SerialBlas serial;
    with_threads(1, [&] { run(state); });
}

void small_and_large(benchmark::internal::Benchmark* run) {
    run->Arg(0)->Arg(30)->Arg(100)->Unit(benchmark::kMillisecond);
}
void with_the_largest(benchmark::internal::Benchmark* run) {
    small_and_large(run);
    run->Arg(300);
}
BENCHMARK(stiffness_taut)->Apply(with_the_largest);
BENCHMARK(stiffness_nodal)->Apply(with_the_largest);
BENCHMARK(on_one_thread<stiffness_supernodal>)
    ->Name("stiffness_supernodal")
    ->Apply(with_the_largest);
BENCHMARK(stiffness_eigen_ldlt)->Apply(with_the_largest);
BENCHMARK(on_one_thread<saddle_point_taut>)->Name("saddle_point_taut")->Apply(small_and_large);
BENCHMARK(saddle_point_eigen_ldlt)->Apply(small_and_large);
BENCHMARK(saddle_point_eigen_lu)->Apply(small_and_large);
BENCHMARK(on_one_thread<saddle_point_mumps>)->Name("saddle_point_mumps")->Apply(small_and_large);
BENCHMARK(on_one_thread<covariance_taut>)->Name("covariance_taut")->Apply(small_and_large);
BENCHMARK(on_one_thread<covariance_mumps>)->Name("covariance_mumps")->Apply(small_and_large);

}  // namespace
