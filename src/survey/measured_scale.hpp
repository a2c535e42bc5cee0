// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/registration.hpp"

namespace taut {

/// Measured over known distances of control points, and how sure that is.
struct TAUT_CORE_EXPORT MeasuredScale {
    double scale = 1.0;    ///< measured over known distances
    double std_dev = 0.0;  ///< standard error of it, from the points' residuals
    int redundancy = 2;    ///< 3 n - 7 of n points

    /// Whether the scale departs from 1 by more than the residuals explain; by chance in one of a
    /// thousand surveys (Student's t).
    [[nodiscard]] bool is_significant() const;
};

/// With the places less their means, a_i measured and turned by the R of register_rigidly(), and
/// b_i known, the scale k that makes sum_i |a_i - k b_i|^2 least (Umeyama 1991), and its standard
/// error:
///
///     k = sum a_i . b_i / sum |b_i|^2,   s_k^2 = sum |a_i - k b_i|^2 / ((3 n - 7) sum |b_i|^2)
///
/// @return none where the points determine no frame: where register_rigidly() throws
[[nodiscard]] TAUT_CORE_EXPORT std::optional<MeasuredScale> measured_scale(
    const std::vector<ControlPoint>& points);

/// A warning where the scale differs from 1 significantly, and by more than 1e-4.
[[nodiscard]] TAUT_CORE_EXPORT std::vector<std::string> scale_warnings(
    const std::vector<ControlPoint>& points);

}  // namespace taut
