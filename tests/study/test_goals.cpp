// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against ways of identification that fall behind what they can reach.

#include <gtest/gtest.h>

#include <stdexcept>

#include "taut/design/builtin_nets.hpp"
#include "taut/study/comparison.hpp"

namespace {

using namespace taut;

const ComparisonRow& row_at(const Comparison& comparison, const std::string& method,
                            const SurveyKind& kind) {
    for (const ComparisonRow& row : comparison.rows) {
        if (row.result.name == method && row.kind == kind) {
            return row;
        }
    }
    throw std::logic_error("no such row");
}

double over_best(const Comparison& comparison, const std::string& method, const SurveyKind& kind) {
    const ComparisonRow& row = row_at(comparison, method, kind);
    EXPECT_EQ(row.result.failed, 0) << row.result.first_failure;
    return row.result.errors.mse / row.cramer_rao->mse;
}

TEST(Goals, AreReachedOnTheBuiltInNet) {
    const ComparisonSettings settings{.noises = {0.0, 1e-4, 5e-4},
                                      .training_samples = {950},
                                      .hidden_parts = {0.1},
                                      .surveys = 8};
    const Comparison comparison = compare_methods(hilo_quarter(), settings);
    EXPECT_LE(row_at(comparison, "balance", {}).result.mse_of_taut, 1e-20);
    EXPECT_LE(row_at(comparison, "map", {}).result.mse_of_taut, 1e-14);
    EXPECT_LE(row_at(comparison, "gp", {}).result.errors.mse, 8e-9);
    EXPECT_LE(over_best(comparison, "gp", {.noise_std = 1e-4}), 1.8);
    EXPECT_LE(over_best(comparison, "gp", {.noise_std = 5e-4}), 1.05);
    for (const double noise : {1e-4, 5e-4}) {
        EXPECT_LE(over_best(comparison, "map", {.noise_std = noise}), 1.05) << noise;
    }
    EXPECT_LE(over_best(comparison, "map", {.noise_std = 5e-4, .hidden_part = 0.1}), 1.05);
}

}  // namespace
