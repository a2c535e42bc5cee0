// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
//
// Guards against a model that learnt from the wrong samples, or that accepts the wrong ones.

#include "identification/train_together.hpp"
#include "taut/identification/length_estimates.hpp"
#include "taut/identification/model.hpp"
#include "taut/identification/result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "support/refusals.hpp"
#include "taut/design/builtin_nets.hpp"
#include "taut/sampling/sampler.hpp"

namespace of_model {

using namespace taut;

const CableNet& net() {
    static const CableNet small = hypar(2, 3);
    return small;
}

DataSet samples(int count) {
    return draw_samples(Sampler(net(), {LengthPrior::Kind::normal, 0.001}, 5), count);
}

TEST(Train, LearnsFromTheNamedSamplesAndNoOthers) {
    const DataSet data = samples(12);
    DataSet spoilt = data;
    for (const int k : {0, 2, 4, 5, 7, 9, 10}) {
        spoilt.form_deviations.col(k).setConstant(1e3);
        spoilt.length_deviations.col(k).setConstant(-1e3);
    }
    const std::vector<int> named{1, 3, 6, 8, 11};
    const LengthModel model = train_model(net(), data, named);
    EXPECT_EQ(model.processes.inputs, data.form_deviations(Eigen::all, named));
    const Eigen::MatrixXd at = data.form_deviations.col(0);
    EXPECT_EQ(train_model(net(), spoilt, named).processes.predict(at).mean,
              model.processes.predict(at).mean);
}

TEST(Train, GivesBackTheLengthsItLearntFrom) {
    const DataSet data = samples(60);
    const LengthModel model = train_model(net(), data, data.converged_in(0, 60));
    const Eigen::MatrixXd mean = estimate_lengths(net(), model, data.form_deviations).mean;
    EXPECT_LT((mean - data.length_deviations).cwiseAbs().maxCoeff(), 0.05 * data.prior.std_dev());
}

TEST(TrainTogether, IsAsLikelyAsEachByItself) {
    const DataSet data = samples(40);
    const std::vector<int> all = data.converged_in(0, 40);
    const std::vector<TrainingSettings> settings{TrainingSettings::paper(), {}};
    const std::vector<LengthModel> together = train_together(net(), data, all, settings);
    ASSERT_EQ(together.size(), 2U);
    const Eigen::MatrixXd at = samples(45).form_deviations.rightCols(5);
    for (size_t k = 0; k < settings.size(); ++k) {
        const LengthModel alone = train_model(net(), data, all, settings[k]);
        EXPECT_EQ(together[k].as_in_paper, alone.as_in_paper);
        EXPECT_EQ(together[k].mean, alone.mean);
        EXPECT_EQ(together[k].input_scales, alone.input_scales);
        double loss = 0.0;
        for (size_t j = 0; j < alone.processes.processes.size(); ++j) {
            const gp::Process& process = together[k].processes.processes[j];
            ASSERT_LT(static_cast<size_t>(process.spectrum), together[k].processes.spectra.size());
            EXPECT_EQ(process.hyperparameters.inverse_length_scale,
                      together[k].processes.spectra[process.spectrum].inverse_length_scale);
            loss += process.negative_log_likelihood -
                    alone.processes.processes[j].negative_log_likelihood;
        }
        EXPECT_LT(loss, 0.05 * net().interior_edge_count());
        const LengthEstimates ours = estimate_lengths(net(), together[k], at);
        const LengthEstimates expected = estimate_lengths(net(), alone, at);
        EXPECT_LT((ours.mean - expected.mean).cwiseAbs().maxCoeff(),
                  0.2 * expected.std_dev.maxCoeff());
    }
}

TEST(Train, RefusesSamplesThatAreNotThere) {
    DataSet data = samples(4);
    EXPECT_THROW((void)train_model(net(), data, {2}), std::invalid_argument);
    EXPECT_NO_THROW((void)train_model(net(), data, {2, 3}));
    for (const int bad : {-1, 4, 1000}) {
        EXPECT_THAT(
            test::refusal_of([&] { return train_model(net(), data, {0, 1, bad}); }),
            testing::AllOf(testing::HasSubstr(std::to_string(bad)), testing::HasSubstr("0 to 3")));
    }
    data.form_deviations.conservativeResize(2, 4);  // parts are missing
    EXPECT_THROW((void)train_model(net(), data, {0, 1, 2, 3}), std::invalid_argument);
}

}  // namespace of_model
