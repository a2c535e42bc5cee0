// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "estimation/detectable_error.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace taut {
namespace {

/// Of more items only every few are used: more change nothing.
constexpr size_t most_items = 200;

double upper_tail(double z) {
    return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

/// P(chi'^2 > threshold) with the noncentrality a^2: Marcum's Q of order 1/2 and 3/2, in closed
/// form.
double power_of(double a, double threshold, int degrees_of_freedom) {
    const double b = std::sqrt(threshold);
    const double of_one = upper_tail(b - a) + upper_tail(b + a);
    if (degrees_of_freedom == 1) {
        return of_one;
    }
    constexpr double small = 1e-4;
    const double density = std::exp(-0.5 * (b - a) * (b - a));
    const double difference =
        a > small ? (density - std::exp(-0.5 * (b + a) * (b + a))) / a : 2.0 * b * density;
    return of_one + difference / std::sqrt(2.0 * std::numbers::pi);
}

/// Directions spread evenly over half a sphere, each of length 1.
std::array<Eigen::Vector3d, 13> directions() {
    std::array<Eigen::Vector3d, 13> all;
    size_t count = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (9 * x + 3 * y + z > 0) {
                    all[count++] = Eigen::Vector3d(x, y, z).normalized();
                }
            }
        }
    }
    return all;
}

/// The error at which an increasing power reaches detection_power.
template <class Power>
double error_of(const Power& power, double first) {
    constexpr double most = 1e9;  // of the first
    double above = first;
    while (power(above) < detection_power) {
        above *= 2.0;
        if (!(above < most * first)) {
            return std::numeric_limits<double>::infinity();
        }
    }
    constexpr int bits = 20;
    std::uintmax_t most_iterations = 60;
    const auto found = boost::math::tools::toms748_solve(
        [&](double error) { return power(error) - detection_power; }, 0.0, above,
        boost::math::tools::eps_tolerance<double>(bits), most_iterations);
    return found.second;
}

}  // namespace

double detectable_error(const std::vector<TestedItem>& items, double threshold,
                        int degrees_of_freedom) {
    std::vector<double> rates;  // square roots of noncentralities by 1 m
    double largest = 0.0;
    const size_t stride = items.size() / most_items + 1;
    for (size_t i = 0; i < items.size(); i += stride) {
        const Eigen::MatrixXd& of_item = items[i].noncentrality;
        if (of_item.rows() == 1) {
            rates.push_back(std::sqrt(std::max(0.0, of_item(0, 0))));
            largest = std::max(largest, rates.back());
            continue;
        }
        for (const Eigen::Vector3d& direction : directions()) {
            rates.push_back(std::sqrt(std::max(0.0, direction.dot(of_item * direction))));
            largest = std::max(largest, rates.back());
        }
    }
    // Not finite: rounding left nothing of a variance, and the test says nothing.
    if (!(largest > 0.0) || !std::isfinite(largest) || !std::isfinite(threshold)) {
        return std::numeric_limits<double>::infinity();
    }
    const auto power = [&](double error) {
        double sum = 0.0;
        for (const double rate : rates) {
            sum += power_of(rate * error, threshold, degrees_of_freedom);
        }
        return sum / static_cast<double>(rates.size());
    };
    return error_of(power, 1.0 / largest);
}

double detectable_error(const std::vector<BoundedEstimate>& estimates) {
    const size_t stride = estimates.size() / most_items + 1;
    std::vector<BoundedEstimate> taken;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < estimates.size(); i += stride) {
        taken.push_back(estimates[i]);
        if (estimates[i].std_dev > 0.0) {
            least = std::min(least, estimates[i].std_dev);
        }
    }
    if (!std::isfinite(least)) {
        return std::numeric_limits<double>::infinity();
    }
    const auto power = [&](double error) {
        double sum = 0.0;
        for (const auto& [bound, std_dev] : taken) {
            if (std::isfinite(bound) && std_dev > 0.0) {
                sum +=
                    upper_tail((bound - error) / std_dev) + upper_tail((bound + error) / std_dev);
            }
        }
        return sum / static_cast<double>(taken.size());
    };
    return error_of(power, least);
}

}  // namespace taut
