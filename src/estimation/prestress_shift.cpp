// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/prestress_shift.hpp"

#include <cmath>

namespace taut {

std::optional<PrestressShift> prestress_shift(const std::vector<PerturbedFit>& fits) {
    constexpr size_t fewest = 25;
    if (fits.size() < fewest) {
        return std::nullopt;
    }
    const auto count = std::ssize(fits);
    Eigen::VectorXd tension(count);
    Eigen::VectorXd determinant(count);
    for (Eigen::Index k = 0; k < count; ++k) {
        tension(k) = fits[static_cast<size_t>(k)].mean_tension;
        determinant(k) = fits[static_cast<size_t>(k)].half_log_determinant;
    }
    tension.array() -= tension.mean();
    determinant.array() -= determinant.mean();
    const double along = tension.dot(determinant);
    const double correlation = along / (tension.norm() * determinant.norm());
    constexpr double by_chance = 0.4;  // of so few fits, at most
    if (!(std::abs(correlation) > by_chance)) {
        return std::nullopt;
    }
    const auto degrees = static_cast<double>(count - 1);
    const Eigen::VectorXd weights = along / tension.squaredNorm() / degrees * tension;
    // From the first: the mean of all cancels.
    const Iterate& first = fits.front().iterate;
    PrestressShift result{.by = first.moved(first, -1.0),
                          .size = std::abs(along) / tension.norm() / std::sqrt(degrees)};
    for (Eigen::Index k = 0; k < count; ++k) {
        const Iterate off = fits[static_cast<size_t>(k)].iterate.moved(first, -1.0);
        result.by = result.by.moved(off, -weights(k));
    }
    return result;
}

}  // namespace taut
