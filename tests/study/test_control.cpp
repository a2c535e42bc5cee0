// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a simulated job that knows what no crew can know, or counts limits as kept that
// the true net breaks.
#include "taut/study/control.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sampling/uncertain_widths.hpp"
#include "taut/design/builtin_nets.hpp"

namespace taut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

ControlSettings small_job() {
    return {.prior = LengthPrior{.kind = LengthPrior::Kind::uniform, .scale = 2e-3},
            .noise_std = 0.2e-3,
            .stroke = 10e-3,
            .draws = 50,
            .rounds = 2,
            .trials = 3};
}

TEST(Control, BringsTheNetNearerAndRunsTheSameTwice) {
    const CableNet net = hypar(5, 5);
    const std::vector<ControlRecord> records = simulate_control(net, small_job());
    ASSERT_EQ(records.size(), 4u);
    for (const ControlRecord& record : records) {
        ASSERT_EQ(record.states.size(), 9u);  // as built and after two rounds, of three trials
        EXPECT_EQ(record.after(0).normal_rmse, records.front().after(0).normal_rmse);
        EXPECT_LT(record.after(1).normal_rmse, record.after(0).normal_rmse);
        EXPECT_EQ(record.after(2).failed, 0);
    }
    const ControlRecord& truth = records[0];
    const ControlRecord& identified = records[1];
    const ControlRecord& once = records[3];
    EXPECT_LE(truth.after(1).normal_rmse, identified.after(1).normal_rmse * 1.001);
    EXPECT_LT(identified.after(1).normal_rmse, 1.3 * truth.after(1).normal_rmse);
    EXPECT_EQ(once.after(2).turned, 0.0);
    EXPECT_EQ(once.after(2).normal_rmse, once.after(1).normal_rmse);
    const std::vector<ControlRecord> again = simulate_control(net, small_job());
    EXPECT_EQ(again[1].after(2).normal_rmse, identified.after(2).normal_rmse);
}

TEST(Control, CountsLimitsOfTheTrueNet) {
    const CableNet net = hypar(5, 5);
    ControlSettings settings = small_job();
    settings.rounds = 1;
    settings.stroke = 1e-6;  // nothing can be mended
    settings.least_tension = 1e7;
    for (const ControlRecord& record : simulate_control(net, settings)) {
        EXPECT_EQ(record.after(1).broken_trials, 3);
        EXPECT_GT(record.after(1).worst_excess, 0.9);
    }
}

TEST(Control, BuildsNetsWithWhatIsUncertain) {
    const CableNet net = hypar(5, 5);
    ControlSettings settings = small_job();
    const ControlRecord exact = simulate_control(net, settings)[1];
    settings.uncertain = {parse_uncertain_parameter("stiffness:10%"),
                          parse_uncertain_parameter("supports:2mm")};
    const ControlRecord built = simulate_control(net, settings)[1];
    for (size_t k = 0; k < exact.states.size(); k += 3) {  // as built, of the same lengths
        EXPECT_GT(std::abs(built.states[k].most_tension / exact.states[k].most_tension - 1.0),
                  0.01);
        EXPECT_GT(std::abs(built.states[k].deviation.mean - exact.states[k].deviation.mean), 1e-5);
    }
    EXPECT_EQ(built.after(1).failed, 0);
    EXPECT_LT(built.after(1).normal_rmse, built.after(0).normal_rmse);
}

/// Friction that is not given differs from net to net, and each slides on from where it stands.
TEST(Control, TurnsCablesThatSlide) {
    CableNetData data = sliding_ridge().data();
    data.runs.at(0).friction.reset();
    const CableNet net(std::move(data));
    ControlSettings settings = small_job();
    settings.prior.scale = 4e-3;
    const std::vector<ControlRecord> records = simulate_control(net, settings);
    for (const ControlRecord& record : records) {
        EXPECT_EQ(record.after(2).failed, 0);
    }
    EXPECT_LT(records[1].after(2).normal_rmse, 0.6 * records[1].after(0).normal_rmse);
    EXPECT_LT(records[1].after(2).normal_rmse, 1.3 * records[0].after(2).normal_rmse);
}

/// What weighs keeps its mass, which is uncertain, when edges are turned.
TEST(Control, PlansOnIdentifiedLengthsOfNetsWithMasses) {
    CableNetData data = hypar(4, 4).data();
    data.mass = Eigen::VectorXd::Constant(std::ssize(data.edges), 0.1);
    const CableNet net(data);
    ControlSettings settings = small_job();
    settings.uncertain = with_site_assumptions(net, {});
    ASSERT_GT(std_of(settings.uncertain, UncertainParameter::Kind::mass), 0.0);
    for (const ControlRecord& record : simulate_control(net, settings)) {
        EXPECT_EQ(record.after(1).failed, 0);
    }
}

TEST(Control, RefusesSettingsThatCannotBeMeant) {
    const CableNet net = hypar(3, 3);
    const auto expect_refused = [&](auto change, const char* text) {
        ControlSettings settings = small_job();
        change(settings);
        EXPECT_THAT([&] { static_cast<void>(simulate_control(net, settings)); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
    };
    expect_refused([](ControlSettings& s) { s.noise_std = 0.0; }, "noise");
    expect_refused([](ControlSettings& s) { s.hidden_part = 1.0; }, "hidden part");
    expect_refused([](ControlSettings& s) { s.rounds = 0; }, "rounds");
    expect_refused([](ControlSettings& s) { s.trials = 0; }, "trials");
    expect_refused([](ControlSettings& s) { s.stroke = -1.0; }, "stroke");
    expect_refused(
        [](ControlSettings& s) {
            s.least_tension = 5.0;
            s.most_tension = 4.0;
        },
        "largest tension");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double value : {nan, infinite, -1.0}) {
        expect_refused([&](ControlSettings& s) { s.noise_std = value; }, "noise");
        expect_refused([&](ControlSettings& s) { s.actuator_std = value; }, "actuator std");
        expect_refused([&](ControlSettings& s) { s.least_tension = value; }, "least tension");
        expect_refused([&](ControlSettings& s) { s.most_tension = value; }, "largest tension");
    }
    expect_refused([](ControlSettings& s) { s.draws = -1; }, "draws");
    expect_refused(
        [](ControlSettings& s) { s.uncertain = {parse_uncertain_parameter("loads:10%")}; },
        "loads");
}

}  // namespace
}  // namespace taut
