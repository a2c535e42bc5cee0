// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against posteriors that are not prior times likelihood, and intervals that leave the
// prior.

#include "estimation/length_posterior.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace {

using namespace taut;

constexpr double infinity = std::numeric_limits<double>::infinity();
const LengthPrior uniform{LengthPrior::Kind::uniform, 0.005};
const LengthPrior normal{LengthPrior::Kind::normal, 0.002};
const LengthPrior bimodal{LengthPrior::Kind::bimodal, 0.004};

double density(const LengthPrior& prior, double x) {
    const auto bell = [](double z) { return std::exp(-0.5 * z * z); };
    switch (prior.kind) {
        case LengthPrior::Kind::uniform:
            return std::abs(x) <= prior.scale ? 1.0 : 0.0;
        case LengthPrior::Kind::normal:
            return bell(x / prior.scale);
        default:
            return bell((x - prior.scale) / (0.2 * prior.scale)) +
                   bell((x + prior.scale) / (0.2 * prior.scale));
    }
}

/// Mean, std, the probability below lower and above upper, and of being slack, by the sum over a
/// fine grid.
void expect_as_on_a_grid(const LengthPrior& prior, const LengthLikelihood& l) {
    const LengthPosterior found = posterior_of(prior, l);
    double mass = 0.0, first = 0.0, second = 0.0, below = 0.0, above = 0.0, slack = 0.0;
    constexpr double step = 1e-7;
    for (double x = -0.02; x <= 0.02; x += step) {
        const double z = (x - l.mean) / l.std_dev;
        double taut = std::isfinite(l.std_dev) ? std::exp(-0.5 * z * z) / l.std_dev : 1.0;
        taut *= 0.5 * std::erfc(-l.extension / std::numbers::sqrt2);
        const double loose = x > l.slack_from && std::isfinite(l.extension)
                                 ? std::exp(-0.5 * l.extension * l.extension) / l.std_dev
                                 : 0.0;
        const double p = density(prior, x) * (taut + loose);
        mass += p;
        first += p * x;
        second += p * x * x;
        slack += density(prior, x) * loose;
        below += x < found.lower ? p : 0.0;
        above += x > found.upper ? p : 0.0;
    }
    const double mean = first / mass;
    EXPECT_NEAR(found.mean, mean, 1e-6);
    EXPECT_NEAR(found.std_dev, std::sqrt(second / mass - mean * mean), 1e-6);
    EXPECT_NEAR(found.slack_probability, slack / mass, 1e-3);
    if (found.slack_probability < 0.5) {
        EXPECT_NEAR(below / mass, 0.025, 1e-3);
        EXPECT_NEAR(above / mass, 0.025, 1e-3);
    }
}

TEST(PosteriorOf, IsPriorTimesLikelihood) {
    for (const LengthPrior& prior : {uniform, normal, bimodal}) {
        for (const double std_dev : {0.0003, 0.002, 0.02}) {
            for (const double mean : {-0.0045, 0.0, 0.003}) {
                expect_as_on_a_grid(prior, {.mean = mean, .std_dev = std_dev});
                expect_as_on_a_grid(prior, {.mean = mean,
                                            .std_dev = std_dev,
                                            .slack_from = mean + 0.5 * std_dev,
                                            .extension = 0.5});
            }
        }
    }
}

TEST(PosteriorOf, IsThePriorWithoutASurvey) {
    const LengthPosterior p = posterior_of(uniform, {});
    EXPECT_NEAR(p.mean, 0.0, 1e-12);
    EXPECT_NEAR(p.std_dev, uniform.std_dev(), 1e-9);
    EXPECT_NEAR(p.upper, 0.95 * uniform.scale, 1e-9);
    EXPECT_EQ(status_of(uniform.std_dev(), p), EdgeStatus::not_determined);
}

TEST(PosteriorOf, NeverLeavesTheBoundsOfAUniformPrior) {
    for (const double mean : {-1.0, -0.006, -0.005, 0.0049, 0.0051, 0.3}) {
        for (const double std_dev : {1e-9, 1e-5, 1e-3, 1.0}) {
            const LengthPosterior p = posterior_of(uniform, {.mean = mean, .std_dev = std_dev});
            EXPECT_GE(p.lower, -uniform.scale) << mean << ", " << std_dev;
            EXPECT_LE(p.upper, uniform.scale) << mean << ", " << std_dev;
            EXPECT_LE(p.lower, p.mean);
            EXPECT_LE(p.mean, p.upper);
            EXPECT_TRUE(p.std_dev >= 0.0);
        }
    }
}

TEST(PosteriorOf, KeepsTheDigitsOfANarrowLikelihood) {
    const LengthPosterior p = posterior_of(uniform, {.mean = 0.001234567, .std_dev = 1e-9});
    EXPECT_NEAR(p.mean, 0.001234567, 1e-15);
    EXPECT_NEAR(p.std_dev, 1e-9, 1e-14);
    EXPECT_NEAR(p.upper, 0.001234567 + half_interval_95 * 1e-9, 1e-14);
}

TEST(PosteriorOf, ASlackEdgeIsOnlyKnownToBeAsLongAsItMeasures) {
    const LengthPosterior p = posterior_of(
        uniform, {.mean = 0.002, .std_dev = 1e-6, .slack_from = 0.002, .extension = 0.0});
    EXPECT_EQ(status_of(uniform.std_dev(), p), EdgeStatus::slack);
    EXPECT_DOUBLE_EQ(p.lower, 0.002);
    EXPECT_DOUBLE_EQ(p.upper, 0.005);
    EXPECT_NEAR(p.mean, 0.0035, 1e-5);
    LengthLikelihood surely{.slack_from = 0.001, .extension = -infinity};
    const LengthPosterior tail = posterior_of(normal, surely);
    EXPECT_EQ(status_of(normal.std_dev(), tail), EdgeStatus::slack);
    EXPECT_DOUBLE_EQ(tail.lower, 0.001);
    EXPECT_GT(tail.upper, 0.004);
}

TEST(StatusOf, IsByHowMuchTheSurveyNarrows) {
    EXPECT_EQ(status_of(2.0, 0.0), EdgeStatus::determined);
    EXPECT_EQ(status_of(2.0, 0.99), EdgeStatus::determined);
    EXPECT_EQ(status_of(2.0, 1.01), EdgeStatus::weakly_determined);
    EXPECT_EQ(status_of(2.0, 1.79), EdgeStatus::weakly_determined);
    EXPECT_EQ(status_of(2.0, 1.81), EdgeStatus::not_determined);
    EXPECT_EQ(status_of(2.0, 2.2), EdgeStatus::not_determined);
}

TEST(PosteriorOf, RefusesWhatIsNoDistribution) {
    EXPECT_THROW((void)posterior_of(uniform, {.mean = NAN, .std_dev = 1.0}), std::invalid_argument);
    EXPECT_THROW((void)posterior_of(uniform, {.mean = 0.0, .std_dev = 0.0}), std::invalid_argument);
    EXPECT_THROW((void)posterior_of(uniform, {.mean = 0.0, .std_dev = -1.0}),
                 std::invalid_argument);
}

TEST(WithoutPrior, TimesThePriorIsThePosterior) {
    const LengthLikelihood l = without_prior(0.001, 0.003, 0.002, 0.001);
    const double precision = 1.0 / (l.std_dev * l.std_dev) + 1.0 / (0.003 * 0.003);
    EXPECT_NEAR(1.0 / std::sqrt(precision), 0.001, 1e-12);
    EXPECT_NEAR((l.mean / (l.std_dev * l.std_dev) + 0.001 / (0.003 * 0.003)) / precision, 0.002,
                1e-12);
    EXPECT_EQ(without_prior(0.0, 0.003, 0.0, 0.003).std_dev, infinity);
}

TEST(LengthPosterior, OfAnEdgeUnderAnyPressureIsThatOfASlackOne) {
    const LengthLikelihood slack{.mean = 0.001,
                                 .std_dev = 1e-6,
                                 .slack_from = -0.002,
                                 .extension = -std::numeric_limits<double>::infinity()};
    for (const double z : {-1e7, -1e160, -1e300}) {
        LengthLikelihood pressed = slack;
        pressed.extension = z;
        for (const LengthPrior& prior : {uniform, normal, bimodal}) {
            EXPECT_EQ(posterior_of(prior, pressed).mean, posterior_of(prior, slack).mean);
            pressed.slack_from = 0.9;  // outside any prior
            EXPECT_TRUE(std::isfinite(posterior_of(prior, pressed).mean));
            pressed.slack_from = slack.slack_from;
        }
    }
}

}  // namespace
