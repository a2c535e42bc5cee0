// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <vector>

#include "taut/net/cable_net.hpp"

/// Lists of numbers in the files of tests/data.
namespace taut::test {

inline Eigen::VectorXd vector_of(const nlohmann::json& list) {
    const auto values = list.get<std::vector<double>>();
    return Eigen::VectorXd::Map(values.data(), std::ssize(values));
}

/// A column for each of the lists, which are as long as one another.
inline Eigen::MatrixXd columns_of(const nlohmann::json& lists) {
    Eigen::MatrixXd result(lists.at(0).size(), lists.size());
    for (size_t j = 0; j < lists.size(); ++j) {
        result.col(static_cast<Eigen::Index>(j)) = vector_of(lists[j]);
    }
    return result;
}

inline Points points_of(const nlohmann::json& places) {
    return places.empty() ? Points(3, 0) : Points(columns_of(places));
}

}  // namespace taut::test
