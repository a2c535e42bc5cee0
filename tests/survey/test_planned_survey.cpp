// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a plan that names other nodes than it says.

#include "survey/planned_survey.hpp"

#include <gtest/gtest.h>

#include "support/small_nets.hpp"

namespace {

using namespace taut;

TEST(PlannedSurvey, HoldsTheFreeNodesThatItNames) {
    const CableNet net(test::two_node_net_data());
    const Survey survey = planned_survey(net, {{.id = "b"}, {.id = "C"}}, 0.001);
    EXPECT_EQ(survey.surveyed, std::vector<int>{3});
    EXPECT_EQ(survey.missing, std::vector<int>{0});
    EXPECT_EQ(survey.form, net.nodes());
    EXPECT_EQ(survey.noise_std.col(3), Eigen::Vector3d::Constant(0.001));
}

TEST(PlannedSurvey, RefusesANameThatIsNoNodesOrComesTwiceWithItsLine) {
    const CableNet net(test::two_node_net_data());
    for (const auto& [id, message] : {std::pair("c", "'c' is no node of the net 'two nodes'"),
                                      std::pair("a", "surveys node 'a' a second time"),
                                      std::pair("", "names no node, expected one")}) {
        try {
            static_cast<void>(
                planned_survey(net, {{.id = "a", .line = 3}, {.id = id, .line = 7}}, 0.001));
            ADD_FAILURE() << id << " is not refused";
        } catch (const SurveyError& error) {
            EXPECT_EQ(error.line(), 7);
            EXPECT_STREQ(error.what(), message);
        }
    }
}

}  // namespace
