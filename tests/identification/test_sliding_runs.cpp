// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lengths of runs that slide which are sure and wrong: a length that passed through
// a clamp is no error of cutting, and friction that was not given is none of the tensions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "identification/simulated_survey.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"

namespace taut {
namespace {

/// Distance from the truth in standard deviations, root mean square over surveys.
struct Scores {
    double lengths = 0.0;         ///< of the stretch
    double tensions = 0.0;        ///< of the stretch
    double edges = 0.0;           ///< of lengths between nodes
    double drawn_tensions = 0.0;  ///< of edges, by samples
    int passed = 0;
};

constexpr int surveys = 60;

/// Of the one stretch of a net.
/// @param built the net with the lengths that the surveys are of; `net` is what taut is given
/// @param options besides the prior
Scores scores_of(const CableNet& net, const CableNet& built, IdentifyOptions options = {}) {
    const LengthPrior prior{LengthPrior::Kind::normal, 2e-3};
    options.prior = prior;
    Scores result;
    for (int seed = 0; seed < surveys; ++seed) {
        const test::SimulatedSurvey s = test::simulate(built, prior, 0.5e-3, seed);
        EXPECT_TRUE(s.truth.balanced());
        const Identification found = identify(net, s.survey, options);
        EXPECT_EQ(found.stretches.size(), 1U);
        const StretchLength& stretch = found.stretches.at(0);
        double deviation = 0.0;
        for (const int edge : stretch.edges) {
            const int i = net.interior_index(edge);
            deviation += i >= 0 ? s.deviations(i) : 0.0;
        }
        const Eigen::VectorXd tension = tensions(built, s.truth.unstressed_lengths, s.truth.form);
        result.lengths += std::pow((stretch.length_deviation - deviation) / stretch.std, 2);
        result.tensions +=
            std::pow((stretch.tension - tension(stretch.edges).mean()) / stretch.tension_std, 2);
        for (const IdentifiedEdge& edge : found.edges) {
            const double true_deviation =
                s.truth.unstressed_lengths(edge.edge) - net.unstressed_lengths()(edge.edge);
            result.edges += std::pow((edge.length_deviation - true_deviation) / edge.std, 2) /
                            static_cast<double>(found.edges.size());
        }
        for (const DrawnTension& drawn : found.drawn.tensions) {
            result.drawn_tensions +=
                std::pow((drawn.tension.mean - tension(drawn.edge)) / drawn.tension.std, 2) /
                static_cast<double>(found.drawn.tensions.size());
        }
        result.passed += found.trust.verdict() == Trust::Verdict::passed ? 1 : 0;
    }
    result.lengths = std::sqrt(result.lengths / surveys);
    result.tensions = std::sqrt(result.tensions / surveys);
    result.edges = std::sqrt(result.edges / surveys);
    result.drawn_tensions = std::sqrt(result.drawn_tensions / surveys);
    return result;
}

CableNet ridge(double friction) {
    CableNetData data = sliding_ridge().data();
    data.runs.at(0).friction = friction;
    return CableNet(std::move(data));
}

/// The root mean square of 60 normal numbers is 1.00 +- 0.09.
void expect_normal(const Scores& scores) {
    EXPECT_NEAR(scores.lengths, 1.0, 0.2);
    EXPECT_NEAR(scores.tensions, 1.0, 0.2);
    EXPECT_NEAR(scores.edges, 1.0, 0.1);
    EXPECT_GE(scores.passed, surveys - 3);
}

TEST(SlidingRuns, OneLengthFromClampToClampIsFound) {
    for (const double friction : {0.0, 0.1}) {
        const CableNet net = ridge(friction);
        expect_normal(scores_of(net, net, {.prior_exact = true}));
    }
}

TEST(SlidingRuns, FrictionThatIsNotKnownIsPartOfTheInterval) {
    CableNetData data = sliding_ridge().data();
    data.runs.at(0).friction.reset();
    const CableNet net(std::move(data));
    for (const double friction : {0.0, 0.1, 0.3}) {
        const Scores scores = scores_of(net, ridge(friction), {.draws = 60});
        expect_normal(scores);
        EXPECT_NEAR(scores.drawn_tensions, 1.0, 0.2);
    }
}

TEST(SlidingRuns, FrictionMayBeALittleMoreThanGiven) {
    expect_normal(scores_of(ridge(0.05), ridge(0.1), {.prior_exact = true}));
}

TEST(SlidingRuns, AnErrorOfAStretchIsThatOfNoSingleEdge) {
    const CableNet net = ridge(0.1);
    const LengthPrior prior{LengthPrior::Kind::normal, 2e-3};
    const test::SimulatedSurvey s =
        test::simulate(net, prior, 0.5e-3, 3, [&](Eigen::VectorXd& deviations) {
            deviations(net.interior_index(net.data().runs.at(0).edges.at(3))) += 40e-3;
        });
    const Identification found = identify(net, s.survey, {.prior = prior, .prior_exact = true});
    EXPECT_TRUE(found.boundary_outliers.empty());  // nor of a turnbuckle
    ASSERT_EQ(found.length_outliers.size(), 1U);
    EXPECT_NEAR(found.stretches.at(0).length_deviation, 40e-3, 15e-3);
    EXPECT_EQ(found.trust.verdict(), Trust::Verdict::doubtful);
    EXPECT_THAT(found.trust.findings.at(0).reason,
                testing::HasSubstr("or another of the cable that slides from 0 to 7 is "));
}

TEST(SlidingRuns, SlipsAreThoseOfTheNetAsBuilt) {
    const CableNet net = ridge(0.1);
    const LengthPrior prior{LengthPrior::Kind::normal, 2e-3};
    const test::SimulatedSurvey s = test::simulate(net, prior, 0.1e-3, 3);
    const Identification found = identify(net, s.survey, {.prior = prior, .prior_exact = true});
    const Eigen::VectorXd marked = with_length_deviations(net, s.deviations);
    double slip = 0.0;
    int count = 0;
    for (const ParameterEstimate& one : found.uncertain) {
        ASSERT_EQ(one.parameter.kind, UncertainParameter::Kind::slip);
        const SlidingNode& at = net.sliding_nodes().at(count++);
        ASSERT_EQ(one.edge, at.after);
        slip += marked(at.before) - s.truth.unstressed_lengths(at.before);
        EXPECT_NEAR(one.mean, slip, 4.0 * one.std);
    }
    EXPECT_EQ(count, std::ssize(net.sliding_nodes()));
    // The form follows from lengths and slips.
    EXPECT_LT((found.predicted.form - s.truth.form).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(SlidingRuns, WhatTakesEdgesAsClampedIsRefused) {
    const CableNet net = ridge(0.1);
    const test::SimulatedSurvey s =
        test::simulate(net, {LengthPrior::Kind::normal, 2e-3}, 0.5e-3, 1);
    const auto refused = [&](const IdentifyOptions& options, const char* text) {
        EXPECT_THAT([&] { (void)identify(net, s.survey, options); },
                    testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(text)));
    };
    refused({.method = IdentificationMethod::gp}, "expected the method map");
    refused({.forces = {.measurements = {{.edge = 1, .tension = 30e3, .std = 300.0}}}},
            "measure an edge that is clamped at both ends");
}

}  // namespace
}  // namespace taut
