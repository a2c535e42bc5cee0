// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "taut/gp/kernel.hpp"

/// Gaussian processes trained by scikit-learn: tests/data/gp_reference.json.
namespace taut::test {

struct ReferenceProcess {
    gp::Hyperparameters hyperparameters;
    double negative_log_likelihood;
    Eigen::VectorXd mean;  ///< at the test inputs
    Eigen::VectorXd std;   ///< of the latent function
};

struct ReferenceData {
    std::string name;
    Eigen::MatrixXd inputs;       ///< d x n
    Eigen::MatrixXd outputs;      ///< n x m
    Eigen::MatrixXd test_inputs;  ///< d x k
    std::vector<ReferenceProcess> processes;
};

inline Eigen::VectorXd to_vector(const nlohmann::json& json) {
    const auto values = json.get<std::vector<double>>();
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
}

/// A column for each of the lists.
inline Eigen::MatrixXd to_columns(const nlohmann::json& json) {
    Eigen::MatrixXd result(json.at(0).size(), json.size());
    for (size_t j = 0; j < json.size(); ++j) {
        result.col(static_cast<Eigen::Index>(j)) = to_vector(json[j]);
    }
    return result;
}

inline std::vector<ReferenceData> reference_data() {
    std::ifstream file(TAUT_TEST_DATA_DIR "/gp_reference.json");
    if (!file) {
        throw std::runtime_error("cannot read gp_reference.json");
    }
    const nlohmann::json json = nlohmann::json::parse(file);
    std::vector<ReferenceData> result;
    for (const auto& set : json.at("data_sets")) {
        ReferenceData data{.name = set.at("name"),
                           .inputs = to_columns(set.at("inputs")),
                           .outputs = to_columns(set.at("outputs")),
                           .test_inputs = to_columns(set.at("test_inputs")),
                           .processes = {}};
        for (const auto& process : set.at("processes")) {
            data.processes.push_back(
                {.hyperparameters = {.inverse_length_scale = process.at("inverse_length_scale"),
                                     .signal_std = process.at("signal_std"),
                                     .noise_std = process.at("noise_std")},
                 .negative_log_likelihood = process.at("negative_log_likelihood"),
                 .mean = to_vector(process.at("mean")),
                 .std = to_vector(process.at("std"))});
        }
        result.push_back(std::move(data));
    }
    if (result.empty()) {
        throw std::runtime_error("gp_reference.json is empty");
    }
    return result;
}

}  // namespace taut::test
