// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "files/json_value.hpp"

namespace taut {

/// Three numbers.
/// @throws InputError for anything else
[[nodiscard]] inline Eigen::Vector3d read_place(const JsonValue& value) {
    value.require_array(3, "three numbers [x, y, z], or null");
    return {value.at(0).number(), value.at(1).number(), value.at(2).number()};
}

/// A stiffness of 3 x 3: one number for all directions, three for x, y, z, or nine.
/// @throws InputError for anything else
[[nodiscard]] inline Eigen::Matrix3d read_stiffness(
    const JsonValue& value,
    const char* expected = "null, a number, three numbers [x, y, z] or a matrix of 3 x 3 [N/m]") {
    if (value.json().is_number()) {
        return value.number() * Eigen::Matrix3d::Identity();
    }
    value.require_array(3, expected);
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
    const bool is_matrix = value.at(0).json().is_array();
    for (Eigen::Index i = 0; i < 3; ++i) {
        const JsonValue row = value.at(static_cast<size_t>(i));
        if (!is_matrix) {
            result(i, i) = row.number();
            continue;
        }
        row.require_array(3, expected);
        for (Eigen::Index k = 0; k < 3; ++k) {
            result(i, k) = row.at(static_cast<size_t>(k)).number();
        }
    }
    return result;
}

}  // namespace taut
