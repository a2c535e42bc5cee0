// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a confident answer where the survey is not what it was taken for, or the options
// contradict each other: what a user of the library gets must be what the program reports.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "identification/simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "support/refusals.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"

namespace of_identify {

using namespace taut;
using ::testing::HasSubstr;

constexpr LengthPrior prior{LengthPrior::Kind::uniform, 0.002};

class Identify : public ::testing::Test {
protected:
    static LengthModel model_of(const CableNet& net, const TrainingSettings& settings) {
        const Sampler sampler(net, prior, 1);
        const DataSet data = draw_samples(sampler, 80);
        return train_model(net, data, data.converged_in(0, 80), settings);
    }

    /// Half a millimetre of noise that is not given.
    [[nodiscard]] Survey marked_exact() const {
        Survey survey = test::simulate(m_net, prior, 0.0005, 3).survey;
        survey.noise_std.setZero();
        return survey;
    }

    void expect_misuse(const Survey& survey, const IdentifyOptions& options,
                       const char* words) const {
        test::expect_refused([&] { return test::identify_lengths(m_net, survey, options); }, words);
    }

    const CableNet m_net = hypar(5, 5);
};

TEST_F(Identify, ChoosesTheMethodThatSuitsTheSurveyAndSaysWhy) {
    const Survey exact = test::simulate(m_net, prior, 0.0, 3).survey;
    Survey noisy = test::simulate(m_net, prior, 0.0005, 3).survey;
    const Identification balance = test::identify_lengths(m_net, exact, {.prior = prior});
    EXPECT_EQ(balance.method, "balance");
    EXPECT_THAT(balance.method_reason, HasSubstr("the survey is exact"));
    EXPECT_EQ(test::identify_lengths(m_net, noisy, {.prior = prior}).method, "map");
    test::hide(m_net, noisy, m_net.free_nodes()[2]);
    const Identification map = test::identify_lengths(m_net, noisy, {.prior = prior});
    EXPECT_EQ(map.method, "map");
    EXPECT_THAT(map.method_reason, HasSubstr("1 free nodes were not surveyed"));
    const LengthModel model = model_of(m_net, {});
    const Identification gp = test::identify_lengths(m_net, noisy, {.model = &model});
    EXPECT_EQ(gp.method, "gp");
    EXPECT_EQ(gp.length_prior, prior);
}

TEST_F(Identify, SaysSoWhereASurveyMarkedExactIsNot) {
    const LengthModel model = model_of(m_net, {});
    const LengthModel paper = model_of(m_net, TrainingSettings::paper());
    for (const IdentifyOptions& options :
         {IdentifyOptions{.method = IdentificationMethod::balance, .prior = prior},
          IdentifyOptions{.method = IdentificationMethod::map, .prior = prior},
          IdentifyOptions{.model = &model}, IdentifyOptions{.model = &paper}}) {
        const Identification found = test::identify_lengths(m_net, marked_exact(), options);
        EXPECT_EQ(found.status, IdentificationStatus::survey_not_exact) << found.method;
        EXPECT_THAT(found.message, HasSubstr("is given as exact"));
    }
}

TEST_F(Identify, RefusesAnExactSurveyThatMissesNodes) {
    Survey exact = test::simulate(m_net, prior, 0.0, 3).survey;
    test::hide(m_net, exact, m_net.free_nodes()[2]);
    expect_misuse(exact, {.prior = prior}, "expected all, or their noise");
    expect_misuse(exact, {.method = IdentificationMethod::balance, .prior = prior},
                  "expected all for the method balance");
}

TEST_F(Identify, RefusesPriorsThatAreNoneByName) {
    const Survey survey = test::simulate(m_net, prior, 0.0005, 3).survey;
    for (const auto method :
         {IdentificationMethod::balance, IdentificationMethod::map, IdentificationMethod::gp}) {
        expect_misuse(survey, {.method = method, .prior = LengthPrior{.scale = std::nan("")}},
                      "scale");
    }
}

TEST_F(Identify, RefusesAModelThatIsNotForThis) {
    const Survey survey = test::simulate(m_net, prior, 0.0005, 3).survey;
    const LengthModel model = model_of(m_net, {});
    expect_misuse(survey, {.prior = LengthPrior{.scale = 0.003}, .model = &model},
                  "was trained for the prior uniform:2mm, expected uniform:3mm");
    expect_misuse(survey, {.method = IdentificationMethod::map, .model = &model}, "not for map");
    EXPECT_THROW((void)test::identify_lengths(hypar(5, 6), survey, {.model = &model}),
                 std::invalid_argument);
    LengthModel part = model;
    part.processes.processes.pop_back();
    expect_misuse(survey, {.model = &part}, "the model's parts");
    EXPECT_THROW((void)estimate_lengths(m_net, model, Eigen::MatrixXd::Zero(2, 1)),
                 std::invalid_argument);
}

TEST_F(Identify, TrainsAModelWhereNoneIsGivenAndStopsWhereAsked) {
    const Survey survey = test::simulate(m_net, prior, 0.0005, 3).survey;
    const IdentifyOptions options{
        .method = IdentificationMethod::gp, .prior = prior, .training_samples = 60};
    const Identification found = test::identify_lengths(m_net, survey, options);
    EXPECT_EQ(found.status, IdentificationStatus::converged);
    EXPECT_THAT(found.description, HasSubstr("trained on 60 samples of uniform:2mm"));
    EXPECT_THROW((void)test::identify_lengths(m_net, survey, options,
                                              {.stop_requested = [] { return true; }}),
                 Interrupted);
}

TEST_F(Identify, ReportsItsFitsAndSamples) {
    const Survey survey = test::simulate(m_net, prior, 0.0005, 3).survey;
    int steps = 0;
    int samples = 0;
    const Progress progress{.report = [&](std::string_view stage, int done, int total) {
        steps += stage == "identification" && total == 0 ? 1 : 0;
        samples += stage == "posterior samples" && done <= total ? 1 : 0;
    }};
    constexpr int draws = 50;
    const Identification found =
        test::identify_lengths(m_net, survey, {.prior = prior, .draws = draws}, progress);
    ASSERT_EQ(found.status, IdentificationStatus::converged);
    EXPECT_GE(steps, 3);
    EXPECT_GE(samples, draws);
}

TEST_F(Identify, StopsAmidTheFitWhereAsked) {
    const Survey survey = test::simulate(m_net, prior, 0.0005, 3).survey;
    int asked = 0;
    const Progress progress{.stop_requested = [&] { return ++asked > 3; }};
    EXPECT_THROW((void)test::identify_lengths(m_net, survey, {.prior = prior}, progress),
                 Interrupted);
    EXPECT_EQ(asked, 4);
}

// Gross errors are found by every method, also by those that look at no residual.
TEST_F(Identify, FindsAGrossErrorWhateverTheMethod) {
    Survey survey = test::simulate(m_net, prior, 0.0005, 3).survey;
    const int wrong = m_net.free_nodes()[7];
    survey.form(2, wrong) += 0.026;
    const LengthModel model = model_of(m_net, {});
    for (const IdentifyOptions& options :
         {IdentifyOptions{.method = IdentificationMethod::balance, .prior = prior},
          IdentifyOptions{.method = IdentificationMethod::map, .prior = prior},
          IdentifyOptions{.model = &model}}) {
        const Identification found = test::identify_lengths(m_net, survey, options);
        ASSERT_EQ(found.outliers.size(), 1U) << found.method;
        EXPECT_EQ(found.outliers.front().node, wrong) << found.method;
        EXPECT_GT(found.noise_ratio, 0.5) << found.method;
        EXPECT_LT(found.noise_ratio, 1.5) << found.method;
    }
}

}  // namespace of_identify
