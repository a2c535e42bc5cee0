// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against tensions from frequencies that leave out how stiff a cable is, how its ends are
// held, how long it is between its clamps, and how much it sags.

#include "taut/survey/cable_vibration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/small_nets.hpp"

namespace {

using namespace taut;
using namespace taut::test;
using testing::HasSubstr;

TEST(CableVibration, TensionsAreThoseOfFiniteElements) {
    const auto reference =
        nlohmann::json::parse(std::ifstream(TAUT_TEST_DATA_DIR "/vibration_reference.json"));
    for (const auto& cable : reference.at("cables")) {
        const double tension = tension_of_frequency(
            {.length = cable.at("length"),
             .mass = cable.at("mass"),
             .bending_stiffness = cable.at("bending_stiffness")},
            cable.at("frequency"), cable.at("mode"),
            cable.at("ends") == "hinged" ? CableEnds::hinged : CableEnds::fixed);
        EXPECT_NEAR(tension, cable.at("tension"), 1e-5 * cable.at("tension").get<double>())
            << cable;
    }
}

TEST(CableVibration, ABeamWithoutTensionHasNone) {
    const VibratingCable beam{.length = 1.0, .mass = 1.0, .bending_stiffness = 100.0};
    const double of_beam = std::pow(4.730040744862704, 2) * 10.0 / (2.0 * M_PI);
    EXPECT_LT(tension_of_frequency(beam, 0.99 * of_beam, 1, CableEnds::fixed), 0.0);
    EXPECT_NEAR(tension_of_frequency(beam, 1.001 * of_beam, 1, CableEnds::fixed), 8.2, 0.5);
}

/// The two-node net with masses.
CableNet with_mass(double mass, double bending_stiffness = 0.0) {
    CableNetData data = two_node_net().data();
    const auto edges = static_cast<Eigen::Index>(data.edges.size());
    data.mass = Eigen::VectorXd::Constant(edges, mass);
    if (bending_stiffness > 0.0) {
        data.bending_stiffness = Eigen::VectorXd::Constant(edges, bending_stiffness);
    }
    return CableNet(std::move(data));
}

double span_of(const CableNet& net, int edge) {
    const auto [s, t] = net.edges()[edge];
    return (net.nodes().col(s) - net.nodes().col(t)).norm();
}

TEST(CableVibration, AnExpectedFrequencyShowsItsTension) {
    for (const double bending_stiffness : {0.0, 12.0}) {
        const CableNet net = with_mass(0.3, bending_stiffness);
        const double length = span_of(net, 0);
        const double frequency = expected_frequency(net, 0, length, 5e3).value();
        EXPECT_NEAR(tension_by_frequency(net, net.nodes(),
                                         {.edge = 0, .frequency = frequency, .std_dev = 1.0}, 0.0)
                        .tension,
                    5e3, 1e-6);
        EXPECT_FALSE(expected_frequency(net, 0, length, 0.0));
    }
    EXPECT_FALSE(expected_frequency(two_node_net(), 0, 1.0, 5e3)) << "no mass is known";
    EXPECT_FALSE(expected_frequency(with_mass(50.0), 0, 100.0, 5e3)) << "it sags";
}

TEST(CableVibration, FrequencyAndFreeLengthAreInItsOwnError) {
    const CableNet net = with_mass(0.1);
    const ForceMeasurement found = tension_by_frequency(
        net, net.nodes(), {.edge = 2, .frequency = 50.0, .mode = 2, .std_dev = 0.5}, 0.01);
    const double string = 0.1 * std::pow(2.0 * span_of(net, 2) * 25.0, 2);
    EXPECT_EQ(found.mode, 2);
    EXPECT_NEAR(found.tension, string, 0.05 * string);
    EXPECT_NEAR(found.std_dev, 2.0 * found.tension * std::hypot(0.01, 0.01 / span_of(net, 2)),
                1e-9 * string);
}

TEST(CableVibration, BendingAndEndsAreInTheErrorThatAllShare) {
    const auto shared = [](double bending_stiffness) {
        const CableNet net = with_mass(0.1, bending_stiffness);
        return tension_by_frequency(
            net, net.nodes(), {.edge = 2, .frequency = 50.0, .mode = 2, .std_dev = 0.5}, 0.01);
    };
    const ForceMeasurement limp = shared(1e-9);
    const ForceMeasurement stiff = shared(0.12);
    EXPECT_LT(limp.shared_std, 1e-2 * limp.tension);
    EXPECT_GT(stiff.shared_std, 10.0 * limp.shared_std);
    EXPECT_LT(stiff.tension, limp.tension);
}

TEST(CableVibration, KnownEndsAreNotInTheErrorThatAllShare) {
    const auto shared = [](CableEnds ends, double bending_stiffness) {
        CableNetData data = with_mass(0.1, bending_stiffness).data();
        data.cable_ends.assign(data.edges.size(), ends);
        const CableNet net(std::move(data));
        return tension_by_frequency(
            net, net.nodes(), {.edge = 2, .frequency = 50.0, .mode = 1, .std_dev = 0.5}, 0.01);
    };
    const double length = span_of(with_mass(0.1), 2);
    const VibratingCable cable{.length = length, .mass = 0.1, .bending_stiffness = 0.12};
    const double unknown = shared(CableEnds::unknown, 0.12).shared_std;
    for (const CableEnds ends : {CableEnds::hinged, CableEnds::fixed}) {
        const ForceMeasurement known = shared(ends, 0.12);
        EXPECT_NEAR(known.tension, tension_of_frequency(cable, 50.0, 1, ends),
                    1e-3 * known.tension);  // the sag
        EXPECT_LT(known.shared_std, 0.05 * unknown);
        EXPECT_GT(shared(ends, 0.0).shared_std, 2.0 * known.shared_std) << "of the bending";
    }
}

TEST(CableVibration, WhatIsNoStringIsRefused) {
    const auto expect_refused = [](const CableNet& net, const FrequencyMeasurement& measured,
                                   const char* message, double free_length_std = 0.01) {
        EXPECT_THAT(
            [&] {
                static_cast<void>(
                    tension_by_frequency(net, net.nodes(), measured, free_length_std));
            },
            ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
    };
    const FrequencyMeasurement sound{.edge = 2, .frequency = 50.0, .mode = 1, .std_dev = 0.5};
    FrequencyMeasurement vague = sound;
    vague.std_dev = 40.0;
    FrequencyMeasurement slow = sound;
    slow.frequency = 0.02;
    slow.std_dev = 1e-3;
    expect_refused(two_node_net(), sound, "needs its mass");
    expect_refused(with_mass(0.1), sound, "free length", 100.0);
    expect_refused(with_mass(0.1), vague, "below half of it");
    expect_refused(with_mass(0.1, 1e6), sound, "has without tension");
    expect_refused(with_mass(1.0, 1e-12), slow, "sags too much");
}

}  // namespace
