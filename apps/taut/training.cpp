// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "training.hpp"

#include "interruption.hpp"
#include "progress.hpp"
#include "taut/study/study.hpp"

namespace taut::app {

LengthModel train_with_progress(const DataSet& data, const std::vector<int>& samples, bool quiet) {
    const std::stop_token stop = Interruption::stop_token();
    Progress progress(quiet);
    gp::FitSettings settings;
    settings.progress = [&](int made) {
        if (stop.stop_requested()) {
            throw Interrupted();
        }
        progress.show("training", made, settings.max_spectra);
    };
    return train(data, samples, settings);
}

}  // namespace taut::app
