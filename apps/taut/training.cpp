// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "training.hpp"

#include "interruption.hpp"
#include "progress.hpp"
#include "taut/study/study.hpp"

namespace taut::app {

LengthModel train_with_progress(const CableNet& net, const DataSet& data,
                                const std::vector<int>& samples, TrainingSettings settings,
                                bool quiet) {
    const std::stop_token stop = Interruption::stop_token();
    Progress progress(quiet);
    settings.fit.progress = [&](int made) {
        if (stop.stop_requested()) {
            throw Interrupted();
        }
        progress.show("training", made, settings.fit.max_spectra);
    };
    return train(net, data, samples, settings);
}

}  // namespace taut::app
