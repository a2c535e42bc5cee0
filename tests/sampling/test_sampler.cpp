// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against wrong training data: forms that do not belong to their lengths, samples that
// depend on threads or on where a run was interrupted, deviations from a form that is not the
// nominal one.

#include "sampling/uniform_prior.hpp"
#include "taut/sampling/sampler.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/refusals.hpp"
#include "support/small_nets.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/threads.hpp"

namespace {

using namespace taut;

using taut::test::uniform_5mm;

DataSet draw(const CableNet& net, int count, const LengthPrior& from = uniform_5mm,
             std::uint64_t seed = 1) {
    return draw_samples(Sampler(net, from, seed), count);
}

void expect_same(const DataSet& a, const DataSet& b) {
    EXPECT_EQ(a.net_fingerprint, b.net_fingerprint);
    EXPECT_EQ(a.prior, b.prior);
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.nominal_form, b.nominal_form);
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(a.form_deviations, b.form_deviations);
    EXPECT_EQ(a.length_deviations, b.length_deviations);
    EXPECT_EQ(a.statuses, b.statuses);
    EXPECT_EQ(a.slack_counts, b.slack_counts);
}

/// All nodes in the form of sample k.
Points form_of(const CableNet& net, const DataSet& data, int k) {
    return with_free_coordinates(net, data.nominal_form + data.form_deviations.col(k));
}

/// Largest nodal force of sample k, in mean tensions.
double imbalance(const CableNet& net, const DataSet& data, int k) {
    const Eigen::VectorXd lengths = with_length_deviations(net, data.length_deviations.col(k));
    const Points form = form_of(net, data, k);
    const Eigen::VectorXd forces = out_of_balance_forces(net, lengths, form);
    return forces.reshaped(3, net.free_node_count()).colwise().norm().maxCoeff() /
           tensions_of(net, lengths, form).mean();
}

void expect_balance(const CableNet& net, const DataSet& data) {
    EXPECT_EQ(data.not_converged(), 0);
    for (int k = 0; k < data.size(); ++k) {
        EXPECT_LT(imbalance(net, data, k), 1e-9) << "sample " << k;
    }
}

/// A net with a load of 300 N downwards at each free node.
CableNet loaded(const CableNet& net) {
    CableNetData content = net.data();
    content.loads.setZero(3, net.node_count());
    content.loads(2, net.free_nodes()).setConstant(-300.0);
    return CableNet(content);
}

TEST(Sampler, DrawsTheLengthsOfItsPriorSeedAndSample) {
    const CableNet net = hypar(3, 4);
    const DataSet data = draw(net, 5, uniform_5mm, 9);
    for (int k = 0; k < data.size(); ++k) {
        EXPECT_EQ(data.length_deviations.col(k),
                  draw_length_deviations(uniform_5mm, 9, static_cast<std::uint64_t>(k),
                                         net.interior_edge_count()));
    }
}

TEST(Sampler, GivesFormsInEquilibriumAlsoWhereEdgesAreSlack) {
    const CableNet net = hypar(3, 4);
    expect_balance(net, draw(net, 40));
    const DataSet data = draw(net, 40, {LengthPrior::Kind::uniform, 0.02});
    ASSERT_GT(data.with_slack(), 10);
    expect_balance(net, data);
}

TEST(Sampler, CountsTheSlackEdgesOfEachSample) {
    const CableNet net = hypar(3, 4);
    const DataSet data = draw(net, 40, {LengthPrior::Kind::uniform, 0.01});
    int with_slack = 0;
    for (int k = 0; k < data.size(); ++k) {
        const auto slack = slack_edges(
            net, with_length_deviations(net, data.length_deviations.col(k)), form_of(net, data, k));
        EXPECT_EQ(data.slack_counts[k], static_cast<int>(slack.size())) << "sample " << k;
        with_slack += slack.empty() ? 0 : 1;
    }
    EXPECT_EQ(data.with_slack(), with_slack);
    EXPECT_GT(with_slack, 0);
    EXPECT_LT(with_slack, data.size());
}

TEST(Sampler, MarksSamplesThatAreMechanisms) {
    // A chain of two free nodes: the middle edge and one at a support are slack when it is too
    // long.
    CableNetData content = test::chain_data(3, 3.0, 0.0);
    content.axial_stiffness.setConstant(1000.0);
    content.unstressed_lengths.setConstant(0.999);
    const CableNet net(content);
    const DataSet data = draw(net, 30, {LengthPrior::Kind::uniform, 0.1});
    EXPECT_EQ(data.not_converged(), 0);
    for (int k = 0; k < data.size(); ++k) {
        // 3 mm of the chain are strained away before it hangs loose.
        const bool loose = data.length_deviations(0, k) > 0.003;
        EXPECT_EQ(data.statuses[k] == EquilibriumStatus::slack_mechanism, loose)
            << "sample " << k << " deviates by " << data.length_deviations(0, k) << " m";
    }
}

TEST(Sampler, GivesTheSameBitsOnOneThreadAndOnTwo) {
    const CableNet net = hypar(4, 5);
    const auto draw_on = [&net](int threads) {
        return with_threads(threads,
                            [&] { return draw(net, 60, {LengthPrior::Kind::uniform, 0.01}); });
    };
    expect_same(draw_on(1), draw_on(2));
}

TEST(Sampler, GivesTheSameBitsInOneCallAndInMany) {
    const CableNet net = hypar(4, 5);
    const Sampler sampler(net, uniform_5mm, 1);
    DataSet in_parts = sampler.no_samples();
    for (const int count : {1, 2, 17, 17, 4}) {
        sampler.extend_to(in_parts, count);
    }
    Sampler(net, uniform_5mm, 1).extend_to(in_parts, 40);  // another one goes on
    expect_same(in_parts, draw(net, 40));
}

TEST(Sampler, KeepsWholeBlocksWhenStoppedWhileItWorks) {
    const CableNet net = hypar(3, 4);
    const Sampler sampler(net, uniform_5mm, 1);
    DataSet data = draw(net, 10);
    std::vector<int> sizes;
    std::atomic<int> asked = 0;
    // After the first block, whose 16 samples ask once each, and not at the end of a later one.
    const Progress progress{.stop_requested = [&] { return ++asked > 100; }};
    EXPECT_THROW(sampler.extend_to(data, 300'000, progress, [&] { sizes.push_back(data.size()); }),
                 Interrupted);
    ASSERT_FALSE(sizes.empty());
    EXPECT_EQ(sizes.front(), 26);
    EXPECT_EQ(data.size(), sizes.back());
    EXPECT_LT(data.size(), 110);
    expect_same(data, draw(net, data.size()));
    sampler.extend_to(data, 120);
    expect_same(data, draw(net, 120));
}

TEST(Sampler, ReportsHowManySamplesThereAreUntilAllAre) {
    const CableNet net = hypar(3, 4);
    std::vector<int> reported;
    const Progress progress{.report = [&](std::string_view stage, int done, int total) {
        EXPECT_EQ(stage, "sampling");
        EXPECT_EQ(total, 50);
        reported.push_back(done);
    }};
    expect_same(draw_samples(Sampler(net, uniform_5mm, 1), 50, progress), draw(net, 50));
    ASSERT_GE(reported.size(), 3U);
    EXPECT_THAT(std::vector(reported.begin(), reported.begin() + 2), testing::ElementsAre(0, 16));
    EXPECT_EQ(std::ranges::adjacent_find(reported, std::ranges::greater_equal()), reported.end());
    EXPECT_EQ(reported.back(), 50);
}

TEST(Sampler, LeavesTheDataSetAsItWasWhereASampleCannotBeDrawn) {
    const CableNet net = hypar(3, 4);
    const Sampler sampler(net, uniform_5mm, 1);
    DataSet data = draw(net, 10);
    std::atomic<int> asked = 0;
    const Progress progress{.stop_requested = [&]() -> bool {
        if (++asked > 5) {
            throw std::domain_error("as a solver might");
        }
        return false;
    }};
    EXPECT_THROW(sampler.extend_to(data, 20, progress), std::domain_error);
    expect_same(data, draw(net, 10));
}

TEST(Sampler, BalancesTheLoadsOfANet) {
    const CableNet net = loaded(hypar(3, 4));
    const DataSet data = draw(net, 20);
    expect_balance(net, data);
    // The loads are not small: the form hangs below that of the net without them.
    EXPECT_LT(data.nominal_form(2), draw(hypar(3, 4), 0).nominal_form(2) - 1e-3);
}

TEST(Sampler, MeasuresDeviationsFromTheEquilibriumNotFromTheNodesOfTheFile) {
    const CableNet net = hypar(3, 4);
    CableNetData content = net.data();
    for (const int node : net.free_nodes()) {
        content.nodes.col(node) += Eigen::Vector3d(0.004, -0.003, 0.01);
    }
    const CableNet moved(content);
    const Sampler sampler(moved, uniform_5mm, 1);
    EXPECT_GT((sampler.nominal().form - moved.nodes()).cwiseAbs().maxCoeff(), 0.009);
    const DataSet data = draw(moved, 5);
    const DataSet expected = draw(net, 5);
    EXPECT_LT((data.nominal_form - expected.nominal_form).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((data.form_deviations - expected.form_deviations).cwiseAbs().maxCoeff(), 1e-9);
}

std::string refusal(const CableNet& net, const LengthPrior& of) {
    return test::refusal_of([&] { const Sampler sampler(net, of, 1); });
}

TEST(Sampler, RefusesAPriorThatReachesTheShortestInteriorLengthAndNamesBoth) {
    EXPECT_THAT(refusal(hypar(1, 1), uniform_5mm), testing::HasSubstr("no interior edge"));
    CableNetData content = hypar(3, 4).data();
    const int interior = hypar(3, 4).interior_edges()[5];
    content.unstressed_lengths(interior) = 0.1;
    const CableNet net(content);
    EXPECT_THAT(refusal(net, {LengthPrior::Kind::uniform, 0.1}),
                testing::AllOf(testing::HasSubstr("uniform:100mm"), testing::HasSubstr("100 mm")));
    EXPECT_THAT(refusal(net, {LengthPrior::Kind::normal, 0.02}),
                testing::AllOf(testing::HasSubstr("normal:20mm"), testing::HasSubstr("166 mm"),
                               testing::HasSubstr("100 mm")));
    EXPECT_EQ(refusal(net, {LengthPrior::Kind::uniform, 0.0999}), "not refused");
    // Adjustable edges may be shorter.
    content = hypar(3, 4).data();
    content.unstressed_lengths(content.adjustable.front()) = 0.05;
    EXPECT_EQ(refusal(CableNet(content), {LengthPrior::Kind::uniform, 0.06}), "not refused");
}

TEST(Sampler, RefusesANominalNetWithoutEquilibrium) {
    // Stiffnesses of thirty orders, and loads beside which the soft ones are nothing.
    CableNetData content = hypar(3, 4).data();
    content.loads.setConstant(3, content.nodes.cols(), 1e15);
    for (Eigen::Index e = 0; e < content.axial_stiffness.size(); ++e) {
        content.axial_stiffness(e) = std::pow(10.0, static_cast<double>(5 * e % 31) - 15.0);
    }
    test::expect_refused<std::runtime_error>(
        [&] { const Sampler sampler(CableNet(content), uniform_5mm, 1); },
        "nominal net finds no equilibrium");
}

TEST(SamplePart, JoinsToWhatOneCallDraws) {
    const CableNet net = hypar(5, 4);
    const Sampler sampler(net, uniform_5mm, 7);
    std::vector<SamplePart> parts;
    for (const int first : {12, 0, 5}) {
        parts.push_back(sampler.part(first, first == 5 ? 7 : 5));
    }
    expect_same(sampler.joined(parts), draw(net, 17, uniform_5mm, 7));
    expect_same(sampler.joined({}), sampler.no_samples());
    expect_same(sampler.joined({sampler.part(0, 2), sampler.part(0, 0), sampler.part(2, 3)}),
                draw(net, 5, uniform_5mm, 7));
}

TEST(SamplePart, ThatIsMissingDoubledOrAnothersIsRefused) {
    const CableNet net = hypar(5, 4);
    const Sampler sampler(net, uniform_5mm, 7);
    const auto refused = [&](const std::vector<SamplePart>& parts, const char* words) {
        test::expect_refused([&] { return sampler.joined(parts); }, words);
    };
    refused({sampler.part(0, 3), sampler.part(4, 2)}, "have sample 3 nowhere");
    refused({sampler.part(0, 3), sampler.part(2, 2)}, "have sample 2 twice");
    refused({Sampler(net, uniform_5mm, 8).part(0, 3)}, "another net, prior, seed or uncertain");
    SamplePart cut = sampler.part(0, 3);
    cut.samples.statuses.push_back(EquilibriumStatus::converged);
    EXPECT_THROW(static_cast<void>(sampler.joined({cut})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(sampler.part(-1, 3)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(sampler.part(2147483647, 1)), std::invalid_argument);
}

}  // namespace
