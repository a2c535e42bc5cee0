// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a net that breaks a rule and is taken all the same, and against a refusal that
// does not tell where the fault is, which value it has and which rule it breaks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <limits>

#include "support/small_nets.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Breaks the two-node net in one way, and expects a NetError at a place, with words.
void expect_refused(const std::function<void(CableNetData&)>& break_it, const std::string& where,
                    std::initializer_list<const char*> words) {
    CableNetData data = test::two_node_net_data();
    break_it(data);
    try {
        const CableNet net(std::move(data));
        FAIL() << "taken, though broken at " << where;
    } catch (const NetError& error) {
        EXPECT_EQ(error.what(), where + ": " + error.problem());
        for (const char* word : words) {
            EXPECT_THAT(error.what(), HasSubstr(word));
        }
    }
}

/// The error of the two-node net broken in one way.
NetError error_of(const std::function<void(CableNetData&)>& break_it) {
    CableNetData data = test::two_node_net_data();
    break_it(data);
    try {
        const CableNet net(std::move(data));
    } catch (const NetError& error) {
        return error;
    }
    return {"none", {}, ""};
}

TEST(NetErrors, TellTheFieldTheEntryAndTheProblemApart) {
    const NetError edge = error_of([](auto& d) { d.edges[2] = {3, 3}; });
    EXPECT_EQ(edge.field(), "edges");
    EXPECT_THAT(edge.index(), ElementsAre(2));
    EXPECT_EQ(edge.problem(), "connects node 3 to itself");
    EXPECT_STREQ(edge.what(), "edges[2]: connects node 3 to itself");
}

TEST(NetErrors, TellACoordinateByNodeAndAxis) {
    const NetError coordinate = error_of([](auto& d) { d.nodes(1, 4) = nan; });
    EXPECT_EQ(coordinate.field(), "nodes");
    EXPECT_THAT(coordinate.index(), ElementsAre(4, 1));
    EXPECT_STREQ(coordinate.what(), "nodes[4][1]: is nan, expected a finite number");
}

TEST(NetErrors, TellNoEntryWhereTheWholeFieldIsWrong) {
    const NetError field = error_of([](auto& d) { d.edges.clear(); });
    EXPECT_EQ(field.field(), "edges");
    EXPECT_THAT(field.index(), IsEmpty());
    EXPECT_STREQ(field.what(), "edges: is empty, expected at least one edge");
}

TEST(CableNetRules, TakeTheNetThatTheOtherTestsBreak) {
    EXPECT_NO_THROW((void)CableNet(test::two_node_net_data()));
}

TEST(CableNetRules, RefuseMagnitudesWhoseProductsWouldOverflow) {
    expect_refused([](auto& d) { d.axial_stiffness(2) = 1e308; }, "axial_stiffness[2]",
                   {"1e+308", "from 1e-15 to 1e+15"});
    expect_refused([](auto& d) { d.unstressed_lengths(1) = 1e-310; }, "unstressed_lengths[1]",
                   {"from 1e-15 to 1e+15"});
    expect_refused([](auto& d) { d.nodes(1, 3) = -1e200; }, "nodes[3][1]",
                   {"-1e+200", "no more than 1e+15"});
    expect_refused(
        [](auto& d) {
            d.loads = Points::Zero(3, d.nodes.cols());
            d.loads(2, 0) = 1e160;
        },
        "loads[0][2]", {"1e+160", "no more than 1e+15"});
}

TEST(CableNetRules, RefuseANetWithoutNodes) {
    expect_refused([](auto& d) { d.nodes.resize(3, 0); }, "nodes", {"empty"});
}

TEST(CableNetRules, RefuseANetWithoutEdges) {
    expect_refused([](auto& d) { d.edges.clear(); }, "edges", {"empty"});
}

TEST(CableNetRules, RefuseAnotherNumberOfStiffnessesThanEdges) {
    expect_refused([](auto& d) { d.axial_stiffness.conservativeResize(4); }, "axial_stiffness",
                   {"4 entries", "expected 5", "edge"});
}

TEST(CableNetRules, RefuseAnotherNumberOfLengthsThanEdges) {
    expect_refused([](auto& d) { d.unstressed_lengths.setOnes(6); }, "unstressed_lengths",
                   {"6 entries", "expected 5", "edge"});
}

TEST(CableNetRules, RefuseAnotherNumberOfLoadsThanNodes) {
    expect_refused([](auto& d) { d.loads.setZero(3, 5); }, "loads",
                   {"5 entries", "expected 6", "node"});
}

TEST(CableNetRules, RefuseAnotherNumberOfNodeNamesThanNodes) {
    expect_refused([](auto& d) { d.node_ids.pop_back(); }, "node_ids",
                   {"5 entries", "expected 6", "node"});
}

TEST(CableNetRules, RefuseAnotherNumberOfEdgeNamesThanEdges) {
    expect_refused([](auto& d) { d.edge_ids.emplace_back("more"); }, "edge_ids",
                   {"6 entries", "expected 5", "edge"});
}

TEST(CableNetRules, RefuseACoordinateThatIsNotFinite) {
    expect_refused([](auto& d) { d.nodes(1, 4) = nan; }, "nodes[4][1]", {"nan", "finite"});
    expect_refused([](auto& d) { d.nodes(2, 0) = -infinity; }, "nodes[0][2]", {"-inf", "finite"});
}

TEST(CableNetRules, RefuseALoadThatIsNotFinite) {
    expect_refused([](auto& d) { d.loads(0, 3) = nan; }, "loads[3][0]", {"nan", "finite"});
    expect_refused([](auto& d) { d.loads(2, 5) = infinity; }, "loads[5][2]", {"inf", "finite"});
}

TEST(CableNetRules, RefuseAStiffnessThatIsNotPositiveAndFinite) {
    for (const auto& [value, text] :
         {std::pair{0.0, "is 0"}, {-2.5, "is -2.5"}, {nan, "is nan"}, {infinity, "is inf"}}) {
        expect_refused([value = value](auto& d) { d.axial_stiffness(3) = value; },
                       "axial_stiffness[3]", {text, "positive and finite"});
    }
}

TEST(CableNetRules, RefuseAnUnstressedLengthThatIsNotPositiveAndFinite) {
    for (const auto& [value, text] :
         {std::pair{0.0, "is 0"}, {-2.5, "is -2.5"}, {nan, "is nan"}, {infinity, "is inf"}}) {
        expect_refused([value = value](auto& d) { d.unstressed_lengths(2) = value; },
                       "unstressed_lengths[2]", {text, "positive and finite"});
    }
}

TEST(CableNetRules, RefuseASupportThatIsNoNode) {
    expect_refused([](auto& d) { d.supports[2] = 6; }, "supports[2]", {"is 6", "6 nodes"});
    expect_refused([](auto& d) { d.supports[0] = -1; }, "supports[0]", {"is -1", "6 nodes"});
}

TEST(CableNetRules, RefuseASupportListedTwice) {
    expect_refused([](auto& d) { d.supports.push_back(4); }, "supports[4]",
                   {"node 4", "second time"});
}

TEST(CableNetRules, RefuseANetWithoutFreeNodes) {
    expect_refused([](auto& d) { d.supports = {0, 1, 2, 3, 4, 5}; }, "supports",
                   {"every node", "at least one free node"});
}

TEST(CableNetRules, RefuseAnEdgeToANodeThatIsNot) {
    expect_refused([](auto& d) { d.edges[1] = {2, 6}; }, "edges[1]", {"node 6", "6 nodes"});
    expect_refused([](auto& d) { d.edges[4] = {-1, 3}; }, "edges[4]", {"node -1", "6 nodes"});
}

TEST(CableNetRules, RefuseAnEdgeFromANodeToItself) {
    expect_refused([](auto& d) { d.edges[2] = {3, 3}; }, "edges[2]", {"node 3 to itself"});
}

TEST(CableNetRules, RefuseAnEdgeBetweenTwoSupports) {
    expect_refused([](auto& d) { d.edges[3] = {2, 4}; }, "edges[3]",
                   {"supports 2 and 4", "free node"});
}

TEST(CableNetRules, RefuseTwoEdgesBetweenTheSameNodesInEitherDirection) {
    expect_refused([](auto& d) { d.edges[4] = {3, 4}; }, "edges[4]",
                   {"nodes 3 and 4", "edge 3 already does"});
    expect_refused([](auto& d) { d.edges[3] = {3, 0}; }, "edges[3]",
                   {"nodes 3 and 0", "edge 2 already does"});
}

TEST(CableNetRules, RefuseAnEdgeOfZeroLength) {
    expect_refused([](auto& d) { d.nodes.col(4) = d.nodes.col(3); }, "edges[3]",
                   {"zero length", "nodes 3 and 4"});
}

TEST(CableNetRules, RefuseAnAdjustableEdgeThatIsNot) {
    expect_refused([](auto& d) { d.adjustable[1] = 5; }, "adjustable[1]", {"is 5", "5 edges"});
    expect_refused([](auto& d) { d.adjustable[0] = -3; }, "adjustable[0]", {"is -3", "5 edges"});
}

TEST(CableNetRules, RefuseAnAdjustableEdgeListedTwice) {
    expect_refused([](auto& d) { d.adjustable.push_back(4); }, "adjustable[2]",
                   {"edge 4", "second time"});
}

TEST(CableNetRules, RefuseAFreeNodeWithoutEdges) {
    expect_refused([](auto& d) { d.supports = {1, 4, 5}, d.edges[1] = {5, 0}; }, "nodes[2]",
                   {"free node without edges"});
}

TEST(CableNetRules, RefuseAPartOfTheNetThatReachesNoSupport) {
    // Nodes 1 and 2, free and joined, apart from 0 and 3 that hang on 4 and 5.
    expect_refused([](auto& d) { d.supports = {4, 5}, d.edges[0] = {1, 2}, d.edges[1] = {5, 0}; },
                   "nodes[1]", {"reaches no support"});
    expect_refused([](auto& d) { d.supports.clear(); }, "nodes[0]", {"reaches no support"});
}

TEST(CableNetRules, TakeASupportWithoutEdges) {
    CableNetData data = test::two_node_net_data();
    data.edges[4] = {2, 3};
    EXPECT_NO_THROW(CableNet(std::move(data)));
}

TEST(CableNetRules, RefuseAnEmptyName) {
    // Lists have one name a line.
    expect_refused([](auto& d) { d.name = "roof\nnet: 1000 free nodes"; }, "name",
                   {"line break", "one line"});
    expect_refused([](auto& d) { d.edge_ids[0] += '\0'; }, "edge_ids[0]", {"zero byte"});
    expect_refused([](auto& d) { d.node_ids[3] += "\r\n"; }, "node_ids[3]", {"line break"});
    expect_refused([](auto& d) { d.node_ids[3].clear(); }, "node_ids[3]", {"empty", "name"});
    expect_refused([](auto& d) { d.edge_ids[1].clear(); }, "edge_ids[1]", {"empty", "name"});
}

TEST(CableNetRules, RefuseANameGivenTwice) {
    expect_refused([](auto& d) { d.node_ids[5] = d.node_ids[3]; }, "node_ids[5]",
                   {"'b'", "second time"});
    expect_refused([](auto& d) { d.edge_ids[2] = d.edge_ids[0]; }, "edge_ids[2]",
                   {"'aA'", "second time"});
}

TEST(CableNetRules, TakeTheSameNameForANodeAndAnEdge) {
    CableNetData data = test::two_node_net_data();
    data.edge_ids[0] = data.node_ids[0];
    EXPECT_NO_THROW(CableNet(std::move(data)));
}

}  // namespace
}  // namespace taut
