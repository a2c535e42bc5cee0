// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "taut/gp/fit.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/sampling/data_set.hpp"

namespace taut {

/// The learnt map from form deviation to length deviations: one Gaussian process an interior edge.
struct LengthModel {
    std::string net_fingerprint;
    LengthLaw law;  ///< of the data it was trained on
    std::uint64_t seed = 1;
    Eigen::VectorXd nominal_form;   ///< r_I that form deviations refer to (3 n_I) [m]
    gp::FittedProcesses processes;  ///< inputs: form deviations; outputs: length deviations [m]

    [[nodiscard]] int training_count() const { return static_cast<int>(processes.inputs.cols()); }
};

/// Algorithm 1 of the paper on samples of a data set.
/// @param samples which to train on; their forces must balance
/// @throws std::invalid_argument for fewer than two samples, or an index out of range
[[nodiscard]] LengthModel train(const DataSet& data, const std::vector<int>& samples,
                                const gp::FitSettings& settings = {});

}  // namespace taut
