// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lengths, intervals and outliers of the force balance and of maximum a posteriori
// that do not hold over many simulated surveys. Seeds are fixed; tolerances are some three standard
// deviations of the figures.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "identification/force_balance.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "identification/simulated_survey.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/cramer_rao_bound.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/form_sensitivity.hpp"
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
                    << method << ' ' << prior.to_string() << ' ' << noise;
                EXPECT_LT(errors, (method == "map" ? 1.05 : 1.3) * best)
                    << method << ' ' << prior.to_string() << ' ' << noise;
            }
        }
    }
}

TEST(CramerRaoBound, IsTheTextbookPosteriorVariance) {
    const SimulatedSurvey s = simulate(net_7x7, uniform_3mm, 0.0004, 3);
    Survey survey = s.survey;
    hide(net_7x7, survey, net_7x7.free_nodes()[10]);
    const Eigen::VectorXd lengths = with_length_deviations(net_7x7, s.deviations);
    const Eigen::MatrixXd J =
        FormSensitivity(net_7x7, lengths, s.truth.form).columns(net_7x7.interior_edges());
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(J.rows(), 1.0 / (0.0004 * 0.0004));
    weights.segment<3>(30).setZero();
    Eigen::MatrixXd precision = J.transpose() * weights.asDiagonal() * J;
    precision.diagonal().array() += 1.0 / (uniform_3mm.std() * uniform_3mm.std());
    const Eigen::VectorXd expected = precision.inverse().diagonal();
    const Eigen::VectorXd found =
        cramer_rao_variances(net_7x7, lengths, s.truth.form, survey, uniform_3mm);
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
    const int node = good.surveyed[5];
    const auto expect_refused = [&](const Survey& bad, const std::string& words) {
        for (const auto& method : {std::function(map), std::function(identify_by_force_balance)}) {
            try {
                (void)method(net_7x7, bad, uniform_3mm);
                ADD_FAILURE() << "not refused: " << words;
            } catch (const std::invalid_argument& error) {
                EXPECT_THAT(error.what(), ::testing::HasSubstr(words));
            }
        }
    };
    Survey bad = good;
    bad.form = Points::Zero(3, 2);
    expect_refused(bad, "form has 2 columns");
    bad = good;
    bad.noise_std = Points::Zero(3, 2);
    expect_refused(bad, "noise_std has 2 columns");
    bad = good;
    bad.noise_std(1, node) = -0.001;
    expect_refused(bad, "standard deviations of 0.0005, -0.001 and 0.0005");
    bad = good;
    bad.form(2, node) = NAN;
    expect_refused(bad, "not finite");
    bad = good;
    bad.surveyed[5] = bad.surveyed[4];
    expect_refused(bad, "ascending order");
    bad = good;
    bad.surveyed.clear();
    expect_refused(bad, "no free node");
    bad = good;
    hide(net_7x7, bad, node);
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
    const Sampler sampler(net, wide, 3);
    DataSet data = sampler.empty();
    sampler.extend(data, 20);
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
                    ASSERT_TRUE(std::isfinite(e.std) && e.lower <= e.length_deviation &&
                                e.length_deviation <= e.upper)
                        << "sample " << k << ", edge " << e.edge;
                }
            }
        }
    }
}

}  // namespace
