// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against searches that give up, and against a trial of it that flatters: surveys that
// cannot be repeated, nets that are none in equilibrium, failures that are not counted.

#include "taut/study/settling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/study/settling_nets.hpp"

namespace {

using namespace taut;

/// A survey that a search with slack sets alone gave up.
struct GivenUp {
    std::string name;
    CableNet net;
    int survey;
};

CableNet weak_hypar() {
    return with_strains(hypar(9, 9), 1.0, 0.02);
}
CableNet stiff_hypar() {
    return with_strains(hypar(9, 9), 10.0, 1.0);
}

class GivenUpBefore : public testing::TestWithParam<GivenUp> {};

TEST_P(GivenUpBefore, Settles) {
    const SettlingRecord record =
        try_settling(GetParam().net, {.surveys = 1, .first = GetParam().survey});
    const SettlingOutcome& outcome = record.outcomes.front();
    EXPECT_TRUE(outcome.settled) << outcome.message;
    EXPECT_GE(record.coverage(), 0.85);
}

INSTANTIATE_TEST_SUITE_P(
    Nets, GivenUpBefore,
    testing::Values(GivenUp{"gross_errors_that_make_the_statics_singular", hilo_quarter(), 1},
                    GivenUp{"slack_edges_and_gross_errors", stiff_hypar(), 2},
                    GivenUp{"slack_edges_and_hidden_nodes", stiff_hypar(), 5},
                    GivenUp{"little_prestress_and_hidden_nodes", weak_hypar(), 3},
                    GivenUp{"little_prestress_alone", weak_hypar(), 6}),
    [](const auto& test) { return test.param.name; });

TEST(SettlingSurvey, FollowsFromItsSeedAndNumberAlone) {
    const CableNet net = hypar(4, 5);
    const SettlingRecord all = try_settling(net, {.surveys = 4, .seed = 3});
    const SettlingRecord last = try_settling(net, {.surveys = 1, .first = 3, .seed = 3});
    EXPECT_EQ(all.outcomes[3].number, 3);
    EXPECT_EQ(all.outcomes[3].noise_std, last.outcomes[0].noise_std);
    EXPECT_EQ(all.outcomes[3].inside, last.outcomes[0].inside);
    EXPECT_EQ(settling_survey(net, 3, 3).survey.form, settling_survey(net, 3, 3).survey.form);
    EXPECT_NE(settling_survey(net, 3, 3).noise_std, settling_survey(net, 4, 3).noise_std);
    EXPECT_NE(settling_survey(net, 3, 3).noise_std, settling_survey(net, 3, 4).noise_std);
}

TEST(SettlingSurvey, HoldsWhatItTells) {
    const CableNet net = hypar(6, 7);
    int with_hidden = 0;
    int with_gross = 0;
    for (int number = 0; number < 20; ++number) {
        const SettlingSurvey s = settling_survey(net, 1, number);
        const Equilibrium truth = EquilibriumSolver(net).solve(
            [&] {
                Eigen::VectorXd lengths = net.unstressed_lengths();
                lengths(net.interior_edges()) += s.deviations;
                return lengths;
            }(),
            net.nodes());
        EXPECT_LE(s.deviations.cwiseAbs().maxCoeff(), s.prior.scale);
        EXPECT_GE(s.noise_std, 0.00005);
        EXPECT_LE(s.noise_std, 0.002);
        int far = 0;
        for (const int node : s.survey.surveyed) {
            far += (s.survey.form.col(node) - truth.form.col(node)).norm() > 6.0 * s.noise_std;
        }
        EXPECT_EQ(far, s.gross_errors);
        EXPECT_EQ(s.survey.surveyed.size() + s.survey.missing.size(), net.free_nodes().size());
        EXPECT_EQ(std::ranges::count(s.slack, true),
                  std::ranges::count_if(truth.slack_edges, [&](int edge) {
                      return std::ranges::binary_search(net.interior_edges(), edge);
                  }));
        with_hidden += s.survey.missing.empty() ? 0 : 1;
        with_gross += s.gross_errors > 0 ? 1 : 0;
    }
    EXPECT_THAT(with_hidden, testing::AllOf(testing::Gt(3), testing::Lt(17)));
    EXPECT_THAT(with_gross, testing::AllOf(testing::Gt(3), testing::Lt(17)));
}

TEST(SettlingRecord, HoldsTensionsAgainstTheTruth) {
    const CableNet net = hypar(4, 4);
    const SettlingRecord record = try_settling(net, {.surveys = 12, .seed = 2});
    int told = 0;
    for (const SettlingOutcome& outcome : record.outcomes) {
        EXPECT_THAT(outcome.tensions_told, testing::AnyOf(0, net.edge_count()));
        told += outcome.tensions_told > 0 ? 1 : 0;
    }
    EXPECT_GE(told, 6);
    const double inside = record.sum(&SettlingOutcome::tensions_inside);
    EXPECT_GT(inside, 0.85 * record.sum(&SettlingOutcome::tensions_told));
}

TEST(SettlingRecord, HoldsToldProbabilitiesOfSlackAgainstTheTruth) {
    const CableNet net = stiff_hypar();
    const SettlingRecord record = try_settling(net, {.surveys = 6, .first = 1});
    int edges = 0;
    double told = 0.0;
    double slack = 0.0;
    const SlackReliability reliability = record.slack_reliability();
    for (const SlackReliability::Bin& bin : reliability.bins()) {
        edges += bin.edges;
        told += bin.told;
        slack += bin.slack;
    }
    EXPECT_EQ(edges, record.sum(&SettlingOutcome::tensions_told));
    EXPECT_GT(slack, 0.0);
    EXPECT_NEAR(told, slack, 4.0 * std::sqrt(slack));
}

TEST(SlackReliability, PutsEachProbabilityIntoTheBinThatHoldsIt) {
    SlackReliability reliability;
    reliability.add(0.0, false);
    reliability.add(0.05, true);
    reliability.add(0.051, false);
    reliability.add(1.0, true);
    reliability.add(reliability);
    EXPECT_EQ(reliability.bins().front().edges, 2);
    EXPECT_EQ(reliability.bins()[1].slack, 2);
    EXPECT_EQ(reliability.bins()[2].edges, 2);
    EXPECT_DOUBLE_EQ(reliability.bins()[2].told, 0.102);
    EXPECT_EQ(reliability.bins().back().slack, 2);
}

TEST(SettlingNets, AreInEquilibriumAtTheirNodes) {
    for (const CableNet& net : settling_nets()) {
        const Equilibrium found = solve_equilibrium(net);
        EXPECT_TRUE(found.balanced()) << net.name();
        EXPECT_LT((found.form - net.nodes()).cwiseAbs().maxCoeff(), 1e-9) << net.name();
        EXPECT_TRUE(found.slack_edges.empty()) << net.name();
    }
}

TEST(SettlingNets, KeepTheirTensionsWhenStiffened) {
    const CableNet soft = hypar(3, 4);
    const CableNet stiff = with_strains(soft, 10.0, 0.5);
    const Eigen::VectorXd before = tensions(soft, soft.unstressed_lengths(), soft.nodes());
    const Eigen::VectorXd after = tensions(stiff, stiff.unstressed_lengths(), stiff.nodes());
    EXPECT_LT((after - 0.5 * before).cwiseAbs().maxCoeff(), 1e-8 * before.maxCoeff());
    EXPECT_THROW(static_cast<void>(with_strains(soft, 0.0, 1.0)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(with_strains(soft, 1.0, -1.0)), std::invalid_argument);
}

TEST(SettlingRecord, CountsOnlyWhatSettled) {
    SettlingRecord record{.net = "planted", .free_nodes = 1, .interior_edges = 10, .outcomes = {}};
    record.outcomes = {{.settled = true, .seconds = 1.0, .inside = 9, .slack_called = 2},
                       {.settled = false, .seconds = 7.0, .inside = 1, .slack_called = 5},
                       {.settled = true, .seconds = 2.0, .inside = 10, .slack_called = 1}};
    EXPECT_EQ(record.settled(), 2);
    EXPECT_EQ(record.median_seconds(), 2.0);
    EXPECT_EQ(record.largest_seconds(), 7.0);
    EXPECT_DOUBLE_EQ(record.coverage(), 0.95);
    EXPECT_EQ(record.sum(&SettlingOutcome::slack_called), 3);
}

TEST(SettlingSettings, RefuseWhatIsNoTrial) {
    EXPECT_THROW(static_cast<void>(try_settling(hypar(2, 2), {.surveys = 0})),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(try_settling(hypar(2, 2), {.first = -1})),
                 std::invalid_argument);
}

}  // namespace
