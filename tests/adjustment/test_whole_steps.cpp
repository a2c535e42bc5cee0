// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against rounding to whole steps that loses more of the form than necessary.
#include "adjustment/whole_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace taut {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

// The nearest change least, and the others can still compensate for them.
TEST(WholeSteps, FixTheStrokesNearestToAMultipleFirst) {
    std::vector<int> open(12);
    std::iota(open.begin(), open.end(), 0);
    const Eigen::VectorXd multiples = Eigen::VectorXd::Constant(12, 1e-3);
    Eigen::VectorXd strokes = multiples;
    for (int j = 0; j < 12; ++j) {
        strokes(j) += (j % 2 == 0 ? 1e-5 : -1e-5) * (12 - j);
    }
    EXPECT_THAT(next_to_fix(open, strokes, multiples), ElementsAre(11, 10, 9, 8, 7, 6, 5, 4));
    EXPECT_THAT(next_to_fix({3, 1, 2}, strokes, multiples), UnorderedElementsAre(1, 2, 3));
}

TEST(WholeSteps, FixAQuarterOfManyStrokesAtATime) {
    std::vector<int> open(60);
    std::iota(open.begin(), open.end(), 0);
    const Eigen::VectorXd strokes = Eigen::VectorXd::LinSpaced(60, 0.0, 1e-3);
    EXPECT_EQ(next_to_fix(open, strokes, Eigen::VectorXd::Zero(60)).size(), 15U);
}

}  // namespace
}  // namespace taut
