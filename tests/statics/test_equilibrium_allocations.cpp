// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against memory being taken inside the iteration: with one solver a thread, threads would
// wait for each other at the allocator. The sanitizers bring their own malloc, so the test is
// skipped with them.
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>

#include "support/random_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"

// GCC shows the sanitizers by macros, Clang by features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAUT_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TAUT_SANITIZED 1
#endif
#endif

#if defined(__GLIBC__) && !defined(TAUT_SANITIZED)
#define TAUT_COUNTS_ALLOCATIONS 1

namespace {
std::atomic<long> allocations{0};
}

// All of operator new, Eigen and the standard library end in malloc, and this one comes first. The
// C library's own stands behind it under another name.
extern "C" {
void* __libc_malloc(std::size_t size);  // NOLINT(bugprone-reserved-identifier)

void* malloc(std::size_t size) noexcept {
    ++allocations;
    return __libc_malloc(size);
}
}
#endif

namespace taut {
namespace {

#ifdef TAUT_COUNTS_ALLOCATIONS

struct Count {
    long allocations = 0;
    Equilibrium equilibrium;
};

Count count(EquilibriumSolver& solver, const Eigen::VectorXd& lengths, const Points& start) {
    const long before = allocations;
    Equilibrium equilibrium = solver.solve(lengths, start);
    return {allocations - before, std::move(equilibrium)};
}

TEST(EquilibriumSolverAllocations, AreCounted) {
    const long before = allocations;
    const Eigen::VectorXd by_eigen(100);
    const std::vector<double> by_new(100);
    EXPECT_EQ(by_eigen.size(), std::ssize(by_new));
    EXPECT_EQ(allocations - before, 2);
}

TEST(EquilibriumSolverAllocations, AreAsManyForManyStepsAsForFew) {
    const CableNet net = hilo_quarter();
    test::Random random(1);
    EquilibriumSolver solver(net);
    const Eigen::VectorXd lengths =
        with_length_deviations(net, test::uniform_vector(random, net.interior_edge_count(), 1e-3));
    const Points far_start = test::uniform_points(random, net.node_count(), 3.0);
    const Count near = count(solver, lengths, net.nodes());
    const Count far = count(solver, lengths, far_start);
    ASSERT_EQ(near.equilibrium.status, EquilibriumStatus::converged);
    ASSERT_EQ(far.equilibrium.status, EquilibriumStatus::converged);
    EXPECT_GT(near.equilibrium.iterations, 1);
    EXPECT_GT(far.equilibrium.iterations, near.equilibrium.iterations + 5);
    EXPECT_EQ(far.allocations, near.allocations);
}

TEST(EquilibriumSolverAllocations, AreAsManyWithInteriorPointSteps) {
    CableNetData data = hypar(8, 8).data();
    data.unstressed_lengths *= 1.05;
    data.loads.row(2).setConstant(-1.0);
    const CableNet net(std::move(data));
    EquilibriumSolver solver(net);
    const Points form = solver.solve(net.unstressed_lengths(), net.nodes()).form;
    const Count far = count(solver, net.unstressed_lengths(), net.nodes());
    const Count near = count(solver, net.unstressed_lengths(), form);
    ASSERT_GT(far.equilibrium.iterations, std::ssize(far.equilibrium.energy_decreases));
    ASSERT_EQ(near.equilibrium.iterations, std::ssize(near.equilibrium.energy_decreases));
    EXPECT_EQ(far.equilibrium.slack_edges, near.equilibrium.slack_edges);
    EXPECT_EQ(far.allocations, near.allocations);
}

#else

TEST(EquilibriumSolverAllocations, AreAsManyForManyStepsAsForFew) {
    GTEST_SKIP() << "this build has no malloc that can be counted";
}

#endif

}  // namespace
}  // namespace taut
