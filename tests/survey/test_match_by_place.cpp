// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a target without a name put on a node that it is not of.

#include <gtest/gtest.h>

#include <algorithm>

#include "taut/design/builtin_nets.hpp"
#include "taut/survey/simulation.hpp"
#include "taut/survey/survey.hpp"

namespace {

using namespace taut;

std::string matching_refusal(const CableNet& net, const std::vector<SurveyPoint>& points) {
    try {
        (void)match_to_nodes(net, points);
    } catch (const SurveyError& error) {
        return error.what();
    }
    return "not refused";
}

class UnnamedTargets : public testing::Test {
protected:
    const CableNet m_net = hilo_quarter();
    std::vector<SurveyPoint> m_points = simulate_survey(
        m_net, m_net.nodes(), {.noise_std = 0.003, .dropped_part = 0.1, .shuffled = true});

    Eigen::Vector3d place(int free_index) const {
        return m_net.nodes().col(m_net.free_nodes()[free_index]);
    }
    /// Points that stand for nothing but these targets and some that are right.
    Survey match_with(const std::vector<Eigen::Vector3d>& targets) const {
        std::vector<SurveyPoint> points;
        for (int i = 100; i < 120; ++i) {
            points.push_back({"", place(i)});
        }
        for (const Eigen::Vector3d& target : targets) {
            points.push_back({"", target, 7});
        }
        return match_to_nodes(m_net, points);
    }
};

TEST_F(UnnamedTargets, AreAllPutOnTheirNodesWhereTheyLieNearThem) {
    const Survey survey = match_to_nodes(m_net, m_points);
    EXPECT_EQ(survey.surveyed.size(), 270U);
    EXPECT_EQ(survey.missing.size(), 30U);
    EXPECT_TRUE(survey.unmatched.empty());
    for (const int node : survey.surveyed) {
        EXPECT_LT((survey.form.col(node) - m_net.nodes().col(node)).norm(), 0.02);
        EXPECT_EQ(survey.noise_std.col(node), Eigen::Vector3d::Constant(0.003));
    }
}

TEST_F(UnnamedTargets, BetweenTwoNodesAreListedAndPutOnNone) {
    // The shortest interior edge: its middle is near both ends.
    const auto length = [this](int edge) {
        const auto [s, t] = m_net.edges()[edge];
        return (m_net.nodes().col(s) - m_net.nodes().col(t)).norm();
    };
    const int shortest = std::ranges::min(m_net.interior_edges(), {}, length);
    const auto [s, t] = m_net.edges()[shortest];
    const Survey survey = match_with({0.55 * m_net.nodes().col(s) + 0.45 * m_net.nodes().col(t)});
    ASSERT_EQ(survey.unmatched.size(), 1U);
    EXPECT_EQ(survey.unmatched[0].reason, UnmatchedReason::between_nodes);
    EXPECT_EQ(survey.unmatched[0].nearest, s);
    EXPECT_EQ(survey.unmatched[0].point.line, 7);
    EXPECT_EQ(survey.surveyed.size(), 20U);
}

TEST_F(UnnamedTargets, FarFromEveryNodeAreListed) {
    const Survey survey = match_with({{0, 0, 50}});
    ASSERT_EQ(survey.unmatched.size(), 1U);
    EXPECT_EQ(survey.unmatched[0].reason, UnmatchedReason::far_from_every_node);
    EXPECT_GT(survey.unmatched[0].distance, 40.0);
}

TEST_F(UnnamedTargets, ThatClaimTheSameNodeAreBothListed) {
    const Survey survey = match_with({place(5) + Eigen::Vector3d(0.001, 0, 0), place(5)});
    ASSERT_EQ(survey.unmatched.size(), 2U);
    EXPECT_EQ(survey.unmatched[0].reason, UnmatchedReason::node_taken);
    EXPECT_EQ(survey.unmatched[1].reason, UnmatchedReason::node_taken);
}

TEST_F(UnnamedTargets, OnANodeThatANamedPointIsOnAreListed) {
    std::vector<SurveyPoint> points{{m_net.node_id(m_net.free_nodes()[5]), place(5)},
                                    {"", place(5)},
                                    {"", place(6)},
                                    {"", place(7)}};
    const Survey survey = match_to_nodes(m_net, points);
    EXPECT_EQ(survey.surveyed.size(), 3U);
    ASSERT_EQ(survey.unmatched.size(), 1U);
    EXPECT_EQ(survey.unmatched[0].reason, UnmatchedReason::node_taken);
}

TEST_F(UnnamedTargets, OfASurveyInAnotherFrameAreRefused) {
    for (SurveyPoint& point : m_points) {
        point.id.clear();
        point.position += Eigen::Vector3d(100, 0, 0);
    }
    EXPECT_EQ(matching_refusal(m_net, m_points),
              "0 of 398 targets without a name lie clearly on one node, expected at least half: "
              "is the survey of this net, in its frame and in metres?");
}

TEST_F(UnnamedTargets, DoNotKeepASingleNamedPointFromBeingFarAway) {
    std::vector<SurveyPoint> points = simulate_survey(m_net, m_net.nodes(), {.noise_std = 0.001});
    points.back().position.z() += 1.0;
    const Survey survey = match_to_nodes(m_net, points);
    ASSERT_EQ(survey.unmatched.size(), 1U);
    EXPECT_EQ(survey.unmatched[0].reason, UnmatchedReason::far_from_its_node);
    EXPECT_EQ(survey.unmatched[0].nearest, m_net.free_nodes().back());
    EXPECT_EQ(survey.missing, std::vector<int>{m_net.free_nodes().back()});
}

}  // namespace
