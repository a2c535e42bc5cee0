// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a study whose numbers are too good: training on validation samples, numbers of
// other samples than it says, an experiment that cannot be repeated.

#include "taut/study/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "study/error_sums.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/statics/equilibrium.hpp"

namespace {

using namespace taut;

const StudySettings small{
    .samples = 60, .validation = 12, .prior = {LengthPrior::Kind::uniform, 0.004}, .seed = 3};

class SmallStudy : public testing::Test {
protected:
    const CableNet m_net = hypar(4, 5);
    const Study& m_study = the_study();

    /// Run once for all tests.
    static const Study& the_study() {
        static const Study study = run_study(hypar(4, 5), small);
        return study;
    }
    [[nodiscard]] Eigen::MatrixXd truth() const {
        return m_study.data.length_deviations(Eigen::all, m_study.validation);
    }
};

TEST_F(SmallStudy, DrawsTheSamplesOfItsPriorAndSeed) {
    const Sampler sampler(m_net, small.prior, small.seed);
    DataSet data = sampler.no_samples();
    sampler.extend_to(data, small.samples);
    EXPECT_EQ(m_study.data.length_deviations, data.length_deviations);
    EXPECT_EQ(m_study.data.form_deviations, data.form_deviations);
    EXPECT_EQ(m_study.settings.samples, 60);
    EXPECT_EQ(m_study.net.fingerprint(), m_net.fingerprint());
}

TEST_F(SmallStudy, ValidatesOnTheLastSamplesAndTrainsOnAllOthers) {
    ASSERT_EQ(m_study.data.not_converged(), 0);
    EXPECT_THAT(m_study.validation,
                testing::ElementsAre(48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59));
    EXPECT_EQ(m_study.model.training_count(), 48);
    EXPECT_EQ(m_study.model.processes.inputs, m_study.data.form_deviations.leftCols(48));
}

TEST_F(SmallStudy, IsTheModelTrainedOnTheTrainingSamples) {
    const Eigen::MatrixXd validation = m_study.data.form_deviations.rightCols(12);
    const LengthEstimates own = estimate_lengths(m_study.net, m_study.model, validation);
    EXPECT_LT((m_study.estimates.mean - own.mean).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((m_study.estimates.std_dev - own.std_dev).cwiseAbs().maxCoeff(), 1e-12);
    // Trained by itself, it chooses other lambdas that are about as likely.
    const LengthModel alone = train_model(
        m_study.net, m_study.data, m_study.data.converged_in(0, 48), TrainingSettings::paper());
    const LengthEstimates expected = estimate_lengths(m_study.net, alone, validation);
    const double std_dev = expected.std_dev.mean();
    EXPECT_LT((own.mean - expected.mean).norm() / std::sqrt(own.mean.size()), 0.1 * std_dev);
    EXPECT_LT((own.std_dev - expected.std_dev).norm() / std::sqrt(own.std_dev.size()),
              0.1 * std_dev);
}

TEST_F(SmallStudy, ReportsTheErrorsOfItsEstimates) {
    const LengthErrors expected = length_errors(truth(), m_study.estimates.mean);
    const LengthErrors& errors = m_study.as_in_paper().errors;
    EXPECT_EQ(m_study.as_in_paper().name, "gp_as_in_paper");
    EXPECT_EQ(errors.mse, expected.mse);
    EXPECT_EQ(errors.mrse, expected.mrse);
    EXPECT_EQ(errors.mean, expected.mean);
    EXPECT_EQ(errors.std_dev, expected.std_dev);
    // It learnt something: guessing zero throughout has the relative error one.
    EXPECT_LT(errors.mrse, 0.1);
    EXPECT_GT(errors.mrse, 0.0);
}

TEST_F(SmallStudy, TriesEveryMethodOnTheSameSamples) {
    std::vector<std::string> names;
    for (const MethodResult& method : m_study.methods) {
        names.push_back(method.name);
        EXPECT_EQ(method.surveys, 12);
        EXPECT_EQ(method.failed, 0) << method.first_failure;
    }
    EXPECT_THAT(names, testing::ElementsAre("gp_as_in_paper", "gp", "balance", "map"));
    EXPECT_LT(m_study.methods[2].mse_of_taut, 1e-20);
    EXPECT_LT(m_study.methods[3].mse_of_taut, 1e-14);
}

/// Form errors with the lengths identified from validation sample k, found anew.
Eigen::VectorXd identified_form_error(const Study& study, int k) {
    const CableNet& net = study.net;
    const Equilibrium predicted = EquilibriumSolver(net).solve(
        with_length_deviations(net, study.estimates.mean.col(k)), net.nodes());
    return node_distances(
        study.data.nominal_form + study.data.form_deviations.col(study.validation[k]),
        free_coordinates(net, predicted.form));
}

TEST_F(SmallStudy, ReportsTheFormErrorsOfTheFirstValidationSample) {
    const Eigen::VectorXd nominal =
        node_distances(m_study.data.nominal_form + m_study.data.form_deviations.col(48),
                       m_study.data.nominal_form);
    EXPECT_LT((m_study.nominal_form_error - nominal).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_DOUBLE_EQ(m_study.form_errors.nominal.rmse, summarise(nominal).rmse);
    const Eigen::VectorXd identified = identified_form_error(m_study, 0);
    EXPECT_LT((m_study.identified_form_error - identified).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_NEAR(m_study.form_errors.identified.max, identified.maxCoeff(), 1e-10);
    EXPECT_LT(m_study.form_errors.identified.mean, 0.3 * m_study.form_errors.nominal.mean);
}

TEST_F(SmallStudy, ReportsTheMeanFormErrorsOfAllValidationSamples) {
    FormErrors mean;
    const auto count = static_cast<int>(m_study.validation.size());
    for (int k = 0; k < count; ++k) {
        const FormErrorSummary identified = summarise(identified_form_error(m_study, k));
        const FormErrorSummary nominal =
            summarise(node_distances(m_study.data.form_deviations.col(m_study.validation[k]),
                                     Eigen::VectorXd::Zero(3 * m_net.free_node_count())));
        mean.identified.mean += identified.mean / count;
        mean.identified.max += identified.max / count;
        mean.identified.min += identified.min / count;
        mean.identified.rmse += identified.rmse / count;
        mean.nominal.mean += nominal.mean / count;
        mean.nominal.max += nominal.max / count;
        mean.nominal.min += nominal.min / count;
        mean.nominal.rmse += nominal.rmse / count;
    }
    const auto expect_near = [](const FormErrorSummary& a, const FormErrorSummary& b) {
        EXPECT_NEAR(a.max, b.max, 1e-10);
        EXPECT_NEAR(a.min, b.min, 1e-10);
        EXPECT_NEAR(a.mean, b.mean, 1e-10);
        EXPECT_NEAR(a.rmse, b.rmse, 1e-10);
    };
    EXPECT_EQ(m_study.as_in_paper().forms_not_converged, 0);
    expect_near(m_study.mean_form_errors.nominal, mean.nominal);
    expect_near(m_study.mean_form_errors.identified, mean.identified);
}

TEST_F(SmallStudy, GivesTheSameNumbersForTheSameSeed) {
    const Study again = run_study(m_net, small);
    EXPECT_EQ(again.as_in_paper().errors.mse, m_study.as_in_paper().errors.mse);
    EXPECT_EQ(again.estimates.mean, m_study.estimates.mean);
    EXPECT_EQ(again.identified_form_error, m_study.identified_form_error);
}

TEST(Study, ReportsItsStagesInOrderAndToTheirEnd) {
    std::vector<std::string> stages;
    int last_done = -1;
    int last_total = 0;
    const auto tell = [&](std::string_view stage, int done, int total) {
        if (stages.empty() || stages.back() != stage) {
            stages.emplace_back(stage);
            last_done = -1;
        }
        EXPECT_GT(done, last_done) << stage;
        EXPECT_LE(done, total) << stage;
        EXPECT_EQ(stage != "sampling" || total == 60, true);
        last_done = done;
        last_total = total;
    };
    (void)run_study(hypar(4, 5), small, {.report = tell});
    EXPECT_THAT(stages, testing::ElementsAre("sampling", "training", "identification"));
    EXPECT_EQ(last_done, last_total);
}

class StoppedIn : public testing::TestWithParam<std::string> {};

TEST_P(StoppedIn, GivesUp) {
    std::atomic<bool> stop = false;
    const auto tell = [&](std::string_view stage, int, int) {
        EXPECT_LE(stage == "identification" ? 2
                  : stage == "training"     ? 1
                                            : 0,
                  GetParam() == "identification" ? 2
                  : GetParam() == "training"     ? 1
                                                 : 0)
            << "went on to " << stage;
        if (stage == GetParam()) {
            stop = true;
        }
    };
    const Progress progress{.report = tell, .stop_requested = [&] { return stop.load(); }};
    EXPECT_THROW((void)run_study(hypar(4, 5), small, progress), Interrupted);
}

INSTANTIATE_TEST_SUITE_P(Stages, StoppedIn,
                         testing::Values("sampling", "training", "identification"),
                         [](const auto& stage) { return stage.param; });

std::string refusal(const StudySettings& settings) {
    try {
        settings.check();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

TEST(StudySettings, RefuseTooFewSamples) {
    EXPECT_EQ(refusal({}), "not refused");
    EXPECT_EQ(refusal({.samples = 3, .validation = 1}), "not refused");
    EXPECT_EQ(refusal({.samples = 10, .validation = 8}), "not refused");
    EXPECT_THAT(refusal({.samples = 2, .validation = 1}),
                testing::HasSubstr("2 samples, expected at least 3"));
    for (const int validation : {-1, 0, 9, 2'000'000'000}) {
        EXPECT_THAT(refusal({.samples = 10, .validation = validation}),
                    testing::HasSubstr(std::to_string(validation) + " validation samples of 10"));
    }
    EXPECT_THAT(refusal({.prior = {LengthPrior::Kind::bimodal, 0.0}}),
                testing::HasSubstr("bimodal prior"));
}

TEST(Study, ChecksItsSettingsBeforeItBegins) {
    const Progress must_not_be_called{.report = [](std::string_view, int, int) { FAIL(); }};
    EXPECT_THROW((void)run_study(hypar(4, 5), {.samples = 0}, must_not_be_called),
                 std::invalid_argument);
    EXPECT_THROW((void)run_study(hypar(4, 5), {.prior = {LengthPrior::Kind::uniform, 1.0}},
                                 must_not_be_called),
                 std::invalid_argument);
}

TEST(Study, RunsWithTheFewestSamples) {
    const Study study = run_study(hypar(2, 2), {.samples = 3, .validation = 1});
    EXPECT_EQ(study.model.training_count(), 2);
    EXPECT_THAT(study.validation, testing::ElementsAre(2));
}

}  // namespace
