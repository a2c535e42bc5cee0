// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT

// Guards against a covariance of targets that is taken for its diagonal somewhere between survey
// and result. A frame that is turned moves the form and nothing else: noise that differs along x, y
// and z is correlated in the turned frame, and the lengths stay what they are.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "survey/covariance.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"

namespace taut {
namespace {

const Eigen::Vector3d along_axes(0.2e-3, 1.5e-3, 0.6e-3);  ///< standard deviations

CableNet turned(const CableNet& net, const Eigen::Matrix3d& R) {
    CableNetData data = net.data();
    data.nodes = R * data.nodes;
    return CableNet(data);
}

class CorrelatedNoise : public ::testing::Test {
protected:
    CorrelatedNoise() {
        Points errors = Points::Zero(3, m_net.node_count());
        test::add_noise(errors, m_net.free_nodes(), 1.0, 5);
        m_survey = test::simulate(m_net, m_prior, 0.0, 21).survey;
        m_survey.form += along_axes.asDiagonal() * errors;
        m_survey.noise_std(Eigen::all, m_net.free_nodes()).colwise() = along_axes;
        test::hide(m_net, m_survey, m_net.free_nodes()[4]);
        const PlaceNoise of_support = noise_of(R * turned_covariance() * R.transpose());
        for (const int node : m_net.supports()) {
            m_survey.supports.push_back(
                {.node = node, .position = m_net.nodes().col(node), .noise_std = along_axes});
        }
        m_turned = m_survey;
        m_turned.form = R * m_survey.form;
        for (const int node : m_net.free_nodes()) {
            m_turned.noise_std.col(node) = of_support.std_dev;
            m_turned.set_correlations(node, of_support.correlations);
        }
        for (SurveyedSupport& support : m_turned.supports) {
            support.position = R * support.position;
            support.noise_std = of_support.std_dev;
            support.noise_correlations = of_support.correlations;
        }
    }

    static Eigen::Matrix3d turned_covariance() { return along_axes.cwiseAbs2().asDiagonal(); }

    /// Both ways, each with its net.
    [[nodiscard]] std::pair<Identification, Identification> both(
        const IdentifyOptions& options) const {
        return {test::identify_lengths(m_net, m_survey, options),
                test::identify_lengths(m_turned_net, m_turned, options)};
    }

    void expect_the_same_lengths(const IdentifyOptions& options, double tolerance) const {
        const auto [straight, turned] = both(options);
        ASSERT_EQ(straight.edges.size(), turned.edges.size());
        for (size_t i = 0; i < straight.edges.size(); ++i) {
            const IdentifiedEdge& a = straight.edges[i];
            const IdentifiedEdge& b = turned.edges[i];
            EXPECT_NEAR(a.length_deviation, b.length_deviation, tolerance) << i;
            EXPECT_NEAR(a.std_dev, b.std_dev, tolerance) << i;
        }
        EXPECT_NEAR(straight.noise_ratio, turned.noise_ratio, 1e3 * tolerance);
        EXPECT_NEAR(straight.scales.noise.ratio, turned.scales.noise.ratio, 1e3 * tolerance);
        ASSERT_EQ(straight.outliers.size(), turned.outliers.size());
        for (size_t i = 0; i < straight.outliers.size(); ++i) {
            EXPECT_EQ(straight.outliers[i].node, turned.outliers[i].node);
            EXPECT_NEAR(straight.outliers[i].statistic, turned.outliers[i].statistic,
                        1e-3 * straight.outliers[i].statistic);
        }
    }

    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(0.9, Eigen::Vector3d(1.0, -2.0, 0.7).normalized()).toRotationMatrix();
    const CableNet m_net = hypar(4, 5);
    const CableNet m_turned_net = turned(m_net, R);
    const LengthPrior m_prior{LengthPrior::Kind::normal, 2e-3};
    Survey m_survey;
    Survey m_turned;
};

TEST_F(CorrelatedNoise, ATurnedFrameChangesNoLength) {
    expect_the_same_lengths({.prior = m_prior}, 1e-7);
    expect_the_same_lengths(
        {.prior = m_prior, .uncertain = {parse_uncertain_parameter("supports:1mm")}}, 1e-7);
    m_survey.frame_is_unknown = m_turned.frame_is_unknown = true;
    expect_the_same_lengths({.prior = m_prior}, 1e-7);
}

TEST_F(CorrelatedNoise, ItsDiagonalAloneIsAnotherSurvey) {
    m_turned.noise_correlations.setZero();
    const auto [straight, turned] = both({.prior = m_prior});
    EXPECT_GT((test::estimates(straight) - test::estimates(turned)).cwiseAbs().maxCoeff(), 2e-4);
}

TEST_F(CorrelatedNoise, AGrossErrorStandsOutAsMuchInATurnedFrame) {
    const int node = m_net.free_nodes()[9];
    const Eigen::Vector3d error(12e-3, 0.0, 3e-3);
    m_survey.form.col(node) += error;
    m_turned.form.col(node) += R * error;
    const auto [straight, turned] = both({.prior = m_prior});
    ASSERT_EQ(straight.outliers.size(), 1U);
    EXPECT_EQ(straight.outliers.front().node, node);
    expect_the_same_lengths({.prior = m_prior}, 1e-7);
}

// Draws are made anew in the turned frame: their spread is the same up to chance, some 4 % of it in
// the root mean square of so many edges.
TEST_F(CorrelatedNoise, DrawsSpreadAsMuchInATurnedFrame) {
    const auto [straight, turned] = both({.prior = m_prior, .draws = 200});
    ASSERT_TRUE(straight.draws && turned.draws);
    const auto spread = [](const Eigen::MatrixXd& draws) {
        const Eigen::MatrixXd centred = draws.colwise() - draws.rowwise().mean();
        return std::sqrt(centred.squaredNorm() / static_cast<double>(centred.size()));
    };
    EXPECT_NEAR(spread(turned.draws->length_deviations) / spread(straight.draws->length_deviations),
                1.0, 0.1);
    EXPECT_NEAR(spread(turned.draws->forms) / spread(straight.draws->forms), 1.0, 0.1);
}

}  // namespace
}  // namespace taut
