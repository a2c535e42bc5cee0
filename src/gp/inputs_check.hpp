// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/core.h>

#include <Eigen/Core>
#include <stdexcept>
#include <string_view>

namespace taut::gp {

/// Squares of larger numbers, and sums of these, could overflow.
inline constexpr double largest_number = 1e100;

/// Whether all are finite and no larger.
[[nodiscard]] inline bool is_usable(const Eigen::Ref<const Eigen::MatrixXd>& numbers) {
    return numbers.size() == 0 ||
           (numbers.allFinite() && numbers.cwiseAbs().maxCoeff() <= largest_number);
}

/// @param what "the training inputs"
/// @throws std::invalid_argument where one is not finite or larger
inline void require_usable(std::string_view what, const Eigen::Ref<const Eigen::MatrixXd>& inputs) {
    if (!is_usable(inputs)) {
        throw std::invalid_argument(fmt::format(
            "{} contain a number that is not finite or exceeds {:g}", what, largest_number));
    }
}

}  // namespace taut::gp
