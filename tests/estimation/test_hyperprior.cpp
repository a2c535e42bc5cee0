// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards the quadrature over priors, and the evidence of a scale against that of a dense normal
// model.

#include <gtest/gtest.h>

#include <cmath>

#include "estimation/hyperprior.hpp"

namespace {

using namespace taut;

double moment(const std::vector<std::pair<double, double>>& nodes, int power) {
    double sum = 0.0;
    for (const auto& [place, weight] : nodes) {
        sum += weight * std::pow(place, power);
    }
    return sum;
}

TEST(Hyperprior, NodesHaveTheMomentsOfTheirDistribution) {
    const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(17, -2.0, 3.0);
    const Eigen::VectorXd weights = (-(places.array() - 0.4).square() + 0.3 * places.array()).exp();
    for (const int count : {1, 2, 3}) {
        const auto nodes = gauss_nodes(places, weights, count);
        ASSERT_EQ(std::ssize(nodes), count);
        for (int power = 0; power < 2 * count; ++power) {
            const double exact = weights.dot(places.array().pow(power).matrix()) / weights.sum();
            EXPECT_NEAR(moment(nodes, power), exact, 1e-12 * std::max(1.0, std::abs(exact)));
        }
    }
}

TEST(Hyperprior, NodesOfOnePlaceAreOne) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(17);
    weights(5) = 2.0;
    const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(17, -2.0, 3.0);
    const auto nodes = gauss_nodes(places, weights, 3);
    ASSERT_EQ(nodes.size(), 1U);
    EXPECT_DOUBLE_EQ(nodes[0].first, places(5));
    EXPECT_DOUBLE_EQ(nodes[0].second, 1.0);
}

TEST(Hyperprior, IsAroundWhatWasGiven) {
    const LengthPrior uniform{LengthPrior::Kind::uniform, 0.002};
    EXPECT_EQ(hyperprior_around(uniform).centre, uniform);
    EXPECT_GT(hyperprior_around(uniform).uniform_probability, 0.5);
    EXPECT_LT(hyperprior_around({LengthPrior::Kind::normal, 0.002}).uniform_probability, 0.5);
    EXPECT_EQ(hyperprior_around({LengthPrior::Kind::bimodal, 0.002}).uniform_probability, 0.0);
    EXPECT_GT(broad_hyperprior().log_std, hyperprior_around(uniform).log_std);
}

}  // namespace
