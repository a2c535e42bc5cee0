// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "report/ticks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/number_text.hpp"

namespace taut::report {
namespace {

/// mantissa * 10^exponent
struct Step {
    double mantissa = 1.0;
    int exponent = 0;

    /// A multiple, exact where it can be: dividing by 10 gives 0.3, multiplying by 0.1 does not.
    [[nodiscard]] double times(double count) const {
        const double power = std::pow(10.0, std::abs(exponent));
        return exponent < 0 ? count * mantissa / power : count * mantissa * power;
    }
};

Step nice_step(double at_least) {
    Step step{.exponent = static_cast<int>(std::floor(std::log10(at_least)))};
    for (const double mantissa : {1.0, 2.0, 5.0, 10.0}) {
        step.mantissa = mantissa;
        // A step that is short by rounding errors alone will do.
        if (step.times(1.0) >= at_least * (1.0 - 1e-9)) {
            break;
        }
    }
    return step.mantissa == 10.0 ? Step{1.0, step.exponent + 1} : step;
}

std::string label(double value, const Step& step, bool with_power) {
    if (with_power) {
        return short_number(value);
    }
    const std::string text = fmt::format("{:.{}f}", value, std::max(0, -step.exponent));
    return text.starts_with('-') ? "−" + text.substr(1) : text;
}

}  // namespace

Ticks nice_ticks(double low, double high, int intervals, double smallest_step) {
    Ticks ticks;
    // Steps of ranges below this would leave the range of a double.
    constexpr double smallest_range = 1e-290;
    if (!(high - low > smallest_range) || !std::isfinite(high - low)) {
        return ticks;
    }
    const Step step = nice_step(std::max((high - low) / intervals, smallest_step));
    // An end of the range that is a multiple but for rounding errors counts as one.
    const double first = std::ceil(low / step.times(1.0) - 1e-9);
    const double last = std::floor(high / step.times(1.0) + 1e-9);
    // Decimals of a very fine step, or zeros of a very coarse one, would not fit beside an axis: it
    // takes powers of ten where their three digits can tell the multiples apart.
    const bool with_power = (step.exponent < -5 || step.exponent > 6) &&
                            std::max(std::abs(first), std::abs(last)) < 100.0;
    for (int i = 0; i <= intervals && first + i <= last; ++i) {
        const double value = step.times(first + i) + 0.0;  // + 0 turns -0 into 0
        ticks.values.push_back(value);
        ticks.labels.push_back(label(value, step, with_power));
    }
    return ticks;
}

Ticks decade_ticks(double low, double high) {
    Ticks ticks;
    const int first = static_cast<int>(std::floor(low));
    const int last = static_cast<int>(std::ceil(high));
    const std::vector<double> mantissas = high - low <= 1.0
                                              ? std::vector{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}
                                          : last - first <= 3 ? std::vector{1.0, 2.0, 5.0}
                                                              : std::vector{1.0};
    for (int power = first; power <= last; ++power) {
        for (const double mantissa : mantissas) {
            const double value = std::log10(mantissa) + power;
            if (value >= low && value <= high) {
                ticks.values.push_back(value);
                ticks.labels.push_back(short_number(mantissa * std::pow(10.0, power)));
            }
        }
    }
    return ticks;
}

}  // namespace taut::report
