// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/design/unstressed_lengths.hpp"

#include <fmt/core.h>

#include <cmath>
#include <stdexcept>

namespace taut {

Eigen::VectorXd unstressed_lengths_for(const Eigen::Ref<const Eigen::VectorXd>& lengths,
                                       const Eigen::Ref<const Eigen::VectorXd>& tensions,
                                       const Eigen::Ref<const Eigen::VectorXd>& axial_stiffness) {
    if (tensions.size() != lengths.size() || axial_stiffness.size() != lengths.size()) {
        throw std::invalid_argument(fmt::format(
            "{} lengths, {} tensions and {} axial stiffnesses: expected as many of each",
            lengths.size(), tensions.size(), axial_stiffness.size()));
    }
    const auto positive = [](double x) { return std::isfinite(x) && x > 0.0; };
    for (Eigen::Index e = 0; e < lengths.size(); ++e) {
        if (!positive(lengths(e)) || !positive(axial_stiffness(e)) ||
            !(std::isfinite(tensions(e)) && tensions(e) > -axial_stiffness(e))) {
            throw std::invalid_argument(
                fmt::format("edge {} has length {} m, tension {} N and axial stiffness {} N: "
                            "expected a positive length and stiffness, and a tension above the "
                            "negative stiffness",
                            e, lengths(e), tensions(e), axial_stiffness(e)));
        }
    }
    return lengths.array() / (1.0 + tensions.array() / axial_stiffness.array());
}

}  // namespace taut
