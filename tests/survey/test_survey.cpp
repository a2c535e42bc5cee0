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
#include "survey/survey_errors.hpp"
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

SurveyError survey_error(const CableNet& net, const std::vector<SurveyPoint>& points) {
    return test::survey_error_of([&] { return match_to_nodes(net, points); });
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

// A free node may be off by the mean length of an edge, a support by a tenth of it.
TEST_F(MatchToNodes, RefusesPointsFarFromTheirNodes) {
    for (const auto& [name, node, part, words] :
         {std::tuple("node '", m_free, 1.0, "expected at most"),
          {"support '", m_support, 0.1, "in its frame"}}) {
        SCOPED_TRACE(name);
        const double limit = part * mean_edge_length(m_net);
        const Eigen::Vector3d place = m_net.nodes().col(node);
        at(node).position = place + Eigen::Vector3d(0.0, 0.0, 0.99 * limit);
        EXPECT_EQ(survey_error(m_net, m_points).line(), -1);
        at(node).position = place + Eigen::Vector3d(0.0, 0.0, 1.01 * limit);
        const SurveyError error = survey_error(m_net, m_points);
        EXPECT_EQ(error.line(), 10 + node);
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr(name + std::to_string(node) + "'"), HasSubstr(words)));
        at(node).position = place;
    }
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

    /// Expects check_survey() to refuse the survey changed so.
    template <class Change>
    void refused(const Change& change, const char* words) const {
        Survey survey = m_survey;
        change(survey);
        const SurveyError error = test::survey_error_of([&] { check_survey(m_net, survey); });
        EXPECT_THAT(error.what(), HasSubstr(words));
    }

    CableNet m_net = hypar(3, 3);
    Survey m_survey = match_to_nodes(m_net, survey_of(m_net), 1e-3);
};

TEST_F(SurveyByHand, IsCheckedInAllItsParts) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const int target = m_survey.surveyed.front();
    EXPECT_NO_THROW(check_survey(m_net, m_survey));
    refused([&](Survey& s) { s.form(0, target) = 1e300; }, "1e+300 m");
    refused([&](Survey& s) { s.form(2, target) = nan; }, "not finite");
    refused([](Survey& s) { s.form = Points::Zero(3, 2); }, "form has 2 columns");
    refused([](Survey& s) { s.noise_std = Points::Zero(3, 2); }, "noise_std has 2 columns");
    refused([&](Survey& s) { s.noise_std(1, target) = -2e-3; },
            "standard deviations of 0.001, -0.002 and 0.001");
    refused([](Survey& s) { s.surveyed[5] = s.surveyed[4]; }, "ascending order");
    refused([](Survey& s) { s.surveyed.clear(); }, "no free node");
    refused([](Survey& s) { s.supports[0].node = 100'000; }, "100000");
    refused([](Survey& s) { s.supports[0].node = -1; }, "-1");
    refused([&](Survey& s) { s.supports[0].node = target; }, "among the supports");
    refused([](Survey& s) { s.supports.push_back(s.supports[0]); }, "ascending");
    refused([&](Survey& s) { s.supports[0].position.x() = nan; }, "not finite");
    refused([&](Survey& s) { s.supports[0].noise_std.y() = nan; }, "standard deviations");
    refused([](Survey& s) { s.supports[0].noise_correlations.setConstant(2.0); }, "correlations");
    refused([&](Survey& s) { s.scale_std = nan; }, "scale_std");
    refused([](Survey& s) { s.rounding_std = -1.0; }, "rounding_std");
}

TEST_F(SurveyByHand, IsScaledInItsNoiseByPositiveFactorsAlone) {
    EXPECT_EQ(with_noise_times(m_survey, 2.0).noise_std, 2.0 * m_survey.noise_std);
    EXPECT_THROW((void)with_noise_times(m_survey, 0.0), std::invalid_argument);
    EXPECT_THROW((void)with_noise_times(m_survey, std::nan("")), std::invalid_argument);
}

}  // namespace
