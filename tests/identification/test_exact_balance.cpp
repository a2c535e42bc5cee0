// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "identification/exact_balance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "identification/force_balance.hpp"
#include "identification/maximum_a_posteriori.hpp"
#include "support/hilo_roof.hpp"
#include "support/small_nets.hpp"
#include "support/steel_roof.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/sampling/data_set.hpp"

namespace taut {
namespace {

constexpr std::uint64_t seed = 77;

/// A net as built, and its exact survey.
struct BuiltNet {
    Eigen::VectorXd deviations;  ///< m_I [m]
    Equilibrium equilibrium;
    Survey survey;
};

BuiltNet build(const CableNet& net, const LengthPrior& prior, std::uint64_t sample) {
    BuiltNet built;
    built.deviations = draw_length_deviations(prior, seed, sample, net.interior_edge_count());
    built.equilibrium =
        EquilibriumSolver(net).solve(with_length_deviations(net, built.deviations), net.nodes());
    built.survey.form = built.equilibrium.form;
    built.survey.surveyed = net.free_nodes();
    return built;
}

/// Taut edges to a nanometre where the prior leaves them free, all others named slack, and the form
/// found again.
void expect_all_lengths(const CableNet& net, const LengthPrior& prior, const BuiltNet& built,
                        const Identification& found) {
    ASSERT_EQ(built.equilibrium.status, EquilibriumStatus::converged);
    for (int i = 0; i < net.interior_edge_count(); ++i) {
        const IdentifiedEdge& edge = found.edges[i];
        const bool is_slack = std::ranges::binary_search(built.equilibrium.slack_edges, edge.edge);
        EXPECT_EQ(edge.status, is_slack ? EdgeStatus::slack : EdgeStatus::determined) << edge.edge;
        const double error = std::abs(edge.length_deviation - built.deviations(i));
        // By a bound of the prior the mean of what is left lies off it, by what stands for the
        // noise.
        const bool is_by_a_bound = std::abs(built.deviations(i)) > prior.scale - 6.0 * edge.std_dev;
        EXPECT_LT(error, is_slack        ? 2.0 * prior.scale
                         : is_by_a_bound ? 2.0 * edge.std_dev
                                         : 1e-9)
            << edge.edge;
        EXPECT_LE(edge.lower, built.deviations(i) + 1e-12);
        EXPECT_GE(edge.upper, built.deviations(i) - 1e-12);
    }
    EXPECT_LT(found.residuals.maxCoeff(), 1e-6);
}

TEST(ExactBalance, FindsLengthsAndSlackEdgesOfTheBuiltInNet) {
    const CableNet net = hilo_quarter();
    for (const double reach : {5e-3, 10e-3}) {
        const LengthPrior prior{.kind = LengthPrior::Kind::uniform, .scale = reach};
        const BuiltNet built = build(net, prior, 0);
        expect_all_lengths(net, prior, built, identify_by_exact_balance(net, built.survey, prior));
    }
}

void expect_lengths_though_edges_are_slack(const CableNet& net,
                                           const std::vector<double>& reaches) {
    for (const double reach : reaches) {
        const LengthPrior prior{.kind = LengthPrior::Kind::uniform, .scale = reach};
        for (const std::uint64_t sample : {1, 2, 3}) {
            const BuiltNet built = build(net, prior, sample);
            EXPECT_THAT(built.equilibrium.slack_edges, ::testing::Not(::testing::IsEmpty()));
            expect_all_lengths(net, prior, built,
                               identify_by_exact_balance(net, built.survey, prior));
        }
    }
}

TEST(ExactBalance, FindsThoseOfASteelRoofThoughEdgesAreSlack) {
    expect_lengths_though_edges_are_slack(test::steel_lattice(), {5e-3, 8e-3});
}

TEST(ExactBalance, FindsThoseOfTheHiloRoofThoughDozensOfEdgesAreSlack) {
    TAUT_NEEDS_HILO_ROOF();
    expect_lengths_though_edges_are_slack(test::hilo_roof(), {1e-3, 5e-3});
}

// Normal equations square the condition, and theirs are shifted by 1e-13 of their largest entry: of
// a cable ten thousand times softer than its neighbours they alone give five digits, and no
// nanometre.
TEST(ExactBalance, FindsTheLengthOfACableFarSofterThanItsNeighbours) {
    constexpr int soft = 20;
    CableNetData data = hypar(5, 5).data();
    data.axial_stiffness(hypar(5, 5).interior_edges()[soft]) *= 1e-4;
    const CableNet net(std::move(data));
    const LengthPrior prior{.kind = LengthPrior::Kind::uniform, .scale = 1e-3};
    for (const std::uint64_t sample : {1, 2}) {
        const BuiltNet built = build(net, prior, sample);
        const Identification found = identify_by_exact_balance(net, built.survey, prior);
        // Else its mean would lie off the truth by a bound of the prior.
        ASSERT_LT(std::abs(built.deviations(soft)), prior.scale - 4.0 * found.edges[soft].std_dev);
        EXPECT_NEAR(found.edges[soft].length_deviation, built.deviations(soft), 1e-9);
        expect_all_lengths(net, prior, built, found);
    }
}

TEST(ExactBalance, ClaimsNoLengthThatTheFormDoesNotDetermine) {
    // Of two crossed lines one holds the length that is known, and the other can be tighter at
    // will. Where the node is off the middle the lines have kinks: then edge 1 has a small share in
    // that.
    CableNetData data = test::cross_data(0.02);
    data.adjustable = {0};
    const CableNet net(std::move(data));
    const LengthPrior prior{.kind = LengthPrior::Kind::uniform, .scale = 5e-3};
    for (const std::uint64_t sample : {0, 1, 2, 3}) {
        const BuiltNet built = build(net, prior, sample);
        const Identification found = identify_by_exact_balance(net, built.survey, prior);
        for (int i = 0; i < net.interior_edge_count(); ++i) {
            const IdentifiedEdge& edge = found.edges[i];
            EXPECT_LE(edge.lower, built.deviations(i));
            EXPECT_GE(edge.upper, built.deviations(i));
        }
        EXPECT_GT(found.edges[0].std_dev, 1e-7);
        EXPECT_LT(found.edges[0].std_dev, 1e-5);
        EXPECT_GT(found.edges[1].std_dev, 0.5 * prior.std_dev());
        EXPECT_GT(found.edges[2].std_dev, 0.5 * prior.std_dev());
    }
}

TEST(ExactBalance, IsWhatBothMethodsMakeOfAnExactSurvey) {
    const CableNet net = hypar(5, 5);
    const LengthPrior prior{.kind = LengthPrior::Kind::uniform, .scale = 1e-3};
    const BuiltNet built = build(net, prior, 0);
    const Identification balance = identify_by_force_balance(net, built.survey, prior);
    const Identification map = identify_by_maximum_a_posteriori(net, built.survey, prior);
    EXPECT_EQ(balance.method, "balance");
    EXPECT_EQ(map.method, "map");
    expect_all_lengths(net, prior, built, balance);
    expect_all_lengths(net, prior, built, map);
}

}  // namespace
}  // namespace taut
