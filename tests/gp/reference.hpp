// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/json_numbers.hpp"
#include "taut/gp/kernel.hpp"

/// Gaussian processes trained by scikit-learn: tests/data/gp_reference.json.
namespace taut::test {

struct ReferenceProcess {
    gp::Hyperparameters hyperparameters;
    double negative_log_likelihood;
    Eigen::VectorXd mean;     ///< at the test inputs
    Eigen::VectorXd std_dev;  ///< of the latent function
};

struct ReferenceData {
    std::string name;
    Eigen::MatrixXd inputs;       ///< d x n
    Eigen::MatrixXd outputs;      ///< n x m
    Eigen::MatrixXd test_inputs;  ///< d x k
    std::vector<ReferenceProcess> processes;
};

inline std::vector<ReferenceData> reference_data() {
    std::ifstream file(TAUT_TEST_DATA_DIR "/gp_reference.json");
    if (!file) {
        throw std::runtime_error("cannot read gp_reference.json");
    }
    const nlohmann::json json = nlohmann::json::parse(file);
    std::vector<ReferenceData> result;
    for (const auto& set : json.at("data_sets")) {
        ReferenceData data{.name = set.at("name"),
                           .inputs = columns_of(set.at("inputs")),
                           .outputs = columns_of(set.at("outputs")),
                           .test_inputs = columns_of(set.at("test_inputs")),
                           .processes = {}};
        for (const auto& process : set.at("processes")) {
            data.processes.push_back(
                {.hyperparameters = {.inverse_length_scale = process.at("inverse_length_scale"),
                                     .signal_std = process.at("signal_std"),
                                     .noise_std = process.at("noise_std")},
                 .negative_log_likelihood = process.at("negative_log_likelihood"),
                 .mean = vector_of(process.at("mean")),
                 .std_dev = vector_of(process.at("std"))});
        }
        result.push_back(std::move(data));
    }
    if (result.empty()) {
        throw std::runtime_error("gp_reference.json is empty");
    }
    return result;
}

}  // namespace taut::test
