// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lengths and places that are reported as better or worse known than the survey
// leaves them.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "identification/simulated_survey.hpp"
#include "support/dense_posterior.hpp"
#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {
namespace {

constexpr double noise = 0.0002;
const LengthPrior normal_prior{LengthPrior::Kind::normal, 0.001};

double largest_correlation(const Eigen::MatrixXd& covariance) {
    const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd correlations = scale.asDiagonal() * covariance * scale.asDiagonal();
    correlations.diagonal().setZero();
    return correlations.cwiseAbs().maxCoeff();
}

class LengthCovariances : public ::testing::Test {
protected:
    LengthCovariances() {
        m_options = {
            .method = IdentificationMethod::map, .prior = normal_prior, .prior_exact = true};
    }

    CableNet m_net = hypar(5, 5);
    test::SimulatedSurvey m_site = test::simulate(m_net, normal_prior, noise, 3);
    IdentifyOptions m_options;
};

TEST_F(LengthCovariances, AreThoseOfTheLinearModelOfFormAndLengths) {
    test::hide(m_net, m_site.survey, m_net.free_nodes()[4]);
    m_options.covariance_of = m_net.interior_edges();
    const Identification found = test::identify_lengths(m_net, m_site.survey, m_options);
    ASSERT_EQ(found.status, IdentificationStatus::converged);
    ASSERT_TRUE(found.length_covariance);
    EXPECT_EQ(found.length_covariance->edges, m_net.interior_edges());

    const Eigen::MatrixXd expected =
        test::dense_posterior(m_net, with_length_deviations(m_net, test::estimates(found)),
                              found.predicted.form, m_site.survey, normal_prior);
    const double largest = expected.diagonal().maxCoeff();
    EXPECT_LT((found.length_covariance->covariance - expected).cwiseAbs().maxCoeff(),
              0.01 * largest);
    // Two edges of the hidden node are correlated: a matrix of variances alone would not do.
    EXPECT_GT(largest_correlation(expected), 0.3);
}

TEST_F(LengthCovariances, HaveTheReportedVariancesInTheOrderAskedFor) {
    m_options.prior = LengthPrior{LengthPrior::Kind::uniform, 0.001};
    const std::vector<int>& interior = m_net.interior_edges();
    m_options.covariance_of = {interior[7], interior[2]};
    const Identification found = test::identify_lengths(m_net, m_site.survey, m_options);
    ASSERT_TRUE(found.length_covariance);
    const Eigen::MatrixXd& covariance = found.length_covariance->covariance;
    EXPECT_NEAR(std::sqrt(covariance(0, 0)), found.edges[7].std_dev, 1e-12);
    EXPECT_NEAR(std::sqrt(covariance(1, 1)), found.edges[2].std_dev, 1e-12);
    EXPECT_EQ(covariance(0, 1), covariance(1, 0));
}

TEST_F(LengthCovariances, AreRefusedOfOtherEdgesAndMethods) {
    const int adjustable = m_net.adjustable_edges().front();
    const int interior = m_net.interior_edges().front();
    for (const std::vector<int>& edges :
         {std::vector{adjustable}, {-1}, {m_net.edge_count()}, {interior, interior}}) {
        m_options.covariance_of = edges;
        EXPECT_THROW((void)test::identify_lengths(m_net, m_site.survey, m_options),
                     std::invalid_argument);
    }
    m_options.covariance_of = {interior};
    m_options.method = IdentificationMethod::balance;
    EXPECT_THROW((void)test::identify_lengths(m_net, m_site.survey, m_options),
                 std::invalid_argument);
}

class FormCovariances : public ::testing::Test {
protected:
    FormCovariances() {
        m_options = {
            .method = IdentificationMethod::map, .prior = normal_prior, .prior_exact = true};
        test::hide(m_net, m_site.survey, m_hidden);
    }

    CableNet m_net = hypar(5, 6);
    int m_hidden = m_net.free_nodes()[1];
    test::SimulatedSurvey m_site = test::simulate(m_net, normal_prior, noise, 3);
    IdentifyOptions m_options;
};

double largest_std(const Eigen::Matrix3d& covariance) {
    return std::sqrt(
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues().maxCoeff());
}

TEST_F(FormCovariances, AreThoseOfTheLinearModelOfFormAndLengthsWithoutSamples) {
    const Identification found = test::identify_lengths(m_net, m_site.survey, m_options);
    ASSERT_EQ(found.form_covariance.size(), static_cast<size_t>(m_net.node_count()));

    const Eigen::VectorXd lengths = with_length_deviations(m_net, test::estimates(found));
    const Eigen::MatrixXd J =
        FormSensitivity(m_net, lengths, found.predicted.form).columns(m_net.interior_edges());
    const Eigen::MatrixXd expected =
        J *
        test::dense_posterior(m_net, lengths, found.predicted.form, m_site.survey, normal_prior) *
        J.transpose();
    for (int i = 0; i < m_net.free_node_count(); ++i) {
        const Eigen::Matrix3d of_node = expected.block<3, 3>(3 * i, 3 * i);
        const Eigen::Matrix3d& reported = found.form_covariance[m_net.free_nodes()[i]];
        EXPECT_LT((reported - of_node).norm(), 0.03 * of_node.norm()) << i;
    }
    // Standard deviations of coordinates alone would not do: some are correlated.
    EXPECT_GT(largest_correlation(found.form_covariance[m_hidden]), 0.2);
    for (const int support : m_net.supports()) {
        EXPECT_TRUE(found.form_covariance[support].isZero(0.0));
    }
}

TEST_F(FormCovariances, AreThoseOfTheSamplesWhereThereAreEnough) {
    const Identification linearised = test::identify_lengths(m_net, m_site.survey, m_options);
    m_options.draws = 20;
    const Identification few = test::identify_lengths(m_net, m_site.survey, m_options);
    m_options.draws = 300;
    const Identification many = test::identify_lengths(m_net, m_site.survey, m_options);
    ASSERT_TRUE(many.draws && many.draws->reason.empty());
    for (int i = 0; i < m_net.free_node_count(); ++i) {
        const int node = m_net.free_nodes()[i];
        EXPECT_EQ(few.form_covariance[node], linearised.form_covariance[node]);
        const Eigen::MatrixXd places = many.draws->forms.middleRows<3>(3 * i);
        const Eigen::MatrixXd centred = places.colwise() - places.rowwise().mean();
        const Eigen::Matrix3d expected = centred * centred.transpose() / (300.0 - 1.0);
        EXPECT_LT((many.form_covariance[node] - expected).norm(), 1e-9 * expected.norm());
        EXPECT_NEAR(
            largest_std(many.form_covariance[node]) / largest_std(linearised.form_covariance[node]),
            1.0, 0.2);
    }
    const DrawnPlace& place = many.drawn.missing.front();
    EXPECT_EQ(place.node, m_hidden);
    EXPECT_LT((many.form_covariance[m_hidden].diagonal().cwiseSqrt() - place.std_dev).norm(), 1e-9);
}

TEST_F(FormCovariances, HaveSupportsThatAreUncertainOrInAFrameThatIs) {
    const int support = m_net.supports().front();
    m_options.uncertain = {parse_uncertain_parameter("supports:1mm")};
    const Identification uncertain = test::identify_lengths(m_net, m_site.survey, m_options);
    EXPECT_GT(largest_std(uncertain.form_covariance[support]), 0.1e-3);
    EXPECT_LT(largest_std(uncertain.form_covariance[support]), 1.3e-3);
    m_options.uncertain = {};
    m_site.survey.frame_is_unknown = true;
    const Identification moved = test::identify_lengths(m_net, m_site.survey, m_options);
    EXPECT_GT(largest_std(moved.form_covariance[support]), 0.01 * noise);
    EXPECT_LT(largest_std(moved.form_covariance[support]), 2.0 * noise);
}

TEST_F(FormCovariances, OfAMixtureOfPriorsAreNoLessThanOfItsParts) {
    m_options.prior_exact = false;
    m_options.prior.reset();
    const Identification found = test::identify_lengths(m_net, m_site.survey, m_options);
    ASSERT_GT(found.prior.nodes.size(), 1U);
    ASSERT_EQ(found.form_covariance.size(), static_cast<size_t>(m_net.node_count()));
    for (const int node : m_net.free_nodes()) {
        EXPECT_GT(largest_std(found.form_covariance[node]), 0.3 * noise);
        EXPECT_LT(largest_std(found.form_covariance[node]),
                  node == m_hidden ? 20.0 * noise : noise);
    }
}

TEST_F(FormCovariances, AreNotReportedOfMethodsThatHaveNone) {
    m_options.method = IdentificationMethod::balance;
    const test::SimulatedSurvey whole = test::simulate(m_net, normal_prior, 0.0, 3);
    EXPECT_TRUE(test::identify_lengths(m_net, whole.survey, m_options).form_covariance.empty());
}

}  // namespace
}  // namespace taut
