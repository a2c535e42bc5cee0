// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against nets that break a rule and are accepted, and against errors that do not name the
// place of the fault, its value and the rule. Rules of groups, runs, masses, expansion, breaking
// loads and threads: tests/io/test_net_json_errors.cpp. Tension laws: test_tension_law.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "support/not_finite.hpp"
#include "support/small_nets.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using test::infinity;
using test::nan;
using Data = CableNetData;
using Change = std::function<void(Data&)>;

/// The error of the two-node net after a change; of the field "none" if it is accepted.
NetError error_after(const Change& change) {
    Data data = test::two_node_net_data();
    change(data);
    try {
        const CableNet net(std::move(data));
    } catch (const NetError& error) {
        return error;
    }
    return {"none", {}, ""};
}

TEST(NetError, HoldsTheFieldTheEntryAndTheProblem) {
    const NetError edge = error_after([](Data& d) { d.edges[2] = {3, 3}; });
    EXPECT_EQ(edge.field(), "edges");
    EXPECT_THAT(edge.index(), ElementsAre(2));
    EXPECT_EQ(edge.problem(), "connects node 3 to itself");
    EXPECT_STREQ(edge.what(), "edges[2]: connects node 3 to itself");

    const NetError coordinate = error_after([](Data& d) { d.nodes(1, 4) = nan; });
    EXPECT_THAT(coordinate.index(), ElementsAre(4, 1));
    EXPECT_STREQ(coordinate.what(), "nodes[4][1]: is nan, expected a finite number");

    const NetError field = error_after([](Data& d) { d.edges.clear(); });
    EXPECT_THAT(field.index(), IsEmpty());
    EXPECT_STREQ(field.what(), "edges: is empty, expected at least one edge");
}

TEST(CableNetRules, AreTheseWithPlaceAndValue) {
    struct Case {
        Change change;
        const char* where;
        std::vector<const char*> words;
    };
    const std::vector<Case> cases{
        // sizes
        {[](Data& d) { d.nodes.resize(3, 0); }, "nodes", {"empty"}},
        {[](Data& d) { d.axial_stiffness.conservativeResize(4); },
         "axial_stiffness",
         {"4 entries", "expected 5", "edge"}},
        {[](Data& d) { d.unstressed_lengths.setOnes(6); },
         "unstressed_lengths",
         {"6 entries", "expected 5", "edge"}},
        {[](Data& d) { d.loads.setZero(3, 5); }, "loads", {"5 entries", "expected 6", "node"}},
        {[](Data& d) { d.node_ids.pop_back(); }, "node_ids", {"5 entries", "expected 6", "node"}},
        {[](Data& d) { d.edge_ids.emplace_back("more"); },
         "edge_ids",
         {"6 entries", "expected 5", "edge"}},
        // numbers: finite, and so small and large that no product overflows
        {[](Data& d) { d.nodes(2, 0) = -infinity; }, "nodes[0][2]", {"-inf", "finite"}},
        {[](Data& d) { d.nodes(1, 3) = -1e200; }, "nodes[3][1]", {"-1e+200", "no more than 1e+15"}},
        {[](Data& d) { d.loads(0, 3) = nan; }, "loads[3][0]", {"nan", "finite"}},
        {[](Data& d) { d.loads(2, 0) = 1e160; }, "loads[0][2]", {"1e+160", "no more than 1e+15"}},
        {[](Data& d) { d.axial_stiffness(3) = 0.0; }, "axial_stiffness[3]", {"is 0", "positive"}},
        {[](Data& d) { d.axial_stiffness(3) = nan; }, "axial_stiffness[3]", {"is nan", "finite"}},
        {[](Data& d) { d.axial_stiffness(2) = 1e308; },
         "axial_stiffness[2]",
         {"1e+308", "from 1e-15 to 1e+15"}},
        {[](Data& d) { d.unstressed_lengths(2) = -2.5; },
         "unstressed_lengths[2]",
         {"is -2.5", "positive"}},
        {[](Data& d) { d.unstressed_lengths(2) = infinity; },
         "unstressed_lengths[2]",
         {"is inf", "finite"}},
        {[](Data& d) { d.unstressed_lengths(1) = 1e-310; },
         "unstressed_lengths[1]",
         {"from 1e-15 to 1e+15"}},
        // supports
        {[](Data& d) { d.supports[2] = 6; }, "supports[2]", {"is 6", "6 nodes"}},
        {[](Data& d) { d.supports[0] = -1; }, "supports[0]", {"is -1", "6 nodes"}},
        {[](Data& d) { d.supports.push_back(4); }, "supports[4]", {"node 4", "second time"}},
        {[](Data& d) { d.supports = {0, 1, 2, 3, 4, 5}; },
         "supports",
         {"every node", "at least one free node"}},
        // edges
        {[](Data& d) { d.edges[1] = {2, 6}; }, "edges[1]", {"node 6", "6 nodes"}},
        {[](Data& d) { d.edges[4] = {-1, 3}; }, "edges[4]", {"node -1", "6 nodes"}},
        {[](Data& d) { d.edges[3] = {2, 4}; }, "edges[3]", {"supports 2 and 4", "free node"}},
        {[](Data& d) { d.edges[4] = {3, 4}; }, "edges[4]", {"nodes 3 and 4", "edge 3 already"}},
        {[](Data& d) { d.edges[3] = {3, 0}; }, "edges[3]", {"nodes 3 and 0", "edge 2 already"}},
        {[](Data& d) { d.nodes.col(4) = d.nodes.col(3); },
         "edges[3]",
         {"zero length", "nodes 3 and 4"}},
        {[](Data& d) { d.adjustable[1] = 5; }, "adjustable[1]", {"is 5", "5 edges"}},
        {[](Data& d) { d.adjustable[0] = -3; }, "adjustable[0]", {"is -3", "5 edges"}},
        {[](Data& d) { d.adjustable.push_back(4); }, "adjustable[2]", {"edge 4", "second time"}},
        // every free node hangs on a support
        {[](Data& d) { d.supports = {1, 4, 5}, d.edges[1] = {5, 0}; },
         "nodes[2]",
         {"free node without edges"}},
        {[](Data& d) { d.supports = {4, 5}, d.edges[0] = {1, 2}, d.edges[1] = {5, 0}; },
         "nodes[1]",
         {"reaches no support"}},
        {[](Data& d) { d.supports.clear(); }, "nodes[0]", {"reaches no support"}},
        // names: one line each
        {[](Data& d) { d.name = "roof\nnet: 1000 free nodes"; },
         "name",
         {"line break", "one line"}},
        {[](Data& d) { d.edge_ids[0] += '\0'; }, "edge_ids[0]", {"zero byte"}},
        {[](Data& d) { d.node_ids[3] += "\r\n"; }, "node_ids[3]", {"line break"}},
        {[](Data& d) { d.node_ids[3].clear(); }, "node_ids[3]", {"empty", "name"}},
        {[](Data& d) { d.node_ids[5] = d.node_ids[3]; }, "node_ids[5]", {"'b'", "second time"}},
        {[](Data& d) { d.edge_ids[2] = d.edge_ids[0]; }, "edge_ids[2]", {"'aA'", "second time"}},
    };
    for (const auto& [change, where, words] : cases) {
        const std::string message = error_after(change).what();
        EXPECT_THAT(message, testing::StartsWith(std::string(where) + ": "));
        for (const char* word : words) {
            EXPECT_THAT(message, HasSubstr(word));
        }
    }
}

TEST(CableNetRules, AllowASupportWithoutEdgesAndTheSameNameForANodeAndAnEdge) {
    const NetError error = error_after([](Data& d) {
        d.edges[4] = {2, 3};
        d.edge_ids[0] = d.node_ids[0];
    });
    EXPECT_EQ(error.field(), "none") << error.what();
}

}  // namespace
}  // namespace taut
