// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/net/tension_law.hpp"

namespace taut {

/// Stress over strain of a cable's material, the tension law of an area of 1 m2.
struct StressStrain {
    Eigen::VectorXd strain;  ///< [-]
    Eigen::VectorXd stress;  ///< [Pa]
};

/// Reads a CSV table with the header strain,stress: the points of a piecewise linear tension law,
/// from 0,0, stresses in Pa.
/// @param file_name for messages
/// @throws InputError with the line, for what is no such table, breaks a rule of TensionLaw, or has
///   a slope that no cable has
[[nodiscard]] TAUT_IO_EXPORT StressStrain parse_stress_strain(std::string_view text,
                                                              const std::string& file_name);

}  // namespace taut
