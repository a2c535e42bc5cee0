// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "../identification/simulated_survey.hpp"
#include "estimation/boundary_tests.hpp"
#include "estimation/survey_fit.hpp"
#include "taut/design/builtin_nets.hpp"

namespace {

using namespace taut;
using namespace taut::test;

constexpr LengthPrior prior{LengthPrior::Kind::normal, 0.002};
constexpr double noise = 0.5e-3;

/// A fit to a survey of a net whose boundary differs from the design.
struct Fitted {
    CableNet net;
    SimulatedSurvey simulated;
    SurveyFit fit;

    Fitted(const CableNet& designed, const CableNet& built, bool tested)
        : net(designed),
          simulated(simulate(built, prior, noise, 3)),
          fit(fit_survey(net, simulated.survey, PriorKnowledge(net, prior),
                         {.false_alarm_rate = tested ? default_false_alarm_rate : 0.0})) {}
};

CableNet with_length(const CableNet& net, int edge, double by) {
    CableNetData data = net.data();
    data.unstressed_lengths(edge) += by;
    return CableNet(data);
}

// The score predicts the estimate with the number free, apart from non-linearity.
TEST(BoundaryScore, IsThatOfTheFreeNumber) {
    const CableNet net = hypar(6, 6);
    const int edge = net.adjustable_edges()[5];
    const double off = 0.01;
    const Fitted held(net, with_length(net, edge, off), false);
    const Fitted freed(net, with_length(net, edge, off), true);
    const Linearisation::Score score = held.fit.at.linearisation.score_of_edge(
        edge, held.fit.at.covariance, held.fit.at.iterate, held.fit.observations);
    const double std_dev = 1.0 / std::sqrt(score.information(0, 0));
    const double estimate = score.gradient(0) / score.information(0, 0);
    const std::vector<BoundaryOutlier> found = boundary_outliers(freed.fit.hypotheses);
    ASSERT_EQ(found.size(), 1U) << estimate << " +- " << std_dev;
    EXPECT_EQ(found[0].kind, BoundaryOutlier::Kind::adjustable_edge);
    EXPECT_EQ(found[0].index, edge);
    EXPECT_NEAR(estimate, found[0].deviation.x(), 0.1 * off);
    EXPECT_NEAR(std_dev, found[0].std_dev.x(), 0.1 * std_dev);
    EXPECT_NEAR(found[0].deviation.x(), off, 4.0 * found[0].std_dev.x());
}

// A support with one edge takes no solution of its own, surveyed or not, beside common parameters.
TEST(BoundaryScore, OfASurveyedSupportIsThatOfTheFreePlace) {
    const CableNet net = hypar(6, 6);
    const int held = net.supports()[3];
    ASSERT_EQ(net.edges_at(held).size(), 1U);
    CableNetData moved = net.data();
    moved.nodes(2, held) += 0.004;
    const SimulatedSurvey simulated = simulate(CableNet(moved), prior, noise, 3);
    Survey survey = simulated.survey;
    for (const int node : net.supports()) {
        survey.supports.push_back({.node = node,
                                   .position = moved.nodes.col(node),
                                   .noise_std = Eigen::Vector3d::Constant(noise)});
    }
    for (const bool is_frame_unknown : {false, true}) {
        PriorKnowledge knowledge(net, prior);
        knowledge.uncertain = {parse_uncertain_parameter("stiffness:5%")};
        knowledge.frame_is_unknown = is_frame_unknown;
        const SurveyFit kept = fit_survey(net, survey, knowledge, {.false_alarm_rate = 0.0});
        const SurveyFit freed = fit_survey(net, survey, knowledge);
        const std::span<const int> edges = net.edges_at(held);
        const Linearisation::Score score = kept.at.linearisation.score_of_support(
            held, {edges.begin(), edges.end()}, kept.at.covariance, kept.at.iterate,
            kept.observations);
        const Eigen::Vector3d estimate = score.information.ldlt().solve(score.gradient);
        const std::vector<BoundaryOutlier> found = boundary_outliers(freed.hypotheses);
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].index, held);
        const Eigen::Matrix3d covariance = score.information.inverse();
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(estimate(k), found[0].deviation(k), 0.5 * found[0].std_dev(k));
            EXPECT_NEAR(std::sqrt(covariance(k, k)), found[0].std_dev(k),
                        0.1 * found[0].std_dev(k));
        }
    }
}

// Where supports have several edges nothing is short-cut: three solutions with the whole matrix.
TEST(BoundaryScore, OfASupportWithSeveralEdgesIsThatOfTheFreePlace) {
    const CableNet grid = hypar(6, 6);
    CableNetData data = grid.data();
    const int held = grid.free_nodes()[14];  // amid the net
    data.supports.push_back(held);
    const CableNet net(data);
    const auto edges_at = [&](int node) {
        std::vector<int> edges;
        for (int e = 0; e < net.edge_count(); ++e) {
            if (net.edges()[e][0] == node || net.edges()[e][1] == node) {
                edges.push_back(e);
            }
        }
        return edges;
    };
    ASSERT_EQ(edges_at(held).size(), 4U);
    CableNetData moved = net.data();
    moved.nodes(2, held) += 0.006;
    const Fitted kept(net, CableNet(moved), false);
    const Fitted freed(net, CableNet(moved), true);
    const Linearisation::Score score = kept.fit.at.linearisation.score_of_support(
        held, edges_at(held), kept.fit.at.covariance, kept.fit.at.iterate, kept.fit.observations);
    const Eigen::Vector3d estimate = score.information.ldlt().solve(score.gradient);
    const std::vector<BoundaryOutlier> found = boundary_outliers(freed.fit.hypotheses);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].kind, BoundaryOutlier::Kind::support);
    EXPECT_EQ(found[0].index, held);
    const Eigen::Matrix3d covariance = score.information.inverse();
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(found[0].deviation(k), k == 2 ? 0.006 : 0.0, 4.0 * found[0].std_dev(k));
        EXPECT_NEAR(estimate(k), found[0].deviation(k), 0.1 * 0.006 + 0.5 * found[0].std_dev(k));
        EXPECT_NEAR(std::sqrt(covariance(k, k)), found[0].std_dev(k), 0.1 * found[0].std_dev(k));
    }
}

}  // namespace
