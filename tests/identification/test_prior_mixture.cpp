// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a mixture over priors that is narrower, or elsewhere, than its parts.

#include <gtest/gtest.h>

#include <numeric>

#include "identification/prior_mixture.hpp"
#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"

namespace {

using namespace taut;
using namespace taut::test;

TEST(PriorMixture, QuantilesAreThoseOfTheMixture) {
    EXPECT_NEAR(quantile_of({{1.0, 2.0, 1.0, 4.0}}, 0.025), 1.0, 1e-9);
    EXPECT_NEAR(quantile_of({{1.0, 2.0, 1.0, 4.0}}, 0.975), 4.0, 1e-9);
    EXPECT_NEAR(quantile_of({{0.5, -3.0, -4.0, -2.0}, {0.5, 3.0, 2.0, 4.0}}, 0.5), 0.0, 1e-6);
    // Half lies near -3, half near 3: each tail of 2.5 % is 5 % of its part.
    EXPECT_NEAR(quantile_of({{0.5, -3.0, -4.0, -2.0}, {0.5, 3.0, 2.0, 4.0}}, 0.975),
                3.0 + 1.6448536 / 1.9599640, 1e-6);
    EXPECT_EQ(quantile_of({{1.0, 2.0, 2.0, 2.0}}, 0.3), 2.0);
}

TEST(PriorMixture, SharesOutAllDraws) {
    for (const int draws : {0, 1, 7, 200}) {
        const std::vector<int> shares = shared_out(draws, {0.6, 0.25, 0.1, 0.05});
        EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), 0), draws);
        EXPECT_GE(*std::ranges::min_element(shares), 0);
    }
    EXPECT_EQ(shared_out(200, {0.6, 0.25, 0.1, 0.05}), (std::vector<int>{120, 50, 20, 10}));
}

TEST(PriorMixture, HasTheMeanAndVarianceOfItsParts) {
    const CableNet net = hypar(5, 5);
    const LengthPrior truth{LengthPrior::Kind::uniform, 0.003};
    const SimulatedSurvey s = simulate(net, truth, 0.5e-3, 4);
    const auto by = [&](double scale) {
        return test::identify_lengths(net, s.survey,
                                      {.method = IdentificationMethod::map,
                                       .prior = LengthPrior{LengthPrior::Kind::normal, scale},
                                       .prior_exact = true,
                                       .draws = 40});
    };
    const Identification narrow = by(0.001);
    const Identification wide = by(0.004);
    const Identification mixed = mixture_of(net, s.survey, {{0.75, narrow}, {0.25, wide}}, 40);
    for (size_t i = 0; i < mixed.edges.size(); ++i) {
        const IdentifiedEdge& a = narrow.edges[i];
        const IdentifiedEdge& b = wide.edges[i];
        const double mean = 0.75 * a.length_deviation + 0.25 * b.length_deviation;
        const double square =
            0.75 * (a.std_dev * a.std_dev + a.length_deviation * a.length_deviation) +
            0.25 * (b.std_dev * b.std_dev + b.length_deviation * b.length_deviation);
        EXPECT_NEAR(mixed.edges[i].length_deviation, mean, 1e-12);
        EXPECT_NEAR(mixed.edges[i].std_dev, std::sqrt(square - mean * mean), 1e-9);
        EXPECT_LT(mixed.edges[i].lower, mean);
        EXPECT_GT(mixed.edges[i].upper, mean);
    }
    ASSERT_EQ(mixed.draws->count(), 40);
    EXPECT_EQ(mixed.draws->tensions.leftCols(30), narrow.draws->tensions.leftCols(30));
    EXPECT_EQ(mixed.draws->tensions.rightCols(10), wide.draws->tensions.leftCols(10));
    EXPECT_EQ(std::ssize(mixed.drawn.tensions), net.edge_count());
}

TEST(PriorMixture, SaysBySomeOfWhichPriorsAForceWasLeftOut) {
    const CableNet net = hypar(3, 3);
    const SimulatedSurvey s = simulate(net, {LengthPrior::Kind::uniform, 0.003}, 0.5e-3, 4);
    Identification narrow = test::identify_lengths(net, s.survey, {});
    Identification wide = narrow;
    narrow.force_outliers = {{.edge = 3, .statistic = 20.0}, {.edge = 0, .statistic = 30.0}};
    wide.force_outliers = {{.edge = 3, .statistic = 40.0}};
    const std::vector<ForceOutlier> found =
        mixture_of(net, s.survey, {{0.75, narrow}, {0.25, wide}}, 0).force_outliers;
    ASSERT_EQ(std::ssize(found), 2);
    EXPECT_EQ(found[0].edge, 0);
    EXPECT_EQ(found[0].probability, 0.75);
    EXPECT_EQ(found[1].probability, 1.0);
}

TEST(PriorMixture, NamesADoubtedForceWhereMostPriorsDoubtIt) {
    const CableNet net = hypar(3, 3);
    const SimulatedSurvey s = simulate(net, {LengthPrior::Kind::uniform, 0.003}, 0.5e-3, 4);
    Identification narrow = test::identify_lengths(net, s.survey, {});
    Identification wide = narrow;
    narrow.force_outliers = {{.edge = 3, .statistic = 9.0, .probability = 0.0}};
    narrow.force_bias = ForceBias{.part = 0.1, .std_dev = 0.04, .probability = 0.0};
    const Identification mostly = mixture_of(net, s.survey, {{0.75, narrow}, {0.25, wide}}, 0);
    ASSERT_EQ(mostly.force_outliers.size(), 1U);
    EXPECT_EQ(mostly.force_outliers[0].probability, 0.0);
    ASSERT_TRUE(mostly.force_bias);
    const Identification hardly = mixture_of(net, s.survey, {{0.75, wide}, {0.25, narrow}}, 0);
    EXPECT_TRUE(hardly.force_outliers.empty());
    EXPECT_FALSE(hardly.force_bias);
}

}  // namespace
