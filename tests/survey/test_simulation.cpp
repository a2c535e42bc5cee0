// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a simulated survey that is kinder, or harsher, than it says.

#include "taut/survey/simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "taut/design/builtin_nets.hpp"
#include "taut/survey/registration.hpp"

namespace {

using namespace taut;

class SimulatedSurvey : public testing::Test {
protected:
    const CableNet m_net = hilo_quarter();

    std::vector<SurveyPoint> survey(const SurveySimulation& simulation) const {
        return simulate_survey(m_net, m_net.nodes(), simulation);
    }
};

TEST_F(SimulatedSurvey, IsTheFormItselfWhereNothingIsAskedOfIt) {
    const auto points = survey({});
    ASSERT_EQ(points.size(), m_net.node_count());
    const Survey matched = match_to_nodes(m_net, points);
    EXPECT_EQ(matched.form, m_net.nodes());
    EXPECT_TRUE(matched.missing.empty());
    EXPECT_FALSE(points[0].noise_std.has_value());
}

TEST_F(SimulatedSurvey, HasTheNoiseItWasAskedFor) {
    const Survey matched = match_to_nodes(m_net, survey({.noise_std = 0.002}));
    const double rms = (matched.form - m_net.nodes()).norm() /
                       std::sqrt(3.0 * static_cast<double>(matched.surveyed.size()));
    // 900 numbers: the standard deviation of their RMS is 2.4 %.
    EXPECT_NEAR(rms, 0.002, 4 * 0.024 * 0.002);
    EXPECT_EQ(matched.noise_std.col(m_net.free_nodes()[0]), Eigen::Vector3d::Constant(0.002));
}

TEST_F(SimulatedSurvey, InAFrameOfItsOwnComesBackByItsSupports) {
    const auto points =
        survey({.noise_std = 1e-4, .dropped_part = 0.1, .shuffled = true, .random_frame = true});
    const Registration found = register_rigidly(support_control_points(m_net, points));
    EXPECT_GT(found.motion.from.norm(), 1e4);
    const Survey matched = match_to_nodes(m_net, moved(points, found.motion));
    EXPECT_EQ(matched.surveyed.size(), 270U);
    EXPECT_LT((matched.form - m_net.nodes()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST_F(SimulatedSurvey, IsTheSameForTheSameSeedAndAnotherForAnother) {
    const SurveySimulation all{
        .noise_std = 1e-3, .dropped_part = 0.2, .shuffled = true, .random_frame = true, .seed = 4};
    SurveySimulation other = all;
    other.seed = 5;
    EXPECT_EQ(survey(all)[200].position, survey(all)[200].position);
    EXPECT_NE(survey(all)[200].position, survey(other)[200].position);
}

TEST_F(SimulatedSurvey, RefusesEachSettingThatMakesNoSense) {
    EXPECT_THROW(survey({.noise_std = -1e-3}), std::invalid_argument);
    EXPECT_THROW(survey({.noise_std = std::numeric_limits<double>::infinity()}),
                 std::invalid_argument);
    EXPECT_THROW(survey({.dropped_part = 1.0}), std::invalid_argument);
    EXPECT_THROW(survey({.dropped_part = -0.1}), std::invalid_argument);
    EXPECT_THROW(simulate_survey(m_net, Points::Zero(3, 4), {}), std::invalid_argument);
}

}  // namespace
