// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numeric>

#include "identification/simulated_survey.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/statics/form_sensitivity.hpp"

namespace taut {
namespace {

constexpr double noise = 0.0002;
const LengthPrior normal_prior{LengthPrior::Kind::normal, 0.001};

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
    const Identification found = identify(m_net, m_site.survey, m_options);
    ASSERT_EQ(found.status, IdentificationStatus::converged);
    ASSERT_TRUE(found.length_covariance);
    EXPECT_EQ(found.length_covariance->edges, m_net.interior_edges());

    // (J' S J + I / prior^2)^-1, dense, with J of the rows that were surveyed.
    Eigen::VectorXd deviations(m_net.interior_edge_count());
    for (Eigen::Index i = 0; i < deviations.size(); ++i) {
        deviations(i) = found.edges[i].length_deviation;
    }
    const FormSensitivity sensitivity(m_net, with_length_deviations(m_net, deviations),
                                      found.predicted.form);
    const Eigen::MatrixXd all = sensitivity.columns(m_net.interior_edges());
    Eigen::MatrixXd rows(3 * m_site.survey.surveyed.size(), all.cols());
    for (size_t k = 0; k < m_site.survey.surveyed.size(); ++k) {
        const int place = m_net.free_index(m_site.survey.surveyed[k]);
        rows.middleRows<3>(3 * static_cast<Eigen::Index>(k)) = all.middleRows<3>(3 * place);
    }
    const Eigen::MatrixXd information = rows.transpose() * rows / (noise * noise) +
                                        Eigen::MatrixXd::Identity(all.cols(), all.cols()) /
                                            (normal_prior.std() * normal_prior.std());
    const Eigen::MatrixXd expected = information.inverse();
    const double largest = expected.diagonal().maxCoeff();
    EXPECT_LT((found.length_covariance->covariance - expected).cwiseAbs().maxCoeff(),
              0.01 * largest);
    // Two edges of the hidden node are correlated: a matrix of variances alone would not do.
    const Eigen::MatrixXd scaled = expected.diagonal().cwiseSqrt().cwiseInverse().asDiagonal() *
                                   expected *
                                   expected.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
    EXPECT_GT((scaled - Eigen::MatrixXd::Identity(all.cols(), all.cols())).cwiseAbs().maxCoeff(),
              0.3);
}

TEST_F(LengthCovariances, HaveTheReportedVariancesInTheOrderAskedFor) {
    m_options.prior = LengthPrior{LengthPrior::Kind::uniform, 0.001};
    const std::vector<int>& interior = m_net.interior_edges();
    m_options.covariance_of = {interior[7], interior[2]};
    const Identification found = identify(m_net, m_site.survey, m_options);
    ASSERT_TRUE(found.length_covariance);
    const Eigen::MatrixXd& covariance = found.length_covariance->covariance;
    EXPECT_NEAR(std::sqrt(covariance(0, 0)), found.edges[7].std, 1e-12);
    EXPECT_NEAR(std::sqrt(covariance(1, 1)), found.edges[2].std, 1e-12);
    EXPECT_EQ(covariance(0, 1), covariance(1, 0));
}

TEST_F(LengthCovariances, AreRefusedOfOtherEdgesAndMethods) {
    const int adjustable = m_net.adjustable_edges().front();
    const int interior = m_net.interior_edges().front();
    for (const std::vector<int>& edges :
         {std::vector{adjustable}, {-1}, {m_net.edge_count()}, {interior, interior}}) {
        m_options.covariance_of = edges;
        EXPECT_THROW((void)identify(m_net, m_site.survey, m_options), std::invalid_argument);
    }
    m_options.covariance_of = {interior};
    m_options.method = IdentificationMethod::balance;
    EXPECT_THROW((void)identify(m_net, m_site.survey, m_options), std::invalid_argument);
}

}  // namespace
}  // namespace taut
