// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "taut/survey/cable_frequency.hpp"

namespace taut {

/// A hinged string with bending stiffness: docs/theory.md, (string modes).
struct StiffString {
    double squared_f0 = 0.0;     ///< f_0^2 [Hz^2]
    double inharmonicity = 0.0;  ///< B

    [[nodiscard]] double frequency(int n) const {
        return n * std::sqrt(squared_f0 * (1.0 + inharmonicity * n * n));
    }
    /// The mode nearest to a frequency: n^2 (1 + B n^2) = f^2 / f_0^2.
    [[nodiscard]] int nearest_mode(double frequency) const {
        const double x = frequency * frequency / squared_f0;
        const double squared = 2.0 * x / (1.0 + std::sqrt(1.0 + 4.0 * inharmonicity * x));
        return static_cast<int>(std::clamp(std::round(std::sqrt(squared)), 1.0, 1e6));
    }
};

/// A string fitted to the modes of peaks.
struct StringFit {
    StiffString string = {};
    std::vector<int> modes;      ///< of each peak
    Eigen::Matrix2d covariance;  ///< of f_0^2 and f_0^2 B
    bool is_stiff = false;       ///< whether B was fitted
    double part = 0.0;           ///< standard deviation of modes from the string, of the frequency

    /// Standard deviation of the frequency of a mode [Hz].
    [[nodiscard]] double std_dev(int n) const {
        const Eigen::Vector2d row(1.0, static_cast<double>(n) * n);
        return n * n * std::sqrt(row.dot(covariance * row)) / (2.0 * string.frequency(n));
    }
};

/// Standard deviation of a peak about a string [Hz].
/// @param part standard deviation of modes from the string, as a part of their frequency
[[nodiscard]] inline double total_std(const FrequencyPeak& peak, double part) {
    return std::hypot(peak.std_dev, part * peak.frequency);
}

/// Peaks with a mode.
[[nodiscard]] Eigen::Index explained_peaks(const std::vector<int>& modes);

/// Least squares of (string modes), linear in f_0^2 and f_0^2 B:
///     y = (f/n)^2 = f_0^2 + f_0^2 B n^2,  std y = 2 f s / n^2
/// @param modes of each peak; 0: not explained
/// @param is_stiff whether B is free, for which there must be two modes
/// @param part as in total_std()
[[nodiscard]] StringFit fit_string(const std::vector<FrequencyPeak>& peaks,
                                   const std::vector<int>& modes, bool is_stiff, double part);

/// The fit again with B >= 0 free, where there are three modes, so that its uncertainty is that of
/// f_1 as well; and with modes as far from the string as they are: by a part of the frequency with
/// which the weighted squares of the residuals have their expectation. Two more that are expected
/// say that no cable is nearer to a string than some tenths of a per cent, however well a few peaks
/// agree.
[[nodiscard]] StringFit scattered_fit(const std::vector<FrequencyPeak>& peaks,
                                      const std::vector<int>& modes);

}  // namespace taut
