// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>
#include <stop_token>
#include <vector>

#include "taut/identification/model.hpp"
#include "taut/sampling/sampler.hpp"
#include "taut/study/method.hpp"
#include "taut/study/progress.hpp"

namespace taut {

/// A data set of so many samples, drawn in blocks.
/// @throws Interrupted
[[nodiscard]] DataSet draw_samples(const Sampler& sampler, int count, const StudyProgress& progress,
                                   const std::stop_token& stop);

/// Models are trained one after the other; together they make the stage "training".
class Training {
public:
    Training(const CableNet& net, int models, const StudyProgress& progress, std::stop_token stop);

    /// Gaussian processes as in the paper.
    /// @throws Interrupted
    [[nodiscard]] LengthModel as_in_paper(const DataSet& data, const std::vector<int>& samples);

    /// The Gaussian processes that identify best.
    /// @throws Interrupted
    [[nodiscard]] LengthModel best(const DataSet& data, const std::vector<int>& samples);

private:
    [[nodiscard]] LengthModel train_one(const DataSet& data, const std::vector<int>& samples,
                                        TrainingSettings settings);

    const CableNet& m_net;
    int m_models;
    int m_begun = 0;
    const StudyProgress& m_progress;
    std::stop_token m_stop;
};

/// Tells the progress of a stage whose steps end on several threads, in order.
class StepCounter {
public:
    StepCounter(std::string_view stage, int total, const StudyProgress& progress);
    void tick();

private:
    std::string_view m_stage;
    int m_total;
    int m_done = 0;
    const StudyProgress& m_progress;
    std::mutex m_mutex;
};

}  // namespace taut
