// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/identification/model.hpp"

#include <fmt/core.h>

#include <stdexcept>

namespace taut {

LengthModel train(const DataSet& data, const std::vector<int>& samples,
                  const gp::FitSettings& settings) {
    for (const int k : samples) {
        if (k < 0 || k >= data.size()) {
            throw std::invalid_argument(
                fmt::format("training sample {}, expected 0 to {}", k, data.size() - 1));
        }
    }
    return {
        .net_fingerprint = data.net_fingerprint,
        .law = data.law,
        .seed = data.seed,
        .nominal_form = data.nominal_form,
        .processes = gp::fit(data.form_deviations(Eigen::all, samples),
                             data.length_deviations(Eigen::all, samples).transpose(), settings)};
}

}  // namespace taut
