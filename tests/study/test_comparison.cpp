// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a comparison whose methods do not see the same surveys, that trains on what it
// surveys, or that depends on the number of threads.

#include "taut/study/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>

#include "study/error_sums.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/threads.hpp"

namespace {

using namespace taut;
using testing::ElementsAre;
using testing::HasSubstr;

const ComparisonSettings small_comparison{.noises = {5e-4, 0.0, 1e-4},
                                          .training_samples = {60, 20, 40},
                                          .hidden_parts = {0.0, 0.2},
                                          .surveys = 6,
                                          .prior = {LengthPrior::Kind::uniform, 0.003},
                                          .seed = 3};

const ComparisonRow& row_of(const Comparison& comparison, const std::string& method,
                            const SurveyKind& kind, int training = 60) {
    for (const ComparisonRow& row : comparison.rows) {
        if (row.result.name == method && row.kind == kind &&
            row.training_samples.value_or(training) == training) {
            return row;
        }
    }
    throw std::logic_error("no such row");
}

class SmallComparison : public testing::Test {
protected:
    /// Computed once for all tests.
    static const Comparison& the_comparison() {
        static const Comparison comparison = compare_methods(hypar(4, 5), small_comparison);
        return comparison;
    }

    const CableNet m_net = hypar(4, 5);
    const Comparison& m_comparison = the_comparison();
};

TEST_F(SmallComparison, HasARowForEachMethodAndPlaceOnItsAxes) {
    using Place = std::tuple<std::string, double, double, int>;
    std::vector<Place> expected;
    const auto all = [&](double noise, double hidden) {
        expected.emplace_back("gp_as_in_paper", noise, hidden, 60);
        expected.emplace_back("gp", noise, hidden, 60);
        expected.emplace_back("balance", noise, hidden, 0);
        expected.emplace_back("map", noise, hidden, 0);
    };
    for (const double noise : {0.0, 1e-4, 5e-4}) {
        all(noise, 0.0);
    }
    for (const double noise : {0.0, 5e-4}) {
        for (const int samples : {20, 40}) {
            expected.emplace_back("gp_as_in_paper", noise, 0.0, samples);
            expected.emplace_back("gp", noise, 0.0, samples);
        }
    }
    all(5e-4, 0.2);
    std::vector<Place> found;
    for (const ComparisonRow& row : m_comparison.rows) {
        found.emplace_back(row.result.name, row.kind.noise_std, row.kind.hidden_part,
                           row.training_samples.value_or(0));
        EXPECT_EQ(row.result.surveys, 6);
    }
    EXPECT_EQ(found, expected);
}

TEST_F(SmallComparison, TrainsOnTheFirstSamplesAndSurveysTheLast) {
    const Sampler sampler(m_net, small_comparison.prior, small_comparison.seed);
    DataSet data = sampler.no_samples();
    sampler.extend_to(data, 66);
    ASSERT_EQ(data.not_converged(), 0);
    EXPECT_EQ(m_comparison.samples, 66);
    const LengthModel model =
        train_model(m_net, data, data.converged_in(0, 40), TrainingSettings::paper());
    const Eigen::MatrixXd estimates =
        estimate_lengths(m_net, model, data.form_deviations.rightCols(6)).mean;
    const LengthErrors errors = length_errors(data.length_deviations.rightCols(6), estimates);
    const LengthErrors& found = row_of(m_comparison, "gp_as_in_paper", {}, 40).result.errors;
    EXPECT_NEAR(found.mse, errors.mse, 1e-6 * errors.mse);
    EXPECT_NEAR(found.mrse, errors.mrse, 1e-6 * errors.mrse);
}

TEST_F(SmallComparison, HasTheBoundOfASurveyForAnyMethod) {
    const auto best = [this](const std::string& method, const SurveyKind& kind) {
        return row_of(m_comparison, method, kind).cramer_rao;
    };
    const SurveyKind noisy{.noise_std = 5e-4};
    const SurveyKind hidden{.noise_std = 5e-4, .hidden_part = 0.2};
    EXPECT_FALSE(best("map", {}));
    EXPECT_EQ(best("map", noisy)->mse, best("gp_as_in_paper", noisy)->mse);
    EXPECT_LT(best("map", {.noise_std = 1e-4})->mse, best("map", noisy)->mse);
    EXPECT_LT(best("map", noisy)->mse, best("map", hidden)->mse);
}

TEST_F(SmallComparison, SaysWhatAMethodCannotDo) {
    const SurveyKind hidden{.noise_std = 5e-4, .hidden_part = 0.2};
    for (const std::string method : {"gp_as_in_paper", "balance"}) {
        const MethodResult& result = row_of(m_comparison, method, hidden).result;
        EXPECT_EQ(result.failed, 6);
        EXPECT_EQ(result.first_failure, "needs a survey of all free nodes");
    }
    EXPECT_EQ(row_of(m_comparison, "map", hidden).result.failed, 0);
}

TEST_F(SmallComparison, DoesNotDependOnTheNumberOfThreads) {
    const Comparison again =
        with_threads(1, [&] { return compare_methods(m_net, small_comparison); });
    ASSERT_EQ(again.rows.size(), m_comparison.rows.size());
    for (size_t i = 0; i < again.rows.size(); ++i) {
        const MethodResult& a = again.rows[i].result;
        const MethodResult& b = m_comparison.rows[i].result;
        EXPECT_EQ(a.errors.mse, b.errors.mse) << a.name;
        EXPECT_EQ(a.form_error.mean, b.form_error.mean) << a.name;
        EXPECT_EQ(a.coverage, b.coverage);
        EXPECT_EQ(again.rows[i].cramer_rao.has_value(),
                  m_comparison.rows[i].cramer_rao.has_value());
        if (again.rows[i].cramer_rao) {
            EXPECT_EQ(again.rows[i].cramer_rao->mse, m_comparison.rows[i].cramer_rao->mse);
        }
    }
}

TEST(Comparison, CountsSurveysWithSlackEdges) {
    ComparisonSettings settings = small_comparison;
    settings.prior.scale = 0.01;
    settings.noises = {0.0};
    settings.training_samples = {20};
    settings.hidden_parts = {};
    const Comparison comparison = compare_methods(hypar(4, 5), settings);
    EXPECT_GT(comparison.surveys_with_slack, 0);
    const MethodResult& balance = row_of(comparison, "balance", {}, 20).result;
    EXPECT_EQ(balance.failed, 0) << balance.first_failure;
    EXPECT_LT(balance.mse_of_taut, 1e-20);
    EXPECT_GT(balance.errors.mse, 1e-9);
}

/// One kind of survey of hypar:5x6.
ComparisonSettings of_one_kind(int surveys) {
    return {.noises = {5e-4},
            .training_samples = {60},
            .hidden_parts = {},
            .surveys = surveys,
            .prior = {LengthPrior::Kind::uniform, 0.002}};
}

TEST(Comparison, GivesMethodsTheModelErrorsOrNot) {
    ComparisonSettings settings = of_one_kind(6);
    settings.uncertain = {parse_uncertain_parameter("supports:2mm"),
                          parse_uncertain_parameter("stiffness:5%")};
    std::map<std::string, double> coverage;
    for (const ComparisonRow& row : compare_methods(hypar(5, 6), settings).model_error_rows) {
        coverage[row.result.name + " " + std::string(to_string(row.model_errors))] =
            row.result.coverage;
    }
    EXPECT_EQ(coverage.size(), 6U);  // four methods not given them, gp and map given them
    EXPECT_LT(coverage["map not given"], 0.9);
    EXPECT_GT(coverage["map given"], 0.9);
}

TEST(Comparison, IsOfSeveralSurveysOfEachNetWithAndWithoutTurnsInBetween) {
    ComparisonSettings settings = of_one_kind(4);
    settings.epochs = 3;
    std::map<std::string, double> mse;
    for (const ComparisonRow& row : compare_methods(hypar(5, 6), settings).epoch_rows) {
        EXPECT_EQ(row.result.failed, 0);
        EXPECT_GT(row.result.coverage, 0.9);
        mse[std::to_string(row.epochs) + (row.is_turned ? "t" : "")] = row.result.errors.mse;
    }
    EXPECT_EQ(mse.size(), 5U);
    EXPECT_LT(mse["2"], 0.8 * mse["1"]);
    EXPECT_LT(mse["2t"], 0.8 * mse["1"]);
    EXPECT_LT(mse["3"], mse["2"]);
    EXPECT_LT(mse["3t"], mse["2t"]);
}

TEST(Comparison, ReportsItsProgressToItsEndAndStopsWhereRequested) {
    std::vector<int> last(2, 0);
    const auto tell = [&](std::string_view stage, int done, int total) {
        if (stage == "identification") {
            EXPECT_EQ(done, last[0] + 1);
            last = {done, total};
        }
    };
    (void)compare_methods(hypar(3, 3), small_comparison, {.report = tell});
    EXPECT_GT(last[0], 0);
    EXPECT_EQ(last[0], last[1]);
    for (const std::string stage : {"sampling", "training", "identification"}) {
        std::atomic<bool> stop = false;
        const Progress progress{.report =
                                    [&](std::string_view now, int, int) {
                                        if (now == stage) {
                                            stop = true;
                                        }
                                    },
                                .stop_requested = [&] { return stop.load(); }};
        EXPECT_THROW((void)compare_methods(hypar(3, 3), small_comparison, progress), Interrupted);
    }
}

TEST(ComparisonSettings, ChooseTheCommonValuesOfTheOtherAxes) {
    EXPECT_EQ(ComparisonSettings{}.common_training(), 950);
    EXPECT_EQ(ComparisonSettings{}.common_noise(), 5e-4);
    EXPECT_EQ(small_comparison.common_training(), 60);
    const ComparisonSettings other{.noises = {0.0, 3e-4, 1e-4}};
    EXPECT_EQ(other.common_noise(), 3e-4);
}

TEST(ComparisonSettings, RefuseWhatMakesNoSense) {
    const auto refusal = [](auto change) -> std::string {
        ComparisonSettings settings;
        change(settings);
        try {
            settings.check();
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "not refused";
    };
    EXPECT_EQ(refusal([](auto&) {}), "not refused");
    EXPECT_EQ(refusal([](auto& s) { s.hidden_parts = {}; }), "not refused");
    EXPECT_THAT(refusal([](auto& s) { s.noises = {}; }), HasSubstr("no noise"));
    EXPECT_THAT(refusal([](auto& s) { s.noises = {0.0, -1e-3}; }), HasSubstr("-0.001 m"));
    EXPECT_THAT(refusal([](auto& s) { s.noises = {INFINITY}; }), HasSubstr("inf"));
    EXPECT_THAT(refusal([](auto& s) { s.training_samples = {}; }), HasSubstr("training samples"));
    EXPECT_THAT(refusal([](auto& s) { s.training_samples = {100, 1}; }),
                HasSubstr("1 training samples"));
    EXPECT_THAT(refusal([](auto& s) { s.hidden_parts = {1.0}; }), HasSubstr("below 1"));
    EXPECT_THAT(refusal([](auto& s) { s.hidden_parts = {-0.1}; }), HasSubstr("-0.1"));
    EXPECT_THAT(refusal([](auto& s) { s.surveys = 0; }), HasSubstr("0 surveys"));
    for (const double scale : {0.0, -0.005, std::nan("")}) {
        EXPECT_THAT(refusal([scale](auto& s) { s.prior.scale = scale; }),
                    HasSubstr("uniform prior"));
    }
}

}  // namespace
