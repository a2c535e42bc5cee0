// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "study/stages.hpp"

#include <algorithm>
#include <utility>

namespace taut {

DataSet draw_samples(const Sampler& sampler, int count, const StudyProgress& progress,
                     const std::stop_token& stop) {
    DataSet data = sampler.empty();
    const int block = std::max(16, count / 50);
    while (data.size() < count) {
        progress("sampling", data.size(), count);
        if (!sampler.extend(data, std::min(count, data.size() + block), stop)) {
            throw Interrupted();
        }
    }
    progress("sampling", count, count);
    return data;
}

Training::Training(const CableNet& net, int models, const StudyProgress& progress,
                   std::stop_token stop)
    : m_net(net), m_models(models), m_progress(progress), m_stop(std::move(stop)) {}

LengthModel Training::train_one(const DataSet& data, const std::vector<int>& samples,
                                TrainingSettings settings) {
    const int most = settings.fit.max_spectra;
    settings.fit.progress = [this, most, begun = m_begun++](int made) {
        if (m_stop.stop_requested()) {
            throw Interrupted();
        }
        m_progress("training", begun * most + made, m_models * most);
    };
    return train(m_net, data, samples, settings);
}

LengthModel Training::as_in_paper(const DataSet& data, const std::vector<int>& samples) {
    return train_one(data, samples, TrainingSettings::as_in_paper());
}

LengthModel Training::best(const DataSet& data, const std::vector<int>& samples) {
    return train_one(data, samples, {});
}

StepCounter::StepCounter(std::string_view stage, int total, const StudyProgress& progress)
    : m_stage(stage), m_total(total), m_progress(progress) {}

void StepCounter::tick() {
    const std::lock_guard lock(m_mutex);
    m_progress(m_stage, ++m_done, m_total);
}

}  // namespace taut
