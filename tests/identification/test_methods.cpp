// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lengths, intervals and outliers of the force balance and of maximum a posteriori
// that do not hold over many simulated surveys. Seeds are fixed; tolerances are some three standard
// deviations of the figures.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "identification/cramer_rao_bound.hpp"
#include "identification/force_balance.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/simulated_survey.hpp"
#include "support/dense_posterior.hpp"
#include "support/refusals.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/tensions.hpp"

namespace {

using namespace taut;
using namespace taut::test;

constexpr LengthPrior uniform_3mm{LengthPrior::Kind::uniform, 0.003};
constexpr LengthPrior normal_prior{LengthPrior::Kind::normal, 0.0015};

Identification map(const CableNet& net, const Survey& survey, const LengthPrior& prior) {
    return identify_by_maximum_a_posteriori(net, survey, prior);
}

const CableNet net_7x7 = hypar(7, 7);

TEST(Methods, IntervalsHoldNinetyFivePercentAndErrorsAreNearTheBestPossible) {
    using Method =
        std::function<Identification(const CableNet&, const Survey&, const LengthPrior&)>;
    constexpr int surveys = 20;
    for (const LengthPrior& prior : {uniform_3mm, normal_prior}) {
        for (const double noise : {0.0001, 0.0005, 0.002}) {
            for (const Method& by : {Method(map), Method(identify_by_force_balance)}) {
                double errors = 0.0;
                double best = 0.0;
                double covered = 0.0;
                std::string method;
                for (std::uint64_t seed = 0; seed < surveys; ++seed) {
                    const SimulatedSurvey s = simulate(net_7x7, prior, noise, seed);
                    const Identification result = by(net_7x7, s.survey, prior);
                    EXPECT_EQ(result.status, IdentificationStatus::converged);
                    method = result.method;
                    errors += squared_error(result, s.deviations);
                    covered += test::coverage(result, s.deviations) / surveys;
                    best +=
                        cramer_rao_variances(net_7x7, with_length_deviations(net_7x7, s.deviations),
                                             s.truth.form, s.survey, prior)
                            .mean();
                }
                EXPECT_NEAR(covered, 0.95, 0.02)
                    << method << ' ' << to_string(prior) << ' ' << noise;
                EXPECT_LT(errors, (method == "map" ? 1.05 : 1.3) * best)
                    << method << ' ' << to_string(prior) << ' ' << noise;
            }
        }
    }
}

TEST(CramerRaoBound, IsTheTextbookPosteriorVariance) {
    SimulatedSurvey s = simulate(net_7x7, uniform_3mm, 0.0004, 3);
    hide(net_7x7, s.survey, net_7x7.free_nodes()[10]);
    const Eigen::VectorXd lengths = with_length_deviations(net_7x7, s.deviations);
    const Eigen::VectorXd expected =
        dense_posterior(net_7x7, lengths, s.truth.form, s.survey, uniform_3mm).diagonal();
    const Eigen::VectorXd found =
        cramer_rao_variances(net_7x7, lengths, s.truth.form, s.survey, uniform_3mm);
    EXPECT_LT((found - expected).cwiseQuotient(expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(MaximumAPosteriori, FindsGrossErrorsAndLeavesThemOut) {
    double clean = 0.0;
    double spoilt = 0.0;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        SimulatedSurvey s = simulate(net_7x7, uniform_3mm, 0.0005, seed);
        clean += squared_error(map(net_7x7, s.survey, uniform_3mm), s.deviations);
        const int moved = net_7x7.free_nodes()[seed];
        const int a = net_7x7.free_nodes()[30];
        const int b = net_7x7.free_nodes()[31];
        s.survey.form.col(moved) += Eigen::Vector3d(0.03, -0.03, 0.026);
        const Eigen::Vector3d place = s.survey.form.col(a);
        s.survey.form.col(a) = s.survey.form.col(b);
        s.survey.form.col(b) = place;
        const Identification result = map(net_7x7, s.survey, uniform_3mm);
        std::vector<int> found;
        for (const Outlier& outlier : result.outliers) {
            found.push_back(outlier.node);
            EXPECT_GT(outlier.statistic, result.outlier_threshold);
        }
        EXPECT_THAT(found, ::testing::UnorderedElementsAre(moved, a, b));
        spoilt += squared_error(result, s.deviations);
    }
    EXPECT_LT(std::sqrt(spoilt), 1.5 * std::sqrt(clean));
}

TEST(MaximumAPosteriori, SaysWhereTheWholeSurveyDoesNotFit) {
    SimulatedSurvey s = simulate(net_7x7, uniform_3mm, 0.0005, 1);
    s.survey.noise_std *= 0.01;
    const Identification result = map(net_7x7, s.survey, uniform_3mm);
    EXPECT_EQ(result.status, IdentificationStatus::survey_does_not_fit);
    EXPECT_GT(result.outliers.size(), s.survey.surveyed.size() / 4);
}

TEST(MaximumAPosteriori, LooksForNoGrossErrorsWithoutFalseAlarms) {
    SimulatedSurvey s = simulate(net_7x7, uniform_3mm, 0.0005, 1);
    s.survey.form.col(net_7x7.free_nodes()[20]).z() += 0.01;
    EXPECT_TRUE(
        identify_by_maximum_a_posteriori(net_7x7, s.survey, uniform_3mm, {.false_alarm_rate = 0.0})
            .outliers.empty());
    EXPECT_EQ(map(net_7x7, s.survey, uniform_3mm).outliers.size(), 1U);
}

TEST(Methods, RefuseSurveysThatMakeNoSense) {
    const Survey good = simulate(net_7x7, uniform_3mm, 0.0005, 1).survey;
    Survey bad = good;  // check_survey() has a test of its own
    bad.form = Points::Zero(3, 2);
    for (const auto& method : {std::function(map), std::function(identify_by_force_balance)}) {
        expect_refused([&] { return method(net_7x7, bad, uniform_3mm); }, "form has 2 columns");
    }
    bad = good;
    hide(net_7x7, bad, good.surveyed[5]);
    EXPECT_THROW((void)identify_by_force_balance(net_7x7, bad, uniform_3mm), std::invalid_argument);
    EXPECT_THROW(
        (void)identify_by_maximum_a_posteriori(net_7x7, good, uniform_3mm, {.max_iterations = 0}),
        std::invalid_argument);
    EXPECT_THROW((void)identify_by_maximum_a_posteriori(net_7x7, good, uniform_3mm,
                                                        {.false_alarm_rate = 1.0}),
                 std::invalid_argument);
}

TEST(Methods, GiveFiniteNumbersWhereNodesAreLoose) {
    // Lengths that leave whole nodes without tension.
    const CableNet net = hypar(4, 5);
    const LengthPrior wide{LengthPrior::Kind::uniform, 0.02};
    const DataSet data = draw_samples(Sampler(net, wide, 3), 20);
    for (const int k : data.converged_in(0, 20)) {
        for (const double noise : {0.0, 0.0005}) {
            const Survey survey{
                .form = with_free_coordinates(net, data.nominal_form + data.form_deviations.col(k)),
                .noise_std = Points::Constant(3, net.node_count(), noise),
                .surveyed = net.free_nodes(),
                .missing = {}};
            for (const bool by_balance : {true, false}) {
                const Identification found = by_balance
                                                 ? identify_by_force_balance(net, survey, wide)
                                                 : map(net, survey, wide);
                for (const IdentifiedEdge& e : found.edges) {
                    ASSERT_TRUE(std::isfinite(e.std_dev) && e.lower <= e.length_deviation &&
                                e.length_deviation <= e.upper)
                        << "sample " << k << ", edge " << e.edge;
                }
            }
        }
    }
}

}  // namespace
