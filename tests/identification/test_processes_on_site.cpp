// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against processes that take a survey's noise for truth, intervals that do not hold under
// it, and gross errors that spoil the rest.
#include <gtest/gtest.h>

#include "identification/cramer_rao_bound.hpp"
#include "identification/processes.hpp"
#include "simulated_survey.hpp"
#include "support/identify_lengths.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/identification/identify.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/sampling/sampler.hpp"

namespace taut {
namespace {

constexpr LengthPrior uniform_prior{LengthPrior::Kind::uniform, 0.003};
constexpr LengthPrior gaussian_prior{LengthPrior::Kind::normal, 0.0015};

LengthModel model_of(const CableNet& net, const LengthPrior& prior,
                     const TrainingSettings& settings = {}, int samples = 300) {
    const DataSet data = draw_samples(Sampler(net, prior, 1), samples);
    return train_model(net, data, data.converged_in(0, samples), settings);
}

struct Score {
    double mse = 0.0;
    double cramer_rao = 0.0;
    double coverage = 0.0;
};

/// Over surveys of random nets with noise and hidden nodes.
Score score(const CableNet& net, const LengthModel& model, double noise, int surveys,
            int hidden = 0) {
    Score sum;
    for (int k = 0; k < surveys; ++k) {
        auto s = test::simulate(net, model.prior, noise, 500 + static_cast<unsigned>(k));
        for (int h = 0; h < hidden; ++h) {
            test::hide(net, s.survey, net.free_nodes()[5 * h + k % 5]);
        }
        const Identification found = identify_by_processes(net, model, s.survey);
        sum.mse += test::squared_error(found, s.deviations) / surveys;
        sum.coverage += test::coverage(found, s.deviations) / surveys;
        for (const IdentifiedEdge& e : found.edges) {
            if (model.prior.kind == LengthPrior::Kind::uniform) {
                EXPECT_GE(e.lower, -model.prior.scale);
                EXPECT_LE(e.upper, model.prior.scale);
            }
        }
        if (noise > 0.0) {
            sum.cramer_rao += cramer_rao_variances(net, with_length_deviations(net, s.deviations),
                                                   s.truth.form, s.survey, model.prior)
                                  .mean() /
                              surveys;
        }
    }
    return sum;
}

TEST(ProcessesOnSite, IntervalsHoldAndErrorsAreNearTheBestPossible) {
    const CableNet net = hypar(5, 6);
    for (const LengthPrior& prior : {uniform_prior, gaussian_prior}) {
        const LengthModel model = model_of(net, prior);
        for (const double noise : {0.0, 0.0001, 0.0005, 0.002}) {
            const Score s = score(net, model, noise, 40);
            SCOPED_TRACE(to_string(prior) + ", noise " + std::to_string(noise));
            EXPECT_GT(s.coverage, 0.93);
            EXPECT_LT(s.coverage, 0.97);
            if (noise > 0.0) {
                EXPECT_LT(s.mse, (noise < 0.0002 ? 1.8 : 1.05) * s.cramer_rao);
            }
        }
    }
}

TEST(ProcessesOnSite, IntervalsAllButHoldWithFewSamplesAndLittleNoise) {
    // 75 coordinates: the samples alone leave most directions of the remainder unobserved.
    const CableNet net = hypar(5, 5);
    const LengthModel model = model_of(net, uniform_prior, {}, 40);
    for (const double noise : {0.00001, 0.00003, 0.0001}) {
        const Score s = score(net, model, noise, 30);
        SCOPED_TRACE("noise " + std::to_string(noise));
        // As narrow as without noise: from 40 samples the processes know their own errors poorly.
        EXPECT_GT(s.coverage, 0.91);
        EXPECT_LT(s.coverage, 0.97);
    }
}

TEST(ProcessesOnSite, AFormPriorThatTheModelDoesNotKeepIsMadeWhereItIsAskedFor) {
    const CableNet net = hypar(4, 5);
    LengthModel model = model_of(net, uniform_prior);
    auto s = test::simulate(net, uniform_prior, 0.0005, 7);
    test::hide(net, s.survey, net.free_nodes()[3]);
    const Identification kept = identify_by_processes(net, model, s.survey);
    model.form_prior = {};  // as of a net of more than 1,000 free nodes
    const Identification made = identify_by_processes(net, model, s.survey);
    ASSERT_EQ(made.edges.size(), kept.edges.size());
    for (size_t i = 0; i < kept.edges.size(); ++i) {
        EXPECT_DOUBLE_EQ(made.edges[i].length_deviation, kept.edges[i].length_deviation);
        EXPECT_DOUBLE_EQ(made.edges[i].std_dev, kept.edges[i].std_dev);
    }
}

TEST(ProcessesOnSite, AnEdgeAtASupportMayBeOneToIdentify) {
    CableNetData net_data = hypar(4, 4).data();
    net_data.adjustable = std::vector<int>{hypar(4, 4).adjustable_edges().front()};
    const CableNet net(net_data);
    ASSERT_GT(net.interior_edge_count(), hypar(4, 4).interior_edge_count());
    const Score s = score(net, model_of(net, gaussian_prior), 0.0005, 30);
    EXPECT_GT(s.coverage, 0.93);
    EXPECT_LT(s.coverage, 0.97);
    EXPECT_LT(s.mse, 1.1 * s.cramer_rao);
}

TEST(ProcessesOnSite, HiddenNodesAreFilledInWithTheirConditionalMean) {
    const CableNet net = hypar(5, 6);
    const Score s = score(net, model_of(net, gaussian_prior), 0.0005, 40, 3);
    EXPECT_GT(s.coverage, 0.93);
    EXPECT_LT(s.coverage, 0.97);
    EXPECT_LT(s.mse, 1.05 * s.cramer_rao);
}

TEST(ProcessesOnSite, AModelAsInThePaperTakesTheSurveyForExactAndWhole) {
    const CableNet net = hypar(3, 4);
    const LengthModel model = model_of(net, uniform_prior, TrainingSettings::paper());
    auto s = test::simulate(net, uniform_prior, 0.0005, 3);
    const Identification found = test::identify_lengths(net, s.survey, {.model = &model});
    const LengthEstimates expected =
        estimate_lengths(net, model, free_coordinates(net, s.survey.form) - model.nominal_form);
    for (size_t i = 0; i < found.edges.size(); ++i) {
        EXPECT_EQ(found.edges[i].length_deviation, expected.mean(static_cast<Eigen::Index>(i), 0));
    }
    test::hide(net, s.survey, net.free_nodes()[2]);
    EXPECT_THROW((void)test::identify_lengths(net, s.survey, {.model = &model}), SurveyError);
}

}  // namespace
}  // namespace taut
