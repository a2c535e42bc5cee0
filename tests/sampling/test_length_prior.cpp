// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against draws from another prior than the one named: a scale taken for a standard
// deviation, a bound that draws exceed, a prior that a file does not give back.

#include "taut/sampling/length_prior.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "support/refusals.hpp"
#include "taut/sampling/data_set.hpp"

namespace {

using taut::LengthPrior;
using taut::parse_length_prior;
using taut::test::refusal_of;

constexpr int draws = 200'000;

double normal_cdf(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// P(deviation <= x) as the definitions of the priors say.
double cdf(const LengthPrior& prior, double x) {
    const double z = x / prior.scale;
    switch (prior.kind) {
        case LengthPrior::Kind::uniform:
            return std::clamp(0.5 * (z + 1.0), 0.0, 1.0);
        case LengthPrior::Kind::normal:
            return normal_cdf(z);
        case LengthPrior::Kind::bimodal:
            return 0.5 * (normal_cdf((z + 1.0) / 0.2) + normal_cdf((z - 1.0) / 0.2));
    }
    return 0.0;
}

/// sup |empirical - expected distribution| sqrt(n): above 1.95 in one of a thousand cases.
double kolmogorov_statistic(const LengthPrior& prior, Eigen::VectorXd deviations) {
    std::ranges::sort(deviations);
    const auto n = static_cast<double>(deviations.size());
    double largest = 0.0;
    for (Eigen::Index i = 0; i < deviations.size(); ++i) {
        const double expected = cdf(prior, deviations(i));
        largest = std::max({largest, expected - static_cast<double>(i) / n,
                            static_cast<double>(i + 1) / n - expected});
    }
    return largest * std::sqrt(n);
}

class EachPrior : public testing::TestWithParam<LengthPrior> {
protected:
    const LengthPrior m_prior = GetParam();
    const Eigen::VectorXd m_deviations = taut::draw_length_deviations(m_prior, 1, 0, draws);
};

TEST_P(EachPrior, HasTheDistributionItIsNamedAfter) {
    EXPECT_LT(kolmogorov_statistic(m_prior, m_deviations), 1.95);
}

TEST_P(EachPrior, HasTheStandardDeviationItReports) {
    EXPECT_NEAR(std::sqrt(m_deviations.squaredNorm() / draws), m_prior.std_dev(),
                0.01 * m_prior.std_dev());
}

TEST_P(EachPrior, ReachesAsFarAsItsDrawsAndNoFurther) {
    EXPECT_LE(m_deviations.cwiseAbs().maxCoeff(), m_prior.reach());
    for (const double u : {0x1p-54, 0x1p-53, 0.5, std::nextafter(0.5, 0.0),
                           std::nextafter(0.5, 1.0), 1.0 - 0x1p-53, 1.0 - 0x1p-52}) {
        EXPECT_LE(std::abs(m_prior.draw(u)), m_prior.reach()) << "u = " << u;
    }
    EXPECT_GT(std::abs(m_prior.draw(0x1p-53)), 0.98 * m_prior.reach());
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, EachPrior,
    testing::Values(LengthPrior{LengthPrior::Kind::uniform, 0.005},
                    LengthPrior{LengthPrior::Kind::normal, 0.002},
                    LengthPrior{LengthPrior::Kind::bimodal, 0.005}),
    [](const auto& kind) {
        return to_string(kind.param).substr(0, to_string(kind.param).find(':'));
    });

TEST(KolmogorovStatistic, DistinguishesPriorsOfTheSameStandardDeviation) {
    const LengthPrior uniform{LengthPrior::Kind::uniform, 0.005};
    const LengthPrior normal{LengthPrior::Kind::normal, uniform.std_dev()};
    EXPECT_GT(kolmogorov_statistic(normal, taut::draw_length_deviations(uniform, 1, 0, draws)),
              10.0);
}

TEST(LengthPrior, IsReadFromItsNameAndItsScale) {
    EXPECT_EQ(LengthPrior{}, parse_length_prior("uniform:5mm"));  // the paper's
    EXPECT_EQ(parse_length_prior("uniform:5mm"), (LengthPrior{LengthPrior::Kind::uniform, 0.005}));
    EXPECT_EQ(parse_length_prior("normal:0.2cm"), (LengthPrior{LengthPrior::Kind::normal, 0.002}));
    EXPECT_EQ(parse_length_prior("bimodal:0.005"),
              (LengthPrior{LengthPrior::Kind::bimodal, 0.005}));
}

TEST(LengthPrior, IsWrittenInMillimetres) {
    EXPECT_EQ(to_string(LengthPrior{LengthPrior::Kind::uniform, 0.005}), "uniform:5mm");
    EXPECT_EQ(to_string(LengthPrior{LengthPrior::Kind::normal, 0.0023}), "normal:2.3mm");
    EXPECT_EQ(to_string(LengthPrior{LengthPrior::Kind::bimodal, 1.0}), "bimodal:1000mm");
}

RC_GTEST_PROP(LengthPrior, IsReadBackAsWritten, ()) {
    const LengthPrior prior{
        .kind = *rc::gen::element(LengthPrior::Kind::uniform, LengthPrior::Kind::normal,
                                  LengthPrior::Kind::bimodal),
        .scale = static_cast<double>(*rc::gen::inRange<std::int64_t>(1, 1'000'000'000'000)) / 3e12};
    RC_ASSERT(parse_length_prior(to_string(prior)) == prior);
}

TEST(LengthPrior, IsRefusedByNameWhereItsScaleIsNotPositiveAndFinite) {
    for (const auto& [scale, text] : {std::pair{0.0, "is 0 m"},
                                      {-0.005, "is -0.005 m"},
                                      {std::nan(""), "is nan m"},
                                      {HUGE_VAL, "is inf m"},
                                      {-HUGE_VAL, "is -inf m"}}) {
        const LengthPrior prior{LengthPrior::Kind::normal, scale};
        const std::string message = refusal_of([&] { prior.check(); });
        EXPECT_THAT(message,
                    testing::AllOf(testing::HasSubstr("normal prior"), testing::HasSubstr(text),
                                   testing::HasSubstr("positive and finite")));
        EXPECT_EQ(refusal_of([&] { return taut::draw_length_deviations(prior, 1, 0, 3); }),
                  message);
    }
    EXPECT_NO_THROW((LengthPrior{LengthPrior::Kind::normal, 1e-9}.check()));
}

TEST(LengthPrior, IsRefusedWithItsText) {
    for (const std::string text :
         {"", "uniform", "5mm", ":5mm", "uniform:", "gauss:5mm", "Uniform:5mm", " uniform:5mm",
          "uniform :5mm", "uniform:5km", "uniform:5mm:2mm", "uniform:0", "uniform:0mm",
          "normal:-2mm", "bimodal:-5mm", "uniform:nan", "uniform:inf", "uniform:1e400mm",
          "uniform,5mm"}) {
        const std::string message = refusal_of([&] { return parse_length_prior(text); });
        const std::string scale = text.substr(text.find(':') + 1);  // or all of it
        EXPECT_THAT(message, testing::AnyOf(testing::HasSubstr("'" + text + "'"),
                                            testing::HasSubstr("'" + scale + "'")));
        EXPECT_THAT(message, testing::HasSubstr("expected")) << text;
    }
}

}  // namespace
