// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against tensions, strains and energies of a law that do not match: forms are then no
// equilibrium, and lengths follow from wrong tensions.
#include "taut/net/tension_law.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "support/random_laws.hpp"
#include "support/small_nets.hpp"

namespace taut {
namespace {

using ::testing::HasSubstr;

/// 50 kN up to 1 permille, flat up to 2, then 100 kN.
TensionLaw law() {
    return {.name = "strand",
            .strain = Eigen::VectorXd{{0.0, 0.001, 0.002, 0.003}},
            .tension = Eigen::VectorXd{{0.0, 50.0, 50.0, 150.0}}};
}

TEST(TensionLaw, IsStraightBetweenItsPointsAndContinuedBeyondThem) {
    EXPECT_DOUBLE_EQ(law().at(0.0005).tension, 25.0);
    EXPECT_DOUBLE_EQ(law().at(0.0005).slope, 50e3);
    EXPECT_DOUBLE_EQ(law().at(0.0015).tension, 50.0);
    EXPECT_DOUBLE_EQ(law().at(0.0015).slope, 0.0);
    EXPECT_NEAR(law().at(0.005).tension, 350.0, 1e-10);
    EXPECT_NEAR(law().at(0.005).slope, 100e3, 1e-6);
    EXPECT_DOUBLE_EQ(law().at(-0.001).tension, -50.0);
    EXPECT_NEAR(law().steepest(), 100e3, 1e-6);
}

TEST(TensionLaw, GivesTheLeastStrainOfATensionAndBothEndsOfAFlatPart) {
    EXPECT_NEAR(law().strain_at(50.0), 0.001, 1e-15);
    for (const double tension : {50.0, 50.0 * (1.0 + 1e-9)}) {
        EXPECT_NEAR(law().strains_at(tension).first, 0.001, 1e-15);
        EXPECT_NEAR(law().strains_at(tension).second, 0.002, 1e-15);
    }
    EXPECT_NEAR(law().strains_at(51.0).first, law().strain_at(51.0), 1e-15);
    EXPECT_EQ(law().strains_at(51.0).first, law().strains_at(51.0).second);
}

RC_GTEST_PROP(TensionLaw, BlurredIsItsMeanOverTheStrain, ()) {
    test::Random random = test::any_random();
    const TensionLaw it = test::random_law(random, 1e5);
    const double strain = test::uniform(random, -0.01, 0.08);
    const double std_dev = test::uniform(random, 1e-4, 0.02);
    constexpr int count = 4000;
    double mean = 0.0;
    double with_step = 0.0;
    double squares = 0.0;
    const auto [tension, slope, curvature] = it.blurred(strain, std_dev);
    for (int i = 0; i < count; ++i) {  // midpoints of [-8, 8] standard deviations
        const double z = -8.0 + 16.0 * (i + 0.5) / count;
        const double weight =
            16.0 / count * std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
        const double there = it.at(strain + std_dev * z).tension;
        mean += weight * there;
        with_step += weight * there * z / std_dev;
        squares += weight * std::pow(there - tension - slope * std_dev * z, 2);
    }
    RC_ASSERT(std::abs(tension - mean) < 1e-2);
    RC_ASSERT(std::abs(slope - with_step) < 1e-5 * 1e5);  // Stein's lemma
    // By 40 quantiles, which cut off the tails.
    const double whole = std::pow(it.steepest() * std_dev, 2);
    RC_ASSERT(std::abs(it.missed_by_blurred(strain, std_dev) - squares) <
              0.1 * squares + 5e-3 * whole);
}

RC_GTEST_PROP(TensionLaw, TensionAndStrainAreInverseWhereItRises, ()) {
    test::Random random = test::any_random();
    const TensionLaw it = test::random_law(random, 1e5);
    const double strain = test::uniform(random, 0.0, 0.1);
    if (it.at(strain).slope > 0.0) {
        RC_ASSERT(std::abs(it.strain_at(it.at(strain).tension) - strain) < 1e-12);
    }
}

RC_GTEST_PROP(TensionLaw, EnergyIsTheIntegralOfTheTension, ()) {
    test::Random random = test::any_random();
    const TensionLaw it = test::random_law(random, 1e5);
    const double a = test::uniform(random, 0.0, 0.08);
    const double b = test::uniform(random, 0.0, 0.08);
    // The midpoint rule is exact on all pieces but those with a corner in them.
    constexpr int pieces = 4000;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        sum += it.at(a + (b - a) * (i + 0.5) / pieces).tension * (b - a) / pieces;
    }
    RC_ASSERT(std::abs(it.energy_between(a, b) - sum) < 1e-3);
    RC_ASSERT(std::abs(it.energy_between(a, b) + it.energy_between(b, a)) < 1e-9);
    RC_ASSERT(std::abs(it.energy_between(0.0, a) + it.energy_between(a, b) -
                       it.energy_between(0.0, b)) < 1e-9);
}

TEST(TensionLaw, EnergyKeepsItsDigitsWhereStrainsAlmostAgree) {
    const double difference = law().energy_between(0.0025, 0.0025 + 1e-12);
    EXPECT_NEAR(difference / 1e-12, 100.0, 0.02);  // 1e-12 itself is rounded
    EXPECT_GT(difference, 0.0);
}

/// Of any sag, from one that is hardly there to one that makes the cable soft.
TensionLaw sagging(test::Random& random) {
    const double EA = std::pow(10.0, test::uniform(random, 4.0, 8.0));
    return {.name = "",
            .strain = Eigen::Vector2d(0.0, 1.0),
            .tension = Eigen::Vector2d(0.0, EA),
            .sag = EA * std::pow(10.0, test::uniform(random, -8.0, -2.0))};
}

RC_GTEST_PROP(SaggingLaw, SolvesItsEquationAndIsSmooth, ()) {
    test::Random random = test::any_random();
    const TensionLaw it = sagging(random);
    const double EA = it.tension(1);
    const double strain = test::uniform(random, -0.05, 0.02);
    const auto [T, slope, curvature] = it.at(strain);
    RC_ASSERT(problem_of(it).empty());
    RC_ASSERT(T > 0.0);
    RC_ASSERT(std::abs(T / EA - std::pow(it.sag / T, 2) - strain) < 1e-12);
    RC_ASSERT(std::abs(it.strain_at(T) - strain) < 1e-12);
    const double step = 1e-4 * T / slope;
    const auto forth = it.at(strain + step);
    const auto back = it.at(strain - step);
    RC_ASSERT(std::abs((forth.tension - back.tension) / (2.0 * step) - slope) < 1e-6 * slope);
    const double largest = EA * slope / T;  // no curvature is larger
    RC_ASSERT(std::abs((forth.slope - back.slope) / (2.0 * step) - curvature) < 1e-5 * largest);
    RC_ASSERT(slope <= EA);
    RC_ASSERT(it.blurred(strain, 0.01).tension == T);
}

RC_GTEST_PROP(SaggingLaw, EnergyIsTheIntegralOfTheTension, ()) {
    test::Random random = test::any_random();
    const TensionLaw it = sagging(random);
    const double from = it.at(test::uniform(random, -0.01, 0.01)).tension;
    const double to = from * test::uniform(random, 0.5, 2.0);
    // Over the tension: T d strain = T (strain of T)'.
    constexpr int pieces = 2000;
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
        const double a = from + (to - from) * i / pieces;
        const double b = from + (to - from) * (i + 1) / pieces;
        sum += 0.5 * (a + b) * (it.strain_at(b) - it.strain_at(a));
    }
    const double a = it.strain_at(from);
    const double b = it.strain_at(to);
    const double scale = to * std::abs(b - a);
    RC_ASSERT(std::abs(it.energy_between(a, b) - sum) < 1e-5 * scale + 1e-12 * to);
    RC_ASSERT(std::abs(it.energy_between(a, b) + it.energy_between(b, a)) <= 1e-12 * scale);
    RC_ASSERT(it.corner_energy(std::min(a, b), std::max(a, b)) >= -1e-12 * scale);  // convex
    RC_ASSERT(std::abs(it.corner_energy(a, b) + sum - 0.5 * (from + to) * (b - a)) <
              1e-5 * scale + 1e-12 * to);
}

TEST(SaggingLaw, IsSofterByErnstsFactorAndScaledWithoutItsSag) {
    // 100 m, 0.4 kN/m, 2000 kN and 1.6 GN: w l = 40 kN.
    const TensionLaw it{.name = "",
                        .strain = Eigen::Vector2d(0.0, 1.0),
                        .tension = Eigen::Vector2d(0.0, 1.6e9),
                        .sag = 40e3 / std::sqrt(24.0)};
    const double T = 2e6;
    const double ernst = 1.6e9 / (1.0 + 1.6e9 * 40e3 * 40e3 / (12.0 * T * T * T));
    EXPECT_NEAR(it.at(it.strain_at(T)).slope, ernst, 1e-6 * ernst);
    for (const double zero : {0.0, -0.0}) {  // T^3 = EA S^2
        EXPECT_NEAR(it.at(zero).tension, std::cbrt(1.6e9 * it.sag * it.sag), 1e-3);
    }
    EXPECT_EQ(it.stiffened(2.0).sag, it.sag);
    EXPECT_EQ(it.stiffened(2.0).tension(1), 3.2e9);
    EXPECT_EQ(it.strain_at(0.0), -std::numeric_limits<double>::infinity());
    TensionLaw bent = law();
    bent.sag = 1.0;
    EXPECT_THAT(problem_of(bent), HasSubstr("4 points, expected a positive sag and two"));
}

TEST(TensionLaw, HasTheProblemOfTheFirstRuleThatItBreaks) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto problem = [](std::initializer_list<double> strain,
                            std::initializer_list<double> tension) {
        return problem_of({.name = "",
                           .strain = Eigen::Map<const Eigen::VectorXd>(
                               strain.begin(), static_cast<Eigen::Index>(strain.size())),
                           .tension = Eigen::Map<const Eigen::VectorXd>(
                               tension.begin(), static_cast<Eigen::Index>(tension.size()))});
    };
    EXPECT_EQ(problem({0.0, 0.01}, {0.0, 5.0}), "");
    EXPECT_EQ(problem({0.0, 0.01, 0.02, 0.03}, {0.0, 5.0, 5.0, 6.0}), "");
    EXPECT_THAT(problem({0.0}, {0.0}), HasSubstr("two at least"));
    EXPECT_THAT(problem({0.0, 0.01}, {0.0, 5.0, 6.0}), HasSubstr("2 strains and 3 tensions"));
    EXPECT_THAT(problem({0.0, 0.01}, {1.0, 5.0}), HasSubstr("starts at (0, 1)"));
    EXPECT_THAT(problem({0.001, 0.01}, {0.0, 5.0}), HasSubstr("starts at (0.001, 0)"));
    EXPECT_THAT(problem({0.0, 0.01, 0.02}, {0.0, 5.0, 4.0}), HasSubstr("falls from 5 to 4"));
    EXPECT_THAT(problem({0.0, 0.01, 0.01}, {0.0, 5.0, 6.0}), HasSubstr("ascend"));
    EXPECT_THAT(problem({0.0, 0.01, 0.02}, {0.0, 0.0, 6.0}), HasSubstr("flat at its start"));
    EXPECT_THAT(problem({0.0, 0.01, 0.02}, {0.0, 6.0, 6.0}), HasSubstr("ends flat"));
    EXPECT_THAT(problem({0.0, none}, {0.0, 6.0}), HasSubstr("finite"));
    EXPECT_THAT(problem({0.0, 0.1}, {0.0, 1e60}), HasSubstr("at most 1e+15"));
}

TEST(TensionLaw, OfANetIsRefusedWithItsPlace) {
    const auto message = [](const auto& change) -> std::string {
        CableNetData data = test::two_node_net_data();
        data.tension_laws = {law()};
        data.tension_law = {-1, 0, -1, 0, -1};
        change(data);
        try {
            const CableNet net(std::move(data));
        } catch (const NetError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message([](CableNetData&) {}), "");
    EXPECT_THAT(message([](CableNetData& d) { d.tension_laws[0].tension(3) = 10.0; }),
                HasSubstr("tension_laws[0]: falls"));
    EXPECT_THAT(message([](CableNetData& d) { d.tension_law[3] = 1; }),
                HasSubstr("tension_law[3]: is 1, expected the index of one of the 1 tension laws"));
    EXPECT_THAT(message([](CableNetData& d) { d.tension_law.pop_back(); }),
                HasSubstr("tension_law: has 4 entries, expected 5"));
}

TEST(TensionLaw, GivesItsEdgeTheGreatestSlopeAsAxialStiffness) {
    CableNetData data = test::two_node_net_data();
    const Eigen::VectorXd given = data.axial_stiffness;
    data.tension_laws = {law()};
    data.tension_law = {-1, 0, -1, -1, -1};
    const CableNet net(data);
    EXPECT_NEAR(net.axial_stiffness()(1), 100e3, 1e-6);
    EXPECT_EQ(net.axial_stiffness()(0), given(0));
    EXPECT_EQ(net.tension_law(0), nullptr);
    ASSERT_NE(net.tension_law(1), nullptr);
    EXPECT_EQ(net.tension_law(1)->name, "strand");
    EXPECT_FALSE(net.is_linear());
    data.tension_law[1] = -1;
    EXPECT_TRUE(CableNet(data).is_linear());
}

TEST(TensionLaw, IsPartOfTheFingerprint) {
    CableNetData data = test::two_node_net_data();
    data.axial_stiffness.setConstant(100e3);
    const std::string linear = CableNet(data).fingerprint();
    data.tension_laws = {law()};
    EXPECT_EQ(CableNet(data).fingerprint(), linear) << "no edge has the law";
    data.tension_law = {0, -1, -1, -1, -1};
    const std::string with_law = CableNet(data).fingerprint();
    EXPECT_NE(with_law, linear);
    data.tension_laws[0].tension(1) = data.tension_laws[0].tension(2) = 40.0;
    const std::string with_other = CableNet(data).fingerprint();
    EXPECT_NE(with_other, with_law);
    data.tension_laws[0].name = "another";
    EXPECT_EQ(CableNet(data).fingerprint(), with_other);
}

TEST(TensionLaw, OfLessThanTwoPointsIsRefused) {
    const TensionLaw empty;
    EXPECT_THROW(static_cast<void>(empty.at(0.1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(empty.strain_at(0.1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(empty.blurred(0.1, 0.01)), std::invalid_argument);
    TensionLaw uneven = law();
    uneven.strain.conservativeResize(uneven.strain.size() - 1);
    EXPECT_THROW(static_cast<void>(uneven.at(0.1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(uneven.strains_at(0.1)), std::invalid_argument);
}

}  // namespace
}  // namespace taut
