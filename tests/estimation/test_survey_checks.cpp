// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "../identification/simulated_survey.hpp"
#include "estimation/frame_check.hpp"
#include "estimation/load_check.hpp"
#include "estimation/survey_fit.hpp"
#include "estimation/variance_components.hpp"
#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;
using namespace taut::test;

constexpr LengthPrior of_lengths{LengthPrior::Kind::normal, 0.002};
constexpr double of_survey = 0.5e-3;

TEST(FrameCheck, FindsTheScaleAndTheMotionOfASurvey) {
    const CableNet net = hypar(6, 6);
    SimulatedSurvey s = simulate(net, of_lengths, of_survey, 3);
    const Eigen::Vector3d middle = net.nodes().rowwise().mean();
    const Points arms = s.survey.form.colwise() - middle;
    s.survey.form += 0.004 * arms;
    s.survey.form.row(1).array() += 0.005;
    const SurveyFit fit = fit_survey(net, s.survey, PriorKnowledge(net, of_lengths), {});
    const FrameCheck check = check_frame(fit.at, fit.observations, 1.0);
    EXPECT_NEAR(check.scale, 0.004, 4.0 * check.scale_std);
    EXPECT_LT(check.scale_std, 0.001);
    EXPECT_NEAR(check.translation.y(), 0.005, 2e-3);
    EXPECT_TRUE(check.is_moved());
}

/// The scales of a survey whose noise along each axis is this many times as given.
VarianceComponents components_of(const Eigen::Array3d& noise, double lengths, std::uint64_t seed) {
    const CableNet net = hypar(8, 8);
    const LengthPrior true_lengths{LengthPrior::Kind::normal, lengths * of_lengths.scale};
    SimulatedSurvey s = simulate(net, true_lengths, of_survey, seed);
    const Points errors = s.survey.form - s.truth.form;
    s.survey.form += (errors.array().colwise() * (noise - 1.0)).matrix();
    SurveyFit fit =
        fit_survey(net, s.survey, PriorKnowledge(net, of_lengths), {.false_alarm_rate = 0.0});
    Observations observations = fit.observations;
    return estimate_components(fit.at, observations,
                               std::vector<bool>(net.interior_edge_count(), false));
}

TEST(VarianceComponents, OfEachAxisAreFoundThoughTheLengthsAreTakenTooWide) {
    // A common scale of the noise hides it in that of the lengths.
    for (const std::uint64_t seed : {1, 2, 3}) {
        SCOPED_TRACE(seed);
        const VarianceComponents found = components_of({3.0, 3.0, 1.0}, 0.5, seed);
        ASSERT_EQ(found.noise_by_axis.size(), 3U);
        for (const int plan : {0, 1}) {
            EXPECT_NEAR(found.noise_by_axis[plan].ratio, 3.0, 1.0);
            EXPECT_TRUE(found.noise_by_axis[plan].is_contradicted());
        }
        EXPECT_NEAR(found.noise_by_axis[2].ratio, 1.0, 0.3);
    }
}

TEST(VarianceComponents, OfEvenNoiseAreThoseOfEachAxis) {
    for (const double scale : {0.5, 1.0, 2.0}) {
        for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
            SCOPED_TRACE(testing::Message() << scale << ", " << seed);
            const VarianceComponents found =
                components_of(Eigen::Array3d::Constant(scale), 1.0, seed);
            EXPECT_NEAR(found.noise.ratio, scale, 0.25 * scale);
            EXPECT_EQ(found.noise.is_contradicted(), scale != 1.0);
            for (const FoundScale& axis : found.noise_by_axis) {
                EXPECT_FALSE(scale <= 1.0 && axis.ratio > 1.0 && axis.is_contradicted());
            }
        }
    }
}

TEST(VarianceComponents, AccuseNoAxisWhereAnotherIsBetterThanGiven) {
    const VarianceComponents found = components_of({1.0, 1.0, 0.3}, 1.0, 1);
    for (const FoundScale& axis : found.noise_by_axis) {
        EXPECT_FALSE(axis.ratio > 1.0 && axis.is_contradicted());
    }
}

TEST(Linearisation, TheDeterminantIsOfNoUnitOfItsOwn) {
    const CableNet net = hypar(4, 4);
    const SimulatedSurvey s = simulate(net, of_lengths, of_survey, 3);
    PriorKnowledge knowledge(net, of_lengths);
    knowledge.uncertain = {parse_uncertain_parameter("supports:1mm")};
    const SurveyFit fit = fit_survey(net, s.survey, knowledge, {});
    Observations wider = fit.observations;
    wider.weights /= 9.0;
    wider.support_weights /= 9.0;
    wider.variance *= 9.0;
    const auto of = [&](const Observations& observations) {
        return linearised_fit(fit.at.model(), fit.at.iterate, observations)
            .linearisation.half_log_determinant(observations);
    };
    // All standard deviations are three times as large.
    const auto count = net.interior_edge_count() + 3 * std::ssize(net.supports());
    EXPECT_NEAR(of(fit.observations) - of(wider), static_cast<double>(count) * std::log(3.0), 1e-6);
}

/// The same net with a load at each free node, downwards.
CableNet with_load(const CableNet& net, double force) {
    CableNetData data = net.data();
    data.loads = Points::Zero(3, net.node_count());
    for (const int node : net.free_nodes()) {
        data.loads(2, node) = -force;
    }
    return CableNet(data);
}

SurveyFit untested_fit(const CableNet& net, const Survey& survey) {
    return fit_survey(net, survey, PriorKnowledge(net, of_lengths), {.false_alarm_rate = 0.0});
}

TEST(LoadCheck, FindsALoadThatIsMissing) {
    const CableNet net = hypar(6, 6);
    const auto check_of = [&](double force) {
        const SimulatedSurvey s = simulate(with_load(net, force), of_lengths, of_survey, 3);
        return check_loads(untested_fit(net, s.survey).at, 1.0);
    };
    EXPECT_FALSE(check_of(0.0).is_missing());
    for (const double force : {20.0, -20.0}) {
        const LoadCheck check = check_of(force);
        EXPECT_TRUE(check.is_missing());
        EXPECT_NEAR(check.force, force, 4.0 * check.std_dev);
    }
}

// Differences of the least objective by the load.
TEST(LoadScore, IsTheSlopeOfTheObjective) {
    const CableNet net = hypar(6, 6);
    const SimulatedSurvey s = simulate(net, of_lengths, of_survey, 3);
    const LoadCheck check = check_loads(untested_fit(net, s.survey).at, 1.0);
    const double information = 1.0 / (check.std_dev * check.std_dev);
    const auto least = [&](double force) {
        const CableNet loaded = with_load(net, force);
        const SurveyFit fit = untested_fit(loaded, s.survey);
        return fit.at.model().objective(fit.observations, fit.at.iterate);
    };
    const double h = 0.5 * check.std_dev;
    const double slope = (least(h) - least(-h)) / (2.0 * h);
    const double curvature = (least(h) - 2.0 * least(0.0) + least(-h)) / (h * h);
    EXPECT_NEAR(-slope / information, check.force, 0.02 * check.std_dev);
    EXPECT_NEAR(curvature, information, 0.05 * information);
}

// Differences of the fitted misfit by the number: what a survey larger by a part would gain.
TEST(SurveyScore, IsTheSlopeOfTheObjective) {
    const CableNet net = hypar(6, 6);
    const SurveyFit held = untested_fit(net, simulate(net, of_lengths, of_survey, 3).survey);
    const Points rate = net.nodes().colwise() - net.nodes().rowwise().mean();
    const Observations observed = held.observations;
    const Linearisation::Score score =
        held.at.linearisation.score_of_survey({rate}, held.at.iterate, observed);
    const auto objective = [&](double scale) {
        Observations scaled = observed;
        scaled.form -= scale * rate;
        const StaticsModel& model = held.at.model();
        Iterate at = held.at.iterate;
        for (int round = 0; round < 6; ++round) {
            at = at.moved(linearise(model, at, scaled).value().step(at, scaled));
        }
        return model.objective(scaled, at);
    };
    const double h = 1e-4;
    const double slope = (objective(h) - objective(-h)) / (2.0 * h);
    const double curvature = (objective(h) - 2.0 * objective(0.0) + objective(-h)) / (h * h);
    EXPECT_NEAR(-slope, score.gradient(0), 0.01 * std::sqrt(score.information(0, 0)));
    EXPECT_NEAR(curvature, score.information(0, 0), 0.01 * curvature);
}

}  // namespace
