// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a survey put on the wrong nodes, or taken for one of this net where it is in
// millimetres, in another frame or of another net: every length identified from it would be wrong.

#include "taut/survey/survey.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "survey/mean_edge_length.hpp"
#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;
using testing::AllOf;
using testing::HasSubstr;

/// Every node of a net where it nominally is, in the order of the nodes; line 10 + node.
std::vector<SurveyPoint> survey_of(const CableNet& net) {
    std::vector<SurveyPoint> points;
    for (int node = 0; node < net.node_count(); ++node) {
        points.push_back({net.node_id(node), net.nodes().col(node), 10 + node});
    }
    return points;
}

/// A net whose nodes have names, none of them the index of a node.
CableNet named_net() {
    CableNetData content = hypar(2, 2).data();
    for (int node = 0; node < static_cast<int>(content.nodes.cols()); ++node) {
        content.node_ids.push_back("N" + std::to_string(100 + node));
    }
    return CableNet(content);
}

/// The error with which points are refused; line -1 where they are not.
SurveyError survey_error(const CableNet& net, const std::vector<SurveyPoint>& points) {
    try {
        (void)match_to_nodes(net, points);
    } catch (const SurveyError& error) {
        return error;
    }
    return {-1, "not refused"};
}

class MatchToNodes : public testing::Test {
protected:
    const CableNet m_net = hypar(3, 4);
    std::vector<SurveyPoint> m_points = survey_of(m_net);
    const int m_free = m_net.free_nodes()[4];
    const int m_support = m_net.supports()[2];

    SurveyPoint& at(int node) { return m_points[node]; }
};

TEST_F(MatchToNodes, PutsEachPointOnItsNode) {
    for (const int node : m_net.free_nodes()) {
        at(node).position += Eigen::Vector3d(0.001 * node, -0.002, 0.003);
    }
    at(m_support).position.z() += 0.001;  // which stays where it is known to be
    const Survey survey = match_to_nodes(m_net, m_points);
    for (const int node : m_net.free_nodes()) {
        EXPECT_EQ(survey.form.col(node), at(node).position) << "node " << node;
    }
    EXPECT_EQ(survey.form.col(m_support), m_net.nodes().col(m_support));
    EXPECT_EQ(survey.surveyed, m_net.free_nodes());
    EXPECT_TRUE(survey.missing.empty());
    EXPECT_EQ(match_to_nodes(m_net, {}).missing, m_net.free_nodes());
}

TEST_F(MatchToNodes, ListsTheFreeNodesThatAreMissingAndLeavesThemInTheirNominalPlace) {
    const int other = m_net.free_nodes()[1];
    std::erase_if(m_points, [&](const SurveyPoint& p) {
        return p.id == std::to_string(m_free) || p.id == std::to_string(other) ||
               p.id == std::to_string(m_support);
    });
    const Survey survey = match_to_nodes(m_net, m_points);
    EXPECT_THAT(survey.missing, testing::ElementsAre(other, m_free));
    EXPECT_EQ(survey.surveyed.size(), m_net.free_nodes().size() - 2);
    EXPECT_THAT(survey.surveyed, testing::Not(testing::Contains(m_free)));
    EXPECT_TRUE(std::ranges::is_sorted(survey.surveyed));
    EXPECT_EQ(survey.form.col(m_free), m_net.nodes().col(m_free));
}

TEST_F(MatchToNodes, KnowsNodesByTheirNames) {
    const CableNet net = named_net();
    std::vector<SurveyPoint> points = survey_of(net);
    std::ranges::reverse(points);
    const int node = net.free_nodes()[0];
    for (SurveyPoint& point : points) {
        if (point.id == "N" + std::to_string(100 + node)) {
            point.position.y() += 0.002;
        }
    }
    const Eigen::Vector3d expected = net.nodes().col(node) + Eigen::Vector3d(0.0, 0.002, 0.0);
    EXPECT_EQ(match_to_nodes(net, points).form.col(node), expected);
    // And not by their index.
    EXPECT_THAT(survey_error(net, {{"0", net.nodes().col(0), 3}}).what(),
                HasSubstr("'0' is no node of the net"));
}

TEST_F(MatchToNodes, RefusesANameThatComesTwice) {
    m_points.push_back(at(m_free));
    m_points.back().line = 99;
    const SurveyError error = survey_error(m_net, m_points);
    EXPECT_EQ(error.line(), 99);
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("'" + std::to_string(m_free) + "'"), HasSubstr("second time")));
}

TEST_F(MatchToNodes, RefusesPositionsThatAreNotFinite) {
    for (const double bad : {std::nan(""), -HUGE_VAL}) {
        at(m_free).position.y() = bad;
        const SurveyError error = survey_error(m_net, m_points);
        EXPECT_EQ(error.line(), 10 + m_free);
        EXPECT_THAT(error.what(), HasSubstr("not finite"));
    }
}

TEST_F(MatchToNodes, RefusesAFreeNodeFurtherAwayThanTheMeanEdgeIsLong) {
    const double limit = mean_edge_length(m_net);
    at(m_free).position = m_net.nodes().col(m_free) + Eigen::Vector3d(0.0, 0.0, 0.99 * limit);
    EXPECT_EQ(survey_error(m_net, m_points).line(), -1);
    at(m_free).position = m_net.nodes().col(m_free) + Eigen::Vector3d(0.0, 0.0, 1.01 * limit);
    const SurveyError error = survey_error(m_net, m_points);
    EXPECT_EQ(error.line(), 10 + m_free);
    EXPECT_THAT(error.what(), AllOf(HasSubstr("node '" + std::to_string(m_free) + "'"),
                                    HasSubstr("expected at most")));
}

TEST_F(MatchToNodes, RefusesASupportThatMovedByATenthOfTheMeanEdgeLength) {
    const double limit = 0.1 * mean_edge_length(m_net);
    at(m_support).position = m_net.nodes().col(m_support) + Eigen::Vector3d(0.99 * limit, 0.0, 0.0);
    EXPECT_EQ(survey_error(m_net, m_points).line(), -1);
    at(m_support).position = m_net.nodes().col(m_support) + Eigen::Vector3d(1.01 * limit, 0.0, 0.0);
    const SurveyError error = survey_error(m_net, m_points);
    EXPECT_EQ(error.line(), 10 + m_support);
    EXPECT_THAT(error.what(), AllOf(HasSubstr("support '" + std::to_string(m_support) + "'"),
                                    HasSubstr("in its frame")));
}

TEST(Survey, RefusesCorrelationsOfANodeThatIsNotThere) {
    Survey survey;
    survey.form = Points::Zero(3, 4);
    EXPECT_EQ(survey.correlations_of(7), Eigen::Vector3d::Zero());  // of no node there are any
    EXPECT_THROW(survey.set_correlations(4, {0.1, 0.0, 0.0}), std::out_of_range);
    survey.set_correlations(3, {0.1, 0.0, 0.0});
    EXPECT_EQ(survey.correlations_of(3).x(), 0.1);
    EXPECT_THROW(static_cast<void>(survey.correlations_of(4)), std::out_of_range);
    EXPECT_THROW(static_cast<void>(survey.correlations_of(-1)), std::out_of_range);
}

TEST_F(MatchToNodes, RefusesNoiseThatIsNone) {
    for (const double noise : {-1e-3, std::nan(""), HUGE_VAL}) {
        EXPECT_THROW((void)match_to_nodes(hypar(3, 3), {}, noise), std::invalid_argument);
    }
}

/// A survey as a program would fill it in.
class SurveyByHand : public testing::Test {
protected:
    SurveyByHand() {
        const int support = m_net.supports().front();
        m_survey.supports = {{.node = support, .position = m_net.nodes().col(support)}};
        m_survey.supports.front().noise_std.setConstant(1e-3);
    }

    /// @return what check_survey() says of the survey changed so
    template <class Change>
    std::string refusal(const Change& change) const {
        Survey survey = m_survey;
        change(survey);
        try {
            check_survey(m_net, survey);
        } catch (const SurveyError& error) {
            return error.what();
        }
        return "";
    }

    CableNet m_net = hypar(3, 3);
    Survey m_survey = match_to_nodes(m_net, survey_of(m_net), 1e-3);
};

TEST_F(SurveyByHand, IsCheckedInAllItsParts) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const int target = m_survey.surveyed.front();
    EXPECT_EQ(refusal([](Survey&) {}), "");
    EXPECT_THAT(refusal([&](Survey& s) { s.form(0, target) = 1e300; }), HasSubstr("1e+300 m"));
    EXPECT_THAT(refusal([](Survey& s) { s.supports[0].node = 100'000; }), HasSubstr("100000"));
    EXPECT_THAT(refusal([](Survey& s) { s.supports[0].node = -1; }), HasSubstr("-1"));
    EXPECT_THAT(refusal([&](Survey& s) { s.supports[0].node = target; }),
                HasSubstr("among the supports"));
    EXPECT_THAT(refusal([](Survey& s) { s.supports.push_back(s.supports[0]); }),
                HasSubstr("ascending"));
    EXPECT_THAT(refusal([&](Survey& s) { s.supports[0].position.x() = nan; }),
                HasSubstr("not finite"));
    EXPECT_THAT(refusal([&](Survey& s) { s.supports[0].noise_std.y() = nan; }),
                HasSubstr("standard deviations"));
    EXPECT_THAT(refusal([](Survey& s) { s.supports[0].noise_correlations.setConstant(2.0); }),
                HasSubstr("correlations"));
    EXPECT_THAT(refusal([&](Survey& s) { s.scale_std = nan; }), HasSubstr("scale_std"));
    EXPECT_THAT(refusal([](Survey& s) { s.rounding_std = -1.0; }), HasSubstr("rounding_std"));
}

TEST_F(SurveyByHand, IsScaledInItsNoiseByPositiveFactorsAlone) {
    EXPECT_EQ(with_noise_times(m_survey, 2.0).noise_std, 2.0 * m_survey.noise_std);
    EXPECT_THROW((void)with_noise_times(m_survey, 0.0), std::invalid_argument);
    EXPECT_THROW((void)with_noise_times(m_survey, std::nan("")), std::invalid_argument);
}

}  // namespace
