// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "gp/length_scale_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace taut::gp {
namespace {

/// Looked at first, evenly spread over the range of log lambda.
constexpr int first_points = 4;

/// Points closer than this in log lambda tell nothing new.
constexpr double closest = 1e-3;

struct Minimum {
    double at;
    double value;
};

/// Smallest value of the cubic with given values and slopes at both ends of [a, b].
Minimum cubic_minimum(double a, double b, double value_a, double value_b, double slope_a,
                      double slope_b) {
    Minimum best = value_a <= value_b ? Minimum{a, value_a} : Minimum{b, value_b};
    // p(t) = value_a + c1 t + c2 t^2 + c3 t^3 with t = (x - a) / h; p' = 0 is quadratic.
    const double h = b - a;
    const double c1 = h * slope_a;
    const double c2 = 3.0 * (value_b - value_a) - h * (2.0 * slope_a + slope_b);
    const double c3 = 2.0 * (value_a - value_b) + h * (slope_a + slope_b);
    const double discriminant = c2 * c2 - 3.0 * c1 * c3;
    if (discriminant < 0.0) {
        return best;
    }
    // The root with p'' > 0, written without cancellation.
    const double root = std::sqrt(discriminant);
    const double t = c2 >= 0.0 ? -c1 / (c2 + root) : (root - c2) / (3.0 * c3);
    if (std::isfinite(t) && t > 0.0 && t < 1.0) {
        const double value = value_a + t * (c1 + t * (c2 + t * c3));
        if (value < best.value) {
            best = {a + t * h, value};
        }
    }
    return best;
}

}  // namespace

LengthScaleSearch::LengthScaleSearch(double lower_log_lambda, double upper_log_lambda,
                                     double relative_tolerance)
    : m_lower(lower_log_lambda), m_upper(upper_log_lambda), m_tolerance(relative_tolerance) {}

void LengthScaleSearch::add(double log_lambda, LikelihoodProfile profile) {
    m_profiles.emplace(log_lambda, std::move(profile));
}

std::vector<double> LengthScaleSearch::best() const {
    const Eigen::Index m = m_profiles.begin()->second.value.size();
    std::vector<double> result(static_cast<size_t>(m));
    for (Eigen::Index j = 0; j < m; ++j) {
        result[static_cast<size_t>(j)] =
            std::ranges::min_element(m_profiles, {}, [j](const auto& p) {
                return p.second.value(j);
            })->first;
    }
    return result;
}

std::optional<double> LengthScaleSearch::next() const {
    if (m_profiles.size() < first_points) {
        return m_lower +
               (m_upper - m_lower) * static_cast<double>(m_profiles.size()) / (first_points - 1);
    }
    // For each output, the best point of its interpolant beside its best point so far.
    const std::vector<double> best_so_far = best();
    std::vector<Minimum> wishes;  // where, and how much is gained (as a negative value)
    for (size_t output = 0; output < best_so_far.size(); ++output) {
        const auto j = static_cast<Eigen::Index>(output);
        const auto here = m_profiles.find(best_so_far[output]);
        const double value = here->second.value(j);
        Minimum wish{here->first, value};
        const auto look_between = [&](auto left, auto right) {
            const Minimum found = cubic_minimum(left->first, right->first, left->second.value(j),
                                                right->second.value(j), left->second.slope(j),
                                                right->second.slope(j));
            if (found.value < wish.value) {
                wish = found;
            }
        };
        if (here != m_profiles.begin()) {
            look_between(std::prev(here), here);
        }
        if (std::next(here) != m_profiles.end()) {
            look_between(here, std::next(here));
        }
        const bool is_new = std::ranges::all_of(
            m_profiles, [&](const auto& p) { return std::abs(p.first - wish.at) > closest; });
        if (is_new && value - wish.value > m_tolerance * std::max(1.0, std::abs(value))) {
            wishes.push_back({wish.at, wish.value - value});
        }
    }
    if (wishes.empty()) {
        return std::nullopt;
    }
    // The wish at the middle of all gains: half of what can be gained lies on either side.
    std::ranges::sort(wishes, {}, &Minimum::at);
    double total = 0.0;
    for (const Minimum& wish : wishes) {
        total += wish.value;
    }
    double sum = 0.0;
    for (const Minimum& wish : wishes) {
        sum += wish.value;
        if (sum <= 0.5 * total) {
            return wish.at;
        }
    }
    return wishes.back().at;
}

}  // namespace taut::gp
