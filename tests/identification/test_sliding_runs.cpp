// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lengths of runs that slide which are sure and wrong: a length that passed through
// a clamp is no error of cutting, and friction that was not given is none of the tensions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/epochs.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/predicted_precision.hpp"

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
        const Identification found = test::identify_lengths(net, s.survey, options);
        EXPECT_EQ(found.stretches.size(), 1U);
        const StretchLength& stretch = found.stretches.at(0);
        double deviation = 0.0;
        for (const int edge : stretch.edges) {
            const int i = net.interior_index(edge);
            deviation += i >= 0 ? s.deviations(i) : 0.0;
        }
        const Eigen::VectorXd tension =
            tensions_of(built, s.truth.unstressed_lengths, s.truth.form);
        result.lengths += std::pow((stretch.length_deviation - deviation) / stretch.std_dev, 2);
        result.tensions +=
            std::pow((stretch.tension - tension(stretch.edges).mean()) / stretch.tension_std, 2);
        for (const IdentifiedEdge& edge : found.edges) {
            const double true_deviation =
                s.truth.unstressed_lengths(edge.edge) - net.unstressed_lengths()(edge.edge);
            result.edges += std::pow((edge.length_deviation - true_deviation) / edge.std_dev, 2) /
                            static_cast<double>(found.edges.size());
        }
        for (const DrawnTension& drawn : found.drawn.tensions) {
            result.drawn_tensions +=
                std::pow((drawn.tension.mean - tension(drawn.edge)) / drawn.tension.std_dev, 2) /
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
    const Identification found =
        test::identify_lengths(net, s.survey, {.prior = prior, .prior_exact = true});
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
    const Identification found =
        test::identify_lengths(net, s.survey, {.prior = prior, .prior_exact = true});
    const Eigen::VectorXd marked = with_length_deviations(net, s.deviations);
    double slip = 0.0;
    int count = 0;
    for (const ParameterEstimate& one : found.uncertain) {
        ASSERT_EQ(one.parameter.kind, UncertainParameter::Kind::slip);
        const SlidingNode& at = net.sliding_nodes().at(count++);
        ASSERT_EQ(one.edge, at.after);
        slip += marked(at.before) - s.truth.unstressed_lengths(at.before);
        EXPECT_NEAR(one.mean, slip, 4.0 * one.std_dev);
    }
    EXPECT_EQ(count, std::ssize(net.sliding_nodes()));
    // The form follows from lengths and slips.
    EXPECT_LT((found.predicted.form - s.truth.form).cwiseAbs().maxCoeff(), 1e-3);
}

/// A net surveyed, turned at some turnbuckles, where its runs slide on from where they stood, and
/// surveyed again.
struct TurnedRuns {
    std::vector<Epoch> epochs;
    Equilibrium truth;  ///< at the last survey
};

/// @param built the net with its true friction
/// @param done by how much of what is given an edge was turned (m)
TurnedRuns turned_runs(const CableNet& built, std::uint64_t seed, const Eigen::VectorXd& done) {
    constexpr double noise = 0.5e-3;
    const test::SimulatedSurvey first =
        test::simulate(built, {LengthPrior::Kind::normal, 2e-3}, noise, seed);
    TurnedRuns result{.epochs = {{.survey = first.survey, .turned = {}}}, .truth = first.truth};
    std::mt19937_64 random(seed);
    std::vector<EdgeTurned> turned;
    Eigen::VectorXd lengths = first.truth.unstressed_lengths;
    for (const int edge : built.adjustable_edges()) {
        const double stroke = std::uniform_real_distribution<double>(-8e-3, 8e-3)(random);
        turned.push_back({.edge = edge, .stroke = stroke, .std_dev = 0.0});
        lengths(edge) += done(edge) * stroke;
    }
    result.truth = EquilibriumSolver(built).solve(lengths, first.truth.form);
    EXPECT_TRUE(result.truth.balanced());
    test::SimulatedSurvey second = first;
    second.truth = result.truth;
    result.epochs.push_back({.survey = test::surveyed_again(built, second, noise, seed + 1000),
                             .turned = std::move(turned)});
    return result;
}

TEST(SlidingRuns, SurveysBeforeAndAfterTurnsAreOfOneCable) {
    CableNetData data = sliding_ridge().data();
    data.runs.at(0).friction.reset();
    const CableNet net(std::move(data));
    const IdentifyOptions options{.prior = LengthPrior{LengthPrior::Kind::normal, 2e-3},
                                  .prior_exact = true};
    constexpr int chains = 20;
    double edges = 0.0;
    double tensions_off = 0.0;
    double stretches = 0.0;
    double alone = 0.0;
    double both = 0.0;
    int passed = 0;
    for (int seed = 0; seed < chains; ++seed) {
        const CableNet built = ridge(0.1 * (seed + 0.5) / chains);
        const TurnedRuns of = turned_runs(built, seed, Eigen::VectorXd::Ones(net.edge_count()));
        const Identification found = test::identify_lengths(net, of.epochs, options);
        ASSERT_EQ(found.status, IdentificationStatus::converged);
        passed += found.trust.verdict() == Trust::Verdict::passed ? 1 : 0;
        const Eigen::VectorXd off = of.truth.unstressed_lengths - net.unstressed_lengths();
        for (const IdentifiedEdge& edge : found.edges) {
            edges += std::pow((edge.length_deviation - off(edge.edge)) / edge.std_dev, 2) /
                     static_cast<double>(found.edges.size() * chains);
        }
        const StretchLength& stretch = found.stretches.at(0);
        const double sum = of.truth.unstressed_lengths(stretch.edges).sum();
        stretches +=
            std::pow((stretch.nominal + stretch.length_deviation - sum) / stretch.std_dev, 2) /
            chains;
        const Eigen::VectorXd tension =
            tensions_of(built, of.truth.unstressed_lengths, of.truth.form);
        tensions_off +=
            std::pow((stretch.tension - tension(stretch.edges).mean()) / stretch.tension_std, 2) /
            chains;
        alone += test::identify_lengths(net, of.epochs[0].survey, options).stretches.at(0).std_dev /
                 chains;
        both += stretch.std_dev / chains;
    }
    EXPECT_NEAR(std::sqrt(edges), 1.0, 0.1);
    EXPECT_NEAR(std::sqrt(stretches), 1.0, 0.4);
    EXPECT_NEAR(std::sqrt(tensions_off), 1.0, 0.4);
    EXPECT_LT(both, 0.85 * alone);
    EXPECT_GE(passed, chains - 2);
}

TEST(SlidingRuns, ArePredictedBeforeASurvey) {
    const CableNet net = ridge(0.1);
    const LengthPrior prior{LengthPrior::Kind::normal, 2e-3};
    const test::SimulatedSurvey s = test::simulate(net, prior, 0.5e-3, 2);
    const Identification found =
        test::identify_lengths(net, s.survey, {.prior = prior, .prior_exact = true});
    const PredictedPrecision predicted =
        predicted_precision(net, net.nodes(), s.survey, prior, {.assume_site = false});
    ASSERT_EQ(predicted.edges.size(), found.edges.size());
    for (size_t i = 0; i < found.edges.size(); ++i) {
        EXPECT_NEAR(predicted.edges[i].std_dev / found.edges[i].std_dev, 1.0, 0.25);
    }
    for (const TensionPrecision& one : predicted.force_candidates) {
        EXPECT_GT(one.edge, net.data().runs.at(0).edges.back());
    }
}

TEST(SlidingRuns, ATurnThatWasNotMadeIsNamedWithItsCable) {
    const CableNet net = ridge(0.1);
    Eigen::VectorXd done = Eigen::VectorXd::Ones(net.edge_count());
    const int end = net.data().runs.at(0).edges.back();
    done(end) = -4.0;
    const Identification found =
        test::identify_lengths(net, turned_runs(net, 1, done).epochs,
                               {.prior = LengthPrior{LengthPrior::Kind::normal, 2e-3}});
    ASSERT_EQ(found.trust.verdict(), Trust::Verdict::doubtful);
    EXPECT_THAT(found.trust.findings.at(0).reason,
                testing::HasSubstr("or another of the cable that slides from 0 to 7 is given as "
                                   "turned by"));
}

/// Of a cable that slides alone, a turn that was not made is a strain of its group as well.
TEST(SlidingRuns, ATurnThatWasNotMadeIsNoCreep) {
    const CableNet net = ridge(0.0);
    Eigen::VectorXd done = Eigen::VectorXd::Ones(net.edge_count());
    done(net.data().runs.at(0).edges.front()) = -3.0;
    for (const std::uint64_t seed : {1, 2, 5}) {
        const Identification found =
            test::identify_lengths(net, turned_runs(net, seed, done).epochs,
                                   {.prior = LengthPrior{LengthPrior::Kind::normal, 2e-3}});
        for (const Trust::Finding& finding : found.trust.findings) {
            EXPECT_NE(finding.kind, Trust::Finding::Kind::uncertain_parameter) << finding.reason;
        }
        EXPECT_NE(found.trust.verdict(), Trust::Verdict::passed);
    }
}

TEST(SlidingRuns, WhatTakesEdgesAsClampedIsRefused) {
    const CableNet net = ridge(0.1);
    const test::SimulatedSurvey s =
        test::simulate(net, {LengthPrior::Kind::normal, 2e-3}, 0.5e-3, 1);
    const auto refused = [&](const IdentifyOptions& options, const char* text) {
        EXPECT_THAT([&] { (void)test::identify_lengths(net, s.survey, options); },
                    testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(text)));
    };
    refused({.method = IdentificationMethod::gp}, "expected the method map");
    refused({.forces = {.measurements = {{.edge = 1, .tension = 30e3, .std_dev = 300.0}}}},
            "measure an edge that is clamped at both ends");
    const std::vector<Epoch> epochs(2, {.survey = s.survey, .turned = {}});
    EXPECT_THAT(
        [&] {
            (void)test::identify_lengths(
                net, epochs,
                {.forces = {.measurements = {{.edge = 1, .tension = 30e3, .std_dev = 300.0}}}});
        },
        testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("clamped at both ends")));
}

}  // namespace
}  // namespace taut
