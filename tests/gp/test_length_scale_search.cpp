// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a search that is content before it has found the minimum (one that lies in a
// narrow valley between two points, say), that creeps towards it, or that spends what all outputs
// share where none of them gains.
#include "gp/length_scale_search.hpp"
#include "gp/likelihood_profile.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace taut::gp {
namespace {

struct ValueAndSlope {
    double value;
    double slope;
};

/// One output's value and slope over log lambda.
using Function = std::function<ValueAndSlope(double)>;

ValueAndSlope parabola(double x, double bottom, double curvature) {
    const double t = x - bottom;
    return {.value = 0.5 * curvature * t * t, .slope = curvature * t};
}

/// A dent in the line at zero: depth at the bottom, and so wide.
ValueAndSlope dent(double x, double bottom, double depth, double width) {
    const double t = (x - bottom) / width;
    const double value = -depth * std::exp(-0.5 * t * t);
    return {.value = value, .slope = -value * t / width};
}

LikelihoodProfile profile_of(const std::vector<Function>& outputs,
                             const LengthScaleSearch::Look& look) {
    const auto m = static_cast<Eigen::Index>(look.outputs.size());
    LikelihoodProfile profile{.value = Eigen::VectorXd(m),
                              .slope = Eigen::VectorXd(m),
                              .noise_ratio = Eigen::VectorXd::Ones(m),
                              .signal_variance = Eigen::VectorXd::Ones(m)};
    for (Eigen::Index j = 0; j < m; ++j) {
        const auto [value, slope] = outputs[look.outputs[j]](look.log_lambda);
        profile.value(j) = value;
        profile.slope(j) = slope;
    }
    return profile;
}

struct Found {
    std::vector<double> looked_at;
    bool content = false;
    std::vector<double> best;        ///< where, of each output
    std::vector<double> best_value;  ///< of each output
};

constexpr double left_end = -4.0;
constexpr double right_end = 3.5;

/// Looks at `together` points at a time, as fit() does, or at one.
Found search(const std::vector<Function>& outputs, double tolerance = 1e-7, int most = 100,
             int together = 1) {
    LengthScaleSearch search(std::ssize(outputs), left_end, right_end, tolerance);
    Found found;
    while (std::ssize(found.looked_at) < most) {
        const auto looks =
            search.next(std::min<int>(together, most - static_cast<int>(found.looked_at.size())));
        if (looks.empty()) {
            found.content = true;
            break;
        }
        EXPECT_LE(std::ssize(looks), together);
        for (const auto& look : looks) {
            found.looked_at.push_back(look.log_lambda);
            search.add(look, profile_of(outputs, look));
        }
    }
    found.best = search.best();
    for (size_t j = 0; j < outputs.size(); ++j) {
        found.best_value.push_back(outputs[j](found.best[j]).value);
    }
    return found;
}

double lowest(const Function& output) {
    double value = std::numeric_limits<double>::infinity();
    constexpr int steps = 100000;
    for (int k = 0; k <= steps; ++k) {
        value = std::min(value, output(left_end + (right_end - left_end) * k / steps).value);
    }
    return value;
}

RC_GTEST_PROP(LengthScaleSearch, FindsTheBottomOfAParabolaInOneStepBeyondItsFirstPoints, ()) {
    const double bottom = 1e-3 * *rc::gen::inRange(-3990, 3490);
    const auto found = search({[&](double x) { return parabola(x, bottom, 30.0); }});
    RC_ASSERT(found.content);
    RC_ASSERT(found.best_value[0] < 1e-6);
    RC_ASSERT(found.looked_at.size() <= 9);
}

RC_GTEST_PROP(LengthScaleSearch, FindsTheBottomOfALopsidedValley, ()) {
    // A gentle slope down, then a steep one up: a likelihood where the noise falls to its bound.
    const double bend = 1e-3 * *rc::gen::inRange(-3000, 3000);
    const double down = *rc::gen::inRange(1, 10);
    const double up = *rc::gen::inRange(30, 300);
    const double sharpness = *rc::gen::inRange(1, 8);
    const Function valley = [&](double x) {
        const double e = std::exp(sharpness * (x - bend));
        return ValueAndSlope{.value = up / sharpness * std::log1p(e) - down * x,
                             .slope = up * e / (1.0 + e) - down};
    };
    const double bottom = bend + std::log(down / (up - down)) / sharpness;
    RC_PRE(bottom > left_end);
    const auto found = search({valley}, 1e-6);
    RC_ASSERT(found.content);
    RC_ASSERT(found.best_value[0] - valley(bottom).value < 1e-4);
    RC_ASSERT(found.looked_at.size() <= 20);
}

RC_GTEST_PROP(LengthScaleSearch, FindsTheBottomWhereTheCurvatureJumps, ()) {
    const double bottom = 1e-3 * *rc::gen::inRange(-3000, 3000);
    const double left = *rc::gen::inRange(1, 10);
    const double right = *rc::gen::inRange(50, 300);
    const double tolerance = 1e-6;
    const auto found = search(
        {[&](double x) { return parabola(x, bottom, x < bottom ? left : right); }}, tolerance);
    RC_ASSERT(found.content);
    RC_ASSERT(found.looked_at.size() <= 20);
    // Left of the bottom, by d, and with the next point right of it the cubic takes the slope left
    // d to bend by the right one's curvature: it expects the bottom left d / right ahead and a gain
    // of (left d)^2 / (2 right). The search is content where the one is below 1e-4, or the other
    // below its tolerance; it is then left d^2 / 2 above the bottom.
    const double by_way = 0.5 * std::pow(1e-4 * right, 2) / left;
    const double by_gain = tolerance * right / left;
    RC_ASSERT(found.best_value[0] <= 1.05 * std::max(by_way, by_gain));
}

RC_GTEST_PROP(LengthScaleSearch, FindsANarrowValleyBesideAWideOne, ()) {
    // The wide one lies where the first points find it; the deeper one shows in slopes alone.
    const double bottom = 1e-3 * *rc::gen::inRange(0, 3000);
    const Function valleys = [&](double x) {
        const auto wide = parabola(x, -2.0, 2.0);
        const auto narrow = dent(x, bottom, 60.0, 0.5);
        return ValueAndSlope{.value = wide.value + narrow.value,
                             .slope = wide.slope + narrow.slope};
    };
    const auto found = search({valleys});
    RC_ASSERT(found.content);
    RC_ASSERT(found.best_value[0] < lowest(valleys) + 1e-4);
}

TEST(LengthScaleSearch, TakesTheEndOfTheRangeWhereTheValueFallsTowardsIt) {
    const auto found = search({[](double x) { return ValueAndSlope{.value = x, .slope = 1.0}; }});
    EXPECT_TRUE(found.content);
    EXPECT_EQ(found.best[0], left_end);
    const auto other = search({[](double x) { return ValueAndSlope{.value = -x, .slope = -1.0}; }});
    EXPECT_TRUE(other.content);
    EXPECT_EQ(other.best[0], right_end);
}

RC_GTEST_PROP(LengthScaleSearch, StaysWithinItsRange, ()) {
    std::vector<Function> outputs;
    const auto m = *rc::gen::inRange(1, 6);
    for (int j = 0; j < m; ++j) {
        const double bottom = 1e-3 * *rc::gen::inRange(-8000, 8000);
        const double curvature = *rc::gen::inRange(-5, 100);
        outputs.emplace_back([=](double x) { return parabola(x, bottom, curvature); });
    }
    for (const double x : search(outputs, 1e-7, 30).looked_at) {
        RC_ASSERT(x >= left_end);
        RC_ASSERT(x <= right_end);
    }
}

TEST(LengthScaleSearch, LooksOnceWhereTheRangeIsAPoint) {
    LengthScaleSearch search(1, 1.5, 1.5, 1e-6);
    const auto first = search.next(2);
    ASSERT_EQ(first.size(), 1);
    EXPECT_EQ(first[0].log_lambda, 1.5);
    search.add(first[0], profile_of({[](double x) { return parabola(x, 0.0, 1.0); }}, first[0]));
    EXPECT_TRUE(search.next(2).empty());
}

RC_GTEST_PROP(LengthScaleSearch, MakesEveryOfSeveralOutputsContent, ()) {
    std::vector<Function> outputs;
    for (int j = 0; j < 5; ++j) {
        const double bottom = 1e-3 * *rc::gen::inRange(-3900, 3400);
        const double curvature = *rc::gen::inRange(5, 100);
        outputs.emplace_back([=](double x) { return parabola(x, bottom, curvature); });
    }
    for (const int together : {1, 2}) {
        const auto found = search(outputs, 1e-7, 100, together);
        RC_ASSERT(found.content);
        for (const double value : found.best_value) {
            RC_ASSERT(value < 1e-6);
        }
    }
}

TEST(LengthScaleSearch, ServesTwoGroupsFarApartAndNotTheMiddleBetweenThem) {
    std::vector<Function> outputs;
    for (int j = 0; j < 20; ++j) {
        for (const double centre : {-2.7, 2.1}) {
            const double bottom = centre + 0.01 * j;
            outputs.emplace_back([=](double x) { return parabola(x, bottom, 30.0); });
        }
    }
    // A few with little to gain in between, at which a median of all wishes would fall.
    for (int j = 0; j < 5; ++j) {
        outputs.emplace_back([=](double x) { return parabola(x, -0.3 + 0.05 * j, 0.5); });
    }
    for (const int together : {1, 2}) {
        const Found found = search(outputs, 1e-7, 14, together);
        for (size_t j = 0; j < outputs.size(); ++j) {
            EXPECT_LT(found.best_value[j], 0.2) << j;
        }
    }
}

TEST(LengthScaleSearch, LosesLittleWhereHundredsOfOutputsShareADozenPoints) {
    std::vector<Function> outputs;
    for (int j = 0; j < 300; ++j) {
        const double bottom = -3.0 + 2.0 * j / 299.0;
        outputs.emplace_back([=](double x) { return parabola(x, bottom, 30.0); });
    }
    // Eight of the points can lie where they help. Evenly over the two units they would lose
    // 30 / 24 * 0.25^2 = 0.08 on average.
    for (const int together : {1, 2}) {
        double mean_loss = 0.0;
        for (const double value : search(outputs, 1e-7, 14, together).best_value) {
            mean_loss += value / 300.0;
        }
        EXPECT_LT(mean_loss, 0.1);
    }
}

TEST(LengthScaleSearch, SpendsNoneOfTwoPointsOnOutputsThatTheOtherServes) {
    // The first of the two helps all of the large group, and none of the small one.
    std::vector<Function> outputs(20, [](double x) { return parabola(x, -1.7, 30.0); });
    outputs.insert(outputs.end(), 2, [](double x) { return parabola(x, 1.4, 30.0); });
    const Found found = search(outputs, 1e-7, 100, 2);
    EXPECT_TRUE(found.content);
    ASSERT_GE(found.looked_at.size(), 2);
    EXPECT_NEAR(found.looked_at.end()[-2], -1.7, 1e-6);
    EXPECT_NEAR(found.looked_at.end()[-1], 1.4, 1e-6);
}

}  // namespace
}  // namespace taut::gp
