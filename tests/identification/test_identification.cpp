// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against lengths that are not those of the surveyed net, and against more certainty than
// there is: intervals too narrow, an edge called identified that the survey does not show.

#include "taut/identification/identify.hpp"
#include "taut/identification/length_estimates.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "support/identify_lengths.hpp"
#include "support/refusals.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/statics/energy.hpp"
#include "taut/statics/tensions.hpp"

namespace {

using namespace taut;

std::vector<int> first(int count) {
    std::vector<int> samples(count);
    std::iota(samples.begin(), samples.end(), 0);
    return samples;
}

/// A small net, samples of it, and a model trained on all but the last of these.
class OnASmallNet : public testing::Test {
protected:
    static constexpr int training = 150;
    static constexpr int validation = 50;

    explicit OnASmallNet(const LengthPrior& prior = {LengthPrior::Kind::uniform, 0.002})
        : m_data(Sampler(m_net, prior, 1).no_samples()) {
        Sampler(m_net, prior, 1).extend_to(m_data, training + validation);
        m_model = train_model(m_net, m_data, first(training), TrainingSettings::paper());
    }

    /// The form of a sample as a survey without noise.
    [[nodiscard]] Survey survey_of(int sample) const {
        return {.form = with_free_coordinates(
                    m_net, m_data.nominal_form + m_data.form_deviations.col(sample)),
                .surveyed = m_net.free_nodes(),
                .missing = {}};
    }

    [[nodiscard]] Identification identify(int sample) const {
        return test::identify_lengths(m_net, survey_of(sample), {.model = &m_model});
    }

    const CableNet m_net = hypar(3, 4);
    DataSet m_data;
    LengthModel m_model;
};

TEST_F(OnASmallNet, TheErrorsAreAFewStandardDeviations) {
    int edges = 0;
    int inside = 0;
    for (int k = training; k < training + validation; ++k) {
        for (const IdentifiedEdge& e : identify(k).edges) {
            const double truth = m_data.length_deviations(edges++ % m_net.interior_edge_count(), k);
            EXPECT_LT(std::abs(e.length_deviation - truth), 7.0 * e.std_dev)
                << "edge " << e.edge << ", sample " << k;
            inside += e.lower <= truth && truth <= e.upper ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 0.90 * edges);
    EXPECT_LT(inside, 0.99 * edges);
}

TEST_F(OnASmallNet, ThePredictedFormIsInEquilibriumWithTheIdentifiedLengths) {
    const Survey survey = survey_of(training);
    const Identification result = identify(training);
    Eigen::VectorXd lengths = m_net.unstressed_lengths();
    for (const IdentifiedEdge& e : result.edges) {
        EXPECT_EQ(e.nominal, m_net.unstressed_lengths()(e.edge));
        EXPECT_LT(e.std_dev, 0.2 * m_model.prior.std_dev()) << "edge " << e.edge;
        EXPECT_EQ(e.status, EdgeStatus::determined);
        lengths(e.edge) += e.length_deviation;
    }
    for (int i = 0; i < m_net.free_node_count(); ++i) {
        const int node = survey.surveyed[i];
        EXPECT_DOUBLE_EQ(result.residuals(i),
                         (result.predicted.form.col(node) - survey.form.col(node)).norm());
    }
    EXPECT_TRUE(result.predicted.balanced());
    EXPECT_LT(out_of_balance_forces(m_net, lengths, result.predicted.form).cwiseAbs().maxCoeff(),
              1e-9 * tensions_of(m_net, lengths, result.predicted.form).mean());
}

TEST_F(OnASmallNet, TheEstimatesAreThePosteriorWithTheNoiseOfEachProcess) {
    const Eigen::MatrixXd at = m_data.form_deviations.rightCols(3);
    const gp::Prediction posterior = m_model.processes.predict(at);
    const LengthEstimates estimates = estimate_lengths(m_net, m_model, at);
    EXPECT_EQ(estimates.mean, posterior.mean);
    ASSERT_EQ(estimates.std_dev.rows(), m_net.interior_edge_count());
    ASSERT_EQ(estimates.std_dev.cols(), 3);
    for (int i = 0; i < m_net.interior_edge_count(); ++i) {
        const double noise = m_model.processes.processes[i].hyperparameters.noise_std;
        for (int k = 0; k < 3; ++k) {
            EXPECT_DOUBLE_EQ(estimates.std_dev(i, k), std::hypot(posterior.std_dev(i, k), noise));
        }
    }
}

TEST_F(OnASmallNet, IdentificationIsTheEstimateForOneForm) {
    const LengthEstimates estimates =
        estimate_lengths(m_net, m_model, m_data.form_deviations.rightCols(1));
    const Identification result = identify(training + validation - 1);
    for (size_t i = 0; i < result.edges.size(); ++i) {
        // The survey is nominal form plus deviation: rounded once more.
        EXPECT_NEAR(result.edges[i].length_deviation, estimates.mean(static_cast<int>(i), 0), 1e-9);
        const IdentifiedEdge& e = result.edges[i];
        EXPECT_NEAR(e.std_dev, estimates.std_dev(static_cast<int>(i), 0), 1e-9);
        EXPECT_NEAR(e.upper - e.length_deviation, half_interval_95 * e.std_dev, 1e-12);
        EXPECT_NEAR(e.length_deviation - e.lower, half_interval_95 * e.std_dev, 1e-12);
    }
}

TEST_F(OnASmallNet, AnEdgeThatNeverDeviatedInTrainingIsNotDeterminedAndAsUncertainAsThePrior) {
    constexpr int constant = 4;
    m_data.length_deviations.row(constant).setZero();
    m_model = train_model(m_net, m_data, first(training), TrainingSettings::paper());
    const Identification result = identify(training);
    for (size_t i = 0; i < result.edges.size(); ++i) {
        const IdentifiedEdge& e = result.edges[i];
        EXPECT_EQ(e.status, i == constant ? EdgeStatus::not_determined : EdgeStatus::determined)
            << "edge " << e.edge;
        if (i == constant) {
            EXPECT_EQ(e.length_deviation, 0.0);
            EXPECT_DOUBLE_EQ(e.std_dev, m_data.prior.std_dev());
        }
    }
}

TEST_F(OnASmallNet, AModelForAnotherNetIsRefusedAndBothAreNamed) {
    CableNetData content = m_net.data();
    content.unstressed_lengths(m_net.interior_edges()[0]) += 1e-9;
    const CableNet other(content);
    const std::string message = test::refusal_of(
        [&] { return test::identify_lengths(other, survey_of(training), {.model = &m_model}); });
    EXPECT_THAT(message, testing::AllOf(testing::HasSubstr(m_net.fingerprint()),
                                        testing::HasSubstr(other.fingerprint())));
}

TEST_F(OnASmallNet, ASurveyThatMissesAFreeNodeIsRefusedAndTheNodeIsNamed) {
    Survey survey = survey_of(training);
    const int missing = survey.surveyed[3];
    survey.missing = {missing};
    survey.surveyed.erase(survey.surveyed.begin() + 3);
    const std::string message = test::refusal_of(
        [&] { return test::identify_lengths(m_net, survey, {.model = &m_model}); });
    EXPECT_THAT(message, testing::AllOf(testing::HasSubstr("11 of 12"),
                                        testing::HasSubstr("'" + std::to_string(missing) + "'")));
}

/// Deviations so large that some edges are slack.
class WithSlackEdges : public OnASmallNet {
protected:
    WithSlackEdges() : OnASmallNet({LengthPrior::Kind::uniform, 0.008}) {}
};

TEST_F(WithSlackEdges, TheSlackOnesOfThePredictedFormAreMarkedAndNoOthers) {
    int marked = 0;
    for (int k = training; k < training + validation; ++k) {
        const Identification result = identify(k);
        Eigen::VectorXd lengths = m_net.unstressed_lengths();
        for (const IdentifiedEdge& e : result.edges) {
            lengths(e.edge) += e.length_deviation;
        }
        const Eigen::VectorXd edge_tensions = tensions_of(m_net, lengths, result.predicted.form);
        for (const IdentifiedEdge& e : result.edges) {
            EXPECT_EQ(e.status == EdgeStatus::slack, edge_tensions(e.edge) == 0.0)
                << "edge " << e.edge << ", sample " << k;
            marked += e.status == EdgeStatus::slack ? 1 : 0;
        }
    }
    EXPECT_GT(marked, 5);
}

}  // namespace
