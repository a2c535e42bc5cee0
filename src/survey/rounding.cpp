// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut {
namespace {

/// Smaller steps count as exact: they are far below what any instrument measures.
constexpr double least_step = 5e-8;  // m

/// Decimals of a number, `most` where it has more.
int decimals_of(double number, int most) {
    // The nearest double is off by half a last bit, and so is its product with a power of ten.
    constexpr double tolerance = 4.0 * std::numeric_limits<double>::epsilon();
    double power = 1.0;
    for (int decimals = 0; decimals < most; ++decimals, power *= 10.0) {
        const double multiple = number * power;
        if (std::abs(multiple - std::round(multiple)) <= tolerance * std::abs(multiple)) {
            return decimals;
        }
    }
    return most;
}

}  // namespace

double rounding_step(const std::vector<SurveyPoint>& points, double unit) {
    constexpr double most_part = 0.95;
    constexpr int most_digits = 15;  // of a number that a double keeps
    std::vector<int> decimals;
    double largest = 0.0;
    const int most = static_cast<int>(std::ceil(std::log10(unit / least_step)));
    for (const SurveyPoint& point : points) {
        for (const double number : point.position) {
            decimals.push_back(decimals_of(number, most));
            largest = std::max(largest, std::abs(number));
        }
    }
    if (decimals.empty() || most <= 0) {
        return 0.0;
    }
    const auto place = static_cast<std::ptrdiff_t>(
        std::ceil(most_part * static_cast<double>(decimals.size())) - 1.0);
    std::ranges::nth_element(decimals, decimals.begin() + place);
    const int found = decimals[static_cast<size_t>(place)];
    const bool is_to_the_last_digit = largest * std::pow(10.0, found) >= std::pow(10, most_digits);
    return found >= most || is_to_the_last_digit ? 0.0 : unit * std::pow(10.0, -found);
}

double rounding_std(double step) {
    return step / std::sqrt(12.0);
}

double noise_with_rounding(double noise_std, double rounding) {
    constexpr double least_part = 1.0 / 3.0;
    return noise_std > 0.0 && rounding > least_part * noise_std ? std::hypot(noise_std, rounding)
                                                                : noise_std;
}

}  // namespace taut
