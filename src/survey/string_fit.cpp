// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/string_fit.hpp"

#include <algorithm>

namespace taut {

Eigen::Index explained_peaks(const std::vector<int>& modes) {
    return std::ranges::count_if(modes, [](int n) { return n > 0; });
}

StringFit fit_string(const std::vector<FrequencyPeak>& peaks, const std::vector<int>& modes,
                     bool is_stiff, double part) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (size_t i = 0; i < peaks.size(); ++i) {
        if (modes[i] > 0) {
            const double squared = static_cast<double>(modes[i]) * modes[i];
            const double f = peaks[i].frequency;
            const double std_dev = 2.0 * f * total_std(peaks[i], part) / squared;
            const Eigen::Vector2d row(1.0, squared);
            normal += row * row.transpose() / (std_dev * std_dev);
            right += row * (f * f / squared) / (std_dev * std_dev);
        }
    }
    StringFit fit{.modes = modes, .covariance = Eigen::Matrix2d::Zero(), .is_stiff = is_stiff};
    if (is_stiff) {
        const double determinant = normal(0, 0) * normal(1, 1) - normal(0, 1) * normal(0, 1);
        fit.covariance << normal(1, 1), -normal(0, 1), -normal(0, 1), normal(0, 0);
        fit.covariance /= determinant;
    } else {
        fit.covariance(0, 0) = 1.0 / normal(0, 0);
    }
    const Eigen::Vector2d estimate = fit.covariance * right;
    fit.string = {.squared_f0 = estimate(0), .inharmonicity = estimate(1) / estimate(0)};
    return fit;
}

StringFit scattered_fit(const std::vector<FrequencyPeak>& peaks, const std::vector<int>& modes) {
    constexpr double expected_part = 0.002;
    constexpr double expected_squares = 2.0;
    const bool is_stiff = explained_peaks(modes) >= 3;
    const auto freedom = static_cast<double>(explained_peaks(modes) - (is_stiff ? 2 : 1));
    const auto fit_with = [&](double part) {
        StringFit fit = fit_string(peaks, modes, is_stiff, part);
        if (fit.string.inharmonicity < 0.0) {
            fit.string = fit_string(peaks, modes, false, part).string;
        }
        fit.part = part;
        return fit;
    };
    const auto excess = [&](const StringFit& fit) {
        double sum = expected_squares * (std::pow(expected_part / fit.part, 2) - 1.0) - freedom;
        for (size_t i = 0; i < peaks.size(); ++i) {
            sum += modes[i] > 0 ? std::pow((peaks[i].frequency - fit.string.frequency(modes[i])) /
                                               total_std(peaks[i], fit.part),
                                           2)
                                : 0.0;
        }
        return sum;
    };
    double low = 1e-4;
    double high = 0.1;
    while (high > 1.01 * low) {
        const double part = std::sqrt(low * high);
        (excess(fit_with(part)) > 0.0 ? low : high) = part;
    }
    return fit_with(high);
}

}  // namespace taut
