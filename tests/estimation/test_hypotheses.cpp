// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against kinds of hypotheses that follow different rules: each rule once, for all of them.
#include "estimation/hypotheses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/small_nets.hpp"

namespace {

using namespace taut;
using State = Hypothesis::State;
using Family = Hypotheses::Family;
using BoundaryTest = Hypotheses::BoundaryTest;

constexpr int last = 20;
constexpr double threshold = 25.0;

/// All kinds on the chain, tested, with the statistic 0.
struct Table : testing::Test {
    /// Nodes 0 to 20 in a row between two supports; edge k from node k to the next. The first and
    /// last are adjustable, so that interior edge i is edge i + 1.
    CableNet net{test::chain_data(last, last, 0.0)};
    Hypotheses all{net, list()};

    static std::vector<Hypothesis> list() {
        std::vector<Hypothesis> result;
        for (int node = 1; node < last; ++node) {
            result.push_back({.kind = Suspect::target, .index = node, .nodes = {node, -1, -1}});
        }
        for (int k = 0; k < 3; ++k) {
            result.push_back({.kind = Suspect::force, .index = k});
        }
        result.push_back({.kind = Suspect::force_scale});
        for (int i = 0; i < last - 2; ++i) {
            result.push_back({.kind = Suspect::length, .index = i, .nodes = {i + 1, i + 2, -1}});
        }
        for (int i = 0; i + 1 < last - 2; ++i) {
            result.push_back({.kind = Suspect::pair,
                              .index = i,
                              .other = i + 1,
                              .nodes = {i + 2, i + 1, i + 3}});
        }
        for (const int edge : {0, last - 1}) {
            result.push_back(
                {.kind = Suspect::adjustable_edge, .index = edge, .nodes = {edge, edge + 1, -1}});
        }
        for (const int node : {0, last}) {
            result.push_back({.kind = Suspect::support, .index = node, .nodes = {node, -1, -1}});
        }
        for (Hypothesis& one : result) {
            one.threshold = threshold;
            one.test = Hypothesis::Test::in_use;
        }
        return result;
    }

    Hypothesis& at(Suspect kind, int index) { return *all.find(kind, index); }
};

TEST(SnoopingThreshold, IsThatOfSidak) {
    EXPECT_NEAR(snooping_threshold(0.05, 1, 1), 3.8415, 1e-4);
    EXPECT_NEAR(snooping_threshold(0.05, 1, 3), 7.8147, 1e-4);
    EXPECT_NEAR(snooping_threshold(1.0 - std::pow(0.95, 10), 10, 1), 3.8415, 1e-4);
    EXPECT_TRUE(std::isinf(snooping_threshold(0.0, 10, 1)));
}

TEST_F(Table, ScoresTestsByWhatTheyExplainAboveTheirThresholds) {
    Hypothesis& one = at(Suspect::target, 5);
    one.statistic = threshold;
    EXPECT_DOUBLE_EQ(one.score(), 1.0);
    EXPECT_FALSE(one.is_outlier());
    one.statistic = threshold + 20.0;
    EXPECT_DOUBLE_EQ(one.score(), 2.0);
    EXPECT_TRUE(one.is_outlier());
    one.threshold = std::numeric_limits<double>::infinity();
    EXPECT_DOUBLE_EQ(one.score(), 0.0);
}

TEST_F(Table, ReleasesTheLargestWithinTwoEdgesOfWhateverKind) {
    at(Suspect::target, 10).statistic = 60.0;
    at(Suspect::target, 12).statistic = 50.0;  // two edges off
    at(Suspect::target, 13).statistic = 40.0;  // behind it: not the largest either
    at(Suspect::length, 10).statistic = 55.0;  // nodes 11 and 12
    at(Suspect::target, 16).statistic = 30.0;  // far away
    at(Suspect::length, 2).statistic = 60.0;   // nodes 3 and 4
    at(Suspect::target, 5).statistic = 59.0;   // one edge off
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.released(Suspect::target), (std::vector{10, 16}));
    EXPECT_EQ(all.released(Suspect::length), (std::vector{2}));
    EXPECT_TRUE(all.revise());  // what was behind those
    EXPECT_EQ(all.released(Suspect::target), (std::vector{5, 10, 16}));
    EXPECT_EQ(all.released(Suspect::length), (std::vector{2, 10}));
}

TEST_F(Table, ReleasesNothingBelowItsThresholdOrNotTested) {
    at(Suspect::target, 10).statistic = threshold;
    at(Suspect::length, 10).statistic = 100.0;
    at(Suspect::length, 10).test = Hypothesis::Test::none;
    EXPECT_FALSE(all.revise());
    all.begin_tests();
    at(Suspect::target, 10).statistic = 100.0;
    EXPECT_FALSE(all.revise());
}

TEST_F(Table, LetsTheCoreStatisticDecideOnlyWhereNoOtherStandsOut) {
    at(Suspect::length, 5).statistic = 10.0;
    at(Suspect::length, 5).core_statistic = 40.0;
    at(Suspect::length, 6).statistic = 15.0;
    at(Suspect::length, 6).core_statistic = 20.0;  // no outlier
    Hypotheses beside = all;
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.released(Suspect::length), (std::vector{5}));
    beside.find(Suspect::target, 7)->statistic = 26.0;
    EXPECT_TRUE(beside.revise());
    EXPECT_TRUE(beside.released(Suspect::length).empty());
    EXPECT_EQ(beside.released(Suspect::target), (std::vector{7}));
}

TEST_F(Table, ReleasesALengthOnlyOnce) {
    at(Suspect::length, 5).statistic = 40.0;
    at(Suspect::pair, 5).statistic = 60.0;
    at(Suspect::pair, 4).statistic = 60.0;  // shares edge 5: of two as large the first
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.released(Suspect::pair), (std::vector{4}));
    std::vector<bool> expected(last - 2, false);
    expected[4] = expected[5] = true;
    EXPECT_EQ(all.released_lengths(), expected);
    EXPECT_FALSE(all.revise());
    all.set_pair(at(Suspect::pair, 4), false);
    EXPECT_EQ(all.released_lengths(), std::vector<bool>(last - 2, false));
}

TEST_F(Table, ReadmitsForGoodWhatAgreesAfterAll) {
    for (const Suspect kind : {Suspect::target, Suspect::length, Suspect::adjustable_edge}) {
        Hypothesis& one = at(kind, kind == Suspect::adjustable_edge ? 0 : 8);
        one.state = State::released;
        one.statistic = 20.0;
        const BoundaryTest boundary =
            kind == Suspect::adjustable_edge ? BoundaryTest::at_once : BoundaryTest::none;
        EXPECT_TRUE(all.revise(boundary));
        EXPECT_EQ(one.state, State::readmitted);
        one.statistic = 100.0;
        EXPECT_FALSE(all.revise(boundary));
        all.reopen();
        EXPECT_TRUE(all.revise(boundary));
        EXPECT_TRUE(one.is_released());
        all.readmit_all();
        one.statistic = 0.0;
    }
}

TEST_F(Table, ReadmitsNothingReleasedForGoodOrNotTestedAnyMore) {
    at(Suspect::target, 8).state = State::released_for_good;
    at(Suspect::length, 3).state = State::released;
    at(Suspect::length, 3).test = Hypothesis::Test::none;
    at(Suspect::support, 0).state = State::released;  // does not take part
    EXPECT_FALSE(all.revise());
    EXPECT_EQ(all.released_count(Family::targets), 1);
    EXPECT_EQ(all.released_count(Family::lengths), 1);
    EXPECT_EQ(all.released_count(Family::boundary), 1);
}

TEST_F(Table, ReadmitsOnlyWhereNothingIsReleased) {
    at(Suspect::target, 3).state = State::released;
    at(Suspect::target, 15).statistic = 30.0;
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.released(Suspect::target), (std::vector{3, 15}));
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.released(Suspect::target), (std::vector{15}));
}

TEST_F(Table, ReleasesTheLargestForceMeasurementBeforeAnyTarget) {
    at(Suspect::force, 1).statistic = 50.0;
    at(Suspect::force, 2).statistic = 40.0;
    at(Suspect::target, 10).statistic = 45.0;
    at(Suspect::length, 2).statistic = 30.0;
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.released(Suspect::force), (std::vector{1}));
    EXPECT_TRUE(all.released(Suspect::target).empty());
    EXPECT_EQ(all.released(Suspect::length), (std::vector{2}));
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.released(Suspect::force), (std::vector{1}));
    EXPECT_EQ(all.released(Suspect::target), (std::vector{10}));
}

TEST_F(Table, ReleasesAllForceMeasurementsWhereTheyStandOutTogether) {
    at(Suspect::force, 1).statistic = 50.0;
    at(Suspect::force_scale, 0).statistic = 90.0;
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.released(Suspect::force), (std::vector{0, 1, 2}));
    EXPECT_EQ(all.found(Suspect::force_scale).size(), 1U);
    EXPECT_DOUBLE_EQ(all.cost(), 3.0 * threshold);
    EXPECT_FALSE(all.revise());  // none is readmitted by itself
}

TEST_F(Table, ReleasesTheBoundaryAsAskedFor) {
    at(Suspect::adjustable_edge, 0).statistic = 60.0;
    at(Suspect::adjustable_edge, last - 1).statistic = 30.0;
    at(Suspect::support, 0).statistic = 50.0;
    at(Suspect::target, 2).statistic = 40.0;  // by the larger one
    at(Suspect::target, 10).statistic = 40.0;
    Hypotheses without = all;
    Hypotheses last_of_all = all;
    EXPECT_TRUE(without.revise());
    EXPECT_EQ(without.released(Suspect::target), (std::vector{2, 10}));
    EXPECT_EQ(without.released_count(Family::boundary), 0);
    EXPECT_TRUE(all.revise(BoundaryTest::at_once));
    EXPECT_EQ(all.released(Suspect::target), (std::vector{10}));
    EXPECT_EQ(all.released(Suspect::adjustable_edge), (std::vector{0, last - 1}));
    EXPECT_TRUE(last_of_all.revise(BoundaryTest::one_by_one));
    EXPECT_EQ(last_of_all.released(Suspect::target), (std::vector{10}));
    EXPECT_EQ(last_of_all.released_count(Family::boundary), 0);
    EXPECT_TRUE(last_of_all.revise(BoundaryTest::one_by_one));
    EXPECT_EQ(last_of_all.released(Suspect::adjustable_edge), (std::vector{0}));
}

TEST_F(Table, NamesTheSupportThatExplainsNearlyAsMuch) {
    at(Suspect::adjustable_edge, 0).statistic = 60.0;
    at(Suspect::support, 0).statistic = 50.0;
    at(Suspect::adjustable_edge, last - 1).statistic = 60.0;
    at(Suspect::support, last).statistic = 10.0;
    EXPECT_TRUE(all.revise(BoundaryTest::at_once));
    EXPECT_EQ(at(Suspect::adjustable_edge, 0).confounded_with, 0);
    EXPECT_EQ(at(Suspect::adjustable_edge, last - 1).confounded_with, -1);
}

TEST_F(Table, SuspectsTheBoundaryNearWhatWasFound) {
    EXPECT_FALSE(all.may_be_boundary());
    at(Suspect::target, 10).state = State::released;
    EXPECT_FALSE(all.may_be_boundary());
    at(Suspect::target, 2).state = State::released;
    EXPECT_TRUE(all.may_be_boundary());
    all.readmit_all();
    at(Suspect::support, last).statistic = 30.0;
    EXPECT_TRUE(all.may_be_boundary());
}

TEST_F(Table, CostsTheThresholdOfAllThatIsReleased) {
    EXPECT_DOUBLE_EQ(all.cost(), 0.0);
    at(Suspect::target, 4).state = State::released;
    at(Suspect::length, 9).state = State::released;
    at(Suspect::pair, 12).state = State::released;
    at(Suspect::support, 0).state = State::released;
    EXPECT_DOUBLE_EQ(all.cost(), 4.0 * threshold);
    at(Suspect::pair, 12).state = State::released_for_good;  // beside a target, which is counted
    EXPECT_DOUBLE_EQ(all.cost(), 3.0 * threshold);
}

TEST_F(Table, SeesWhereTooManyAreReleased) {
    for (int count = 0; Hypothesis & one : all.of(Suspect::target)) {  // more than 4.75 of 19
        EXPECT_EQ(all.has_too_many(Family::targets), count >= 5);
        one.state = State::released;
        ++count;
    }
    all.readmit_all();
    for (int count = 0; const Suspect kind : {Suspect::adjustable_edge, Suspect::support}) {
        for (Hypothesis& one : all.of(kind)) {  // more than three
            one.state = State::released;
            EXPECT_EQ(all.has_too_many(Family::boundary), ++count == 4);
        }
    }
    all.readmit_all();
    for (Hypothesis& one : all.of(Suspect::target)) {
        one.statistic = 30.0;
    }
    EXPECT_FALSE(all.has_too_many(Family::targets));
    EXPECT_TRUE(all.contradicts_too_many(Family::targets));
    all.release_outliers(Suspect::target);
    EXPECT_TRUE(all.has_too_many(Family::targets));
}

TEST_F(Table, GivesUpTheLengthsWhereTooManyAreOutliers) {
    for (const int i : {1, 6, 11, 16}) {
        at(Suspect::length, i).statistic = 60.0;
    }
    EXPECT_TRUE(all.is_active(Family::lengths));
    EXPECT_TRUE(all.revise());
    EXPECT_EQ(all.given_up(), 4);
    EXPECT_FALSE(all.is_active(Family::lengths));
    EXPECT_EQ(all.released_count(Family::lengths), 0);
    EXPECT_FALSE(all.revise());
}

TEST_F(Table, IsRestoredByACopy) {
    at(Suspect::target, 4).statistic = 60.0;
    at(Suspect::length, 9).statistic = 40.0;
    EXPECT_TRUE(all.revise());
    const Hypotheses kept = all;
    all.readmit_all();
    at(Suspect::target, 4).statistic = 0.0;
    all = kept;
    ASSERT_EQ(all.found(Suspect::target).size(), 1U);
    EXPECT_DOUBLE_EQ(all.found(Suspect::target)[0].statistic, 60.0);
    EXPECT_DOUBLE_EQ(all.cost(), 2.0 * threshold);
}

TEST_F(Table, ListsWhatWasFoundTheLargestFirst) {
    at(Suspect::length, 3).state = State::released;
    at(Suspect::length, 3).statistic = 30.0;
    at(Suspect::length, 9).state = State::released;
    at(Suspect::length, 9).core_statistic = 50.0;
    const std::vector<Hypothesis> found = all.found(Suspect::length);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].index, 9);
    EXPECT_EQ(found[1].index, 3);
}

TEST_F(Table, DetectsOnlyWhatIsTested) {
    const std::span<Hypothesis> edges = all.of(Suspect::adjustable_edge);
    ASSERT_EQ(edges.size(), 2U);
    edges[0].noncentrality(0, 0) = 1e4;
    edges[1].noncentrality(0, 0) = 1e6;
    // One is surely found, so the other has to be in 60 % of the surveys.
    EXPECT_NEAR(all.detectable(Suspect::adjustable_edge), 1e-2 * (std::sqrt(threshold) + 0.2533),
                1e-4);
    edges[1].test = Hypothesis::Test::released;
    EXPECT_NEAR(all.detectable(Suspect::adjustable_edge), 1e-2 * (std::sqrt(threshold) + 0.8416),
                1e-4);  // normal, 80 %
    for (Hypothesis& support : all.of(Suspect::support)) {
        support.noncentrality = 1e6 * Eigen::Matrix3d::Identity();
        support.test = Hypothesis::Test::none;
    }
    EXPECT_TRUE(std::isinf(all.detectable(Suspect::support)));
}

}  // namespace
