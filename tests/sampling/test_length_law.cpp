// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against draws that follow another law than the one named: a scale taken for a standard
// deviation, a bound that draws exceed, a law that a file does not give back.

#include "taut/sampling/length_law.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "taut/sampling/data_set.hpp"

namespace {

using taut::LengthLaw;
using taut::parse_length_law;

constexpr int draws = 200'000;

double normal_cdf(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// P(deviation <= x) as the definitions of the laws say.
double cdf(const LengthLaw& law, double x) {
    const double z = x / law.scale;
    switch (law.kind) {
        case LengthLaw::Kind::uniform:
            return std::clamp(0.5 * (z + 1.0), 0.0, 1.0);
        case LengthLaw::Kind::normal:
            return normal_cdf(z);
        case LengthLaw::Kind::bimodal:
            return 0.5 * (normal_cdf((z + 1.0) / 0.2) + normal_cdf((z - 1.0) / 0.2));
    }
    return 0.0;
}

/// sup |empirical - expected distribution| sqrt(n): above 1.95 in one of a thousand cases.
double kolmogorov_statistic(const LengthLaw& law, Eigen::VectorXd deviations) {
    std::ranges::sort(deviations);
    const auto n = static_cast<double>(deviations.size());
    double largest = 0.0;
    for (Eigen::Index i = 0; i < deviations.size(); ++i) {
        const double expected = cdf(law, deviations(i));
        largest = std::max({largest, expected - static_cast<double>(i) / n,
                            static_cast<double>(i + 1) / n - expected});
    }
    return largest * std::sqrt(n);
}

class EachLaw : public testing::TestWithParam<LengthLaw> {
protected:
    const LengthLaw m_law = GetParam();
    const Eigen::VectorXd m_deviations = taut::draw_length_deviations(m_law, 1, 0, draws);
};

TEST_P(EachLaw, HasTheDistributionItIsNamedAfter) {
    EXPECT_LT(kolmogorov_statistic(m_law, m_deviations), 1.95);
}

TEST_P(EachLaw, HasMeanZero) {
    EXPECT_LT(std::abs(m_deviations.mean()), 4.0 * m_law.std() / std::sqrt(draws));
}

TEST_P(EachLaw, HasTheStandardDeviationItTells) {
    EXPECT_NEAR(std::sqrt(m_deviations.squaredNorm() / draws), m_law.std(), 0.01 * m_law.std());
}

TEST_P(EachLaw, NeverDrawsBeyondItsReach) {
    EXPECT_LE(m_deviations.cwiseAbs().maxCoeff(), m_law.reach());
    for (const double u : {0x1p-54, 0x1p-53, 0.5, std::nextafter(0.5, 0.0),
                           std::nextafter(0.5, 1.0), 1.0 - 0x1p-53, 1.0 - 0x1p-52}) {
        EXPECT_LE(std::abs(m_law.draw(u)), m_law.reach()) << "u = " << u;
    }
}

TEST_P(EachLaw, ReachesNoFurtherThanItMust) {
    // What is refused for a reach that no draw comes near would be refused in vain.
    EXPECT_GT(std::abs(m_law.draw(0x1p-53)), 0.98 * m_law.reach());
}

TEST_P(EachLaw, IsSymmetric) {
    for (const double u : {1e-6, 0.01, 0.1, 0.2, 0.3, 0.4, 0.49}) {
        EXPECT_NEAR(m_law.draw(u), -m_law.draw(1.0 - u), 1e-9 * m_law.scale) << "u = " << u;
    }
}

TEST_P(EachLaw, ScalesWithItsScale) {
    const LengthLaw twice{.kind = m_law.kind, .scale = 2.0 * m_law.scale};
    EXPECT_EQ(twice.draw(0.3), 2.0 * m_law.draw(0.3));
    EXPECT_DOUBLE_EQ(twice.std(), 2.0 * m_law.std());
    EXPECT_DOUBLE_EQ(twice.reach(), 2.0 * m_law.reach());
}

INSTANTIATE_TEST_SUITE_P(Kinds, EachLaw,
                         testing::Values(LengthLaw{LengthLaw::Kind::uniform, 0.005},
                                         LengthLaw{LengthLaw::Kind::normal, 0.002},
                                         LengthLaw{LengthLaw::Kind::bimodal, 0.005}),
                         [](const auto& kind) {
                             return kind.param.to_string().substr(0,
                                                                  kind.param.to_string().find(':'));
                         });

TEST(KolmogorovStatistic, TellsOneLawFromAnotherOfTheSameStandardDeviation) {
    // The tests above would be worth nothing if this did not hold.
    const LengthLaw uniform{LengthLaw::Kind::uniform, 0.005};
    const LengthLaw normal{LengthLaw::Kind::normal, uniform.std()};
    EXPECT_GT(kolmogorov_statistic(normal, taut::draw_length_deviations(uniform, 1, 0, draws)),
              10.0);
}

TEST(LengthLaw, StandsForTheNumbersOfThePaperByDefault) {
    EXPECT_EQ(LengthLaw{}, parse_length_law("uniform:5mm"));
}

TEST(LengthLaw, IsReadFromItsNameAndItsScale) {
    EXPECT_EQ(parse_length_law("uniform:5mm"), (LengthLaw{LengthLaw::Kind::uniform, 0.005}));
    EXPECT_EQ(parse_length_law("normal:0.2cm"), (LengthLaw{LengthLaw::Kind::normal, 0.002}));
    EXPECT_EQ(parse_length_law("bimodal:0.005"), (LengthLaw{LengthLaw::Kind::bimodal, 0.005}));
}

TEST(LengthLaw, IsWrittenInMillimetres) {
    EXPECT_EQ((LengthLaw{LengthLaw::Kind::uniform, 0.005}).to_string(), "uniform:5mm");
    EXPECT_EQ((LengthLaw{LengthLaw::Kind::normal, 0.0023}).to_string(), "normal:2.3mm");
    EXPECT_EQ((LengthLaw{LengthLaw::Kind::bimodal, 1.0}).to_string(), "bimodal:1000mm");
}

RC_GTEST_PROP(LengthLaw, IsReadBackAsWritten, ()) {
    const LengthLaw law{
        .kind = *rc::gen::element(LengthLaw::Kind::uniform, LengthLaw::Kind::normal,
                                  LengthLaw::Kind::bimodal),
        .scale = static_cast<double>(*rc::gen::inRange<std::int64_t>(1, 1'000'000'000'000)) / 3e12};
    RC_ASSERT(parse_length_law(law.to_string()) == law);
}

std::string refusal(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

TEST(LengthLaw, IsRefusedByNameWhereItsScaleIsNotPositiveAndFinite) {
    for (const auto& [scale, text] : {std::pair{0.0, "is 0 m"},
                                      {-0.005, "is -0.005 m"},
                                      {std::nan(""), "is nan m"},
                                      {HUGE_VAL, "is inf m"},
                                      {-HUGE_VAL, "is -inf m"}}) {
        const LengthLaw law{LengthLaw::Kind::normal, scale};
        const std::string told = refusal([&] { law.check(); });
        EXPECT_THAT(told, testing::AllOf(testing::HasSubstr("normal law"), testing::HasSubstr(text),
                                         testing::HasSubstr("positive and finite")));
        EXPECT_EQ(refusal([&] { (void)taut::draw_length_deviations(law, 1, 0, 3); }), told);
    }
    EXPECT_EQ(refusal([] { LengthLaw{LengthLaw::Kind::normal, 1e-9}.check(); }), "not refused");
}

class BadLaw : public testing::TestWithParam<std::string> {};

TEST_P(BadLaw, IsRefusedWithItsText) {
    try {
        const LengthLaw law = parse_length_law(GetParam());
        FAIL() << "'" << GetParam() << "' was read as " << law.to_string();
    } catch (const std::invalid_argument& error) {
        const size_t colon = GetParam().find(':');
        const std::string scale =
            colon == std::string::npos ? GetParam() : GetParam().substr(colon + 1);
        EXPECT_THAT(error.what(), testing::AnyOf(testing::HasSubstr("'" + GetParam() + "'"),
                                                 testing::HasSubstr("'" + scale + "'")));
        EXPECT_THAT(error.what(), testing::HasSubstr("expected"));
    }
}

INSTANTIATE_TEST_SUITE_P(Texts, BadLaw,
                         testing::Values("", "uniform", "5mm", ":5mm", "uniform:", "gauss:5mm",
                                         "Uniform:5mm", " uniform:5mm", "uniform :5mm",
                                         "uniform:5km", "uniform:5mm:2mm", "uniform:0",
                                         "uniform:0mm", "normal:-2mm", "bimodal:-5mm",
                                         "uniform:nan", "uniform:inf", "uniform:1e400mm",
                                         "uniform,5mm"));

}  // namespace
