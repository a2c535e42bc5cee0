// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against samples that cannot be reproduced: draws that another compiler, seed width or
// sample count changes; and against miscounted samples.

#include "sampling/uniform_prior.hpp"
#include "taut/sampling/data_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace {

using taut::DataSet;
using taut::draw_length_deviations;
using taut::EquilibriumStatus;
using taut::LengthPrior;

using taut::test::uniform_5mm;

/// The draws as documented, from the standard library alone: the 52 upper bits of the engine, at
/// the middle of their cell in (0, 1), mapped to (-0.005, 0.005).
double expected_draw(std::uint64_t seed, std::uint64_t sample, int index) {
    std::seed_seq sequence{seed & 0xffffffffU, seed >> 32U, sample & 0xffffffffU, sample >> 32U};
    std::mt19937_64 engine(sequence);
    engine.discard(static_cast<unsigned>(index));
    const double u = (static_cast<double>(engine() / 4096) + 0.5) / 4503599627370496.0;
    return 0.005 * (2.0 * u - 1.0);
}

TEST(DrawLengthDeviations, ComesFromTheStandardEngineSeededBySeedAndSample) {
    const std::uint64_t seed = 0x0123456789abcdefU;
    const std::uint64_t sample = 0xfedcba9876543210U;
    const Eigen::VectorXd deviations = draw_length_deviations(uniform_5mm, seed, sample, 9);
    for (int i = 0; i < 9; ++i) {
        EXPECT_EQ(deviations(i), expected_draw(seed, sample, i)) << "deviation " << i;
    }
}

TEST(DrawLengthDeviations, GivesTheNumbersThatEarlierDataSetsHold) {
    // From tests/data/make_draws.py.
    const Eigen::VectorXd deviations = draw_length_deviations(uniform_5mm, 1, 0, 3);
    EXPECT_EQ(deviations(0), -0.000819159853374537);
    EXPECT_EQ(deviations(1), -0.0017097866901699332);
    EXPECT_EQ(deviations(2), -0.003441719149049719);
}

/// Five samples: the second is not converged, the third a slack mechanism.
DataSet five_samples() {
    return {.form_deviations = Eigen::MatrixXd::Zero(3, 5),
            .length_deviations = Eigen::MatrixXd::Zero(1, 5),
            .statuses = {EquilibriumStatus::converged, EquilibriumStatus::iteration_limit,
                         EquilibriumStatus::slack_mechanism, EquilibriumStatus::converged,
                         EquilibriumStatus::iteration_limit},
            .slack_counts = {0, 3, 2, 1, 0}};
}

TEST(DataSet, CountsItsSamples) {
    EXPECT_EQ(five_samples().size(), 5);
    EXPECT_EQ(five_samples().with_slack(), 3);
    EXPECT_EQ(five_samples().not_converged(), 2);
}

TEST(DataSet, ListsTheConvergedSamplesOfARange) {
    EXPECT_THAT(five_samples().converged_in(0, 5), testing::ElementsAre(0, 2, 3));
    EXPECT_THAT(five_samples().converged_in(1, 3), testing::ElementsAre(2));
    EXPECT_THAT(five_samples().converged_in(4, 5), testing::IsEmpty());
    EXPECT_THROW((void)five_samples().converged_in(0, 6), std::out_of_range);
    EXPECT_THROW((void)five_samples().converged_in(-1, 0), std::out_of_range);
    EXPECT_THROW((void)draw_length_deviations(LengthPrior{}, 1, 0, -1), std::invalid_argument);
}

}  // namespace
