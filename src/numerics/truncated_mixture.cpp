// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "numerics/truncated_mixture.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace taut {
namespace {

/// A part whose bounds lie further from its mean than this number of standard deviations is a spike
/// at the nearer bound: its mean is moved to this distance, its height at the bound is kept.
constexpr double furthest_mean = 30.0;

/// With a standard deviation above this many widths, a part is constant up to rounding errors.
constexpr double widest_std = 1e4;

/// Beyond this many standard deviations a normal density is negligible.
constexpr double normal_reach = 40.0;

double log_density(const TruncatedNormal& part, double x) {
    const double z = part.std_dev < std::numeric_limits<double>::infinity()
                         ? (x - part.mean) / part.std_dev
                         : 0.0;
    return part.log_height - 0.5 * z * z;
}

double nearest(const TruncatedNormal& part) {
    return std::clamp(part.mean, part.lower, part.upper);
}

/// The same part, with parameters for which the formulas below are accurate.
TruncatedNormal tame(TruncatedNormal part) {
    if (part.std_dev > widest_std * (part.upper - part.lower)) {
        part.log_height = log_density(part, nearest(part));
        part.std_dev = std::numeric_limits<double>::infinity();
        return part;
    }
    const double bound = nearest(part);
    const double away = furthest_mean * part.std_dev;
    if (std::abs(part.mean - bound) > away) {
        part.log_height = log_density(part, bound) + 0.5 * furthest_mean * furthest_mean;
        part.mean = bound + std::copysign(away, part.mean - bound);
    }
    return part;
}

/// Integral of exp(-z^2/2) from a to b, without loss of digits in the tails.
double normal_integral(double a, double b) {
    constexpr double root = std::numbers::sqrt2 / 2.0;
    const double half = std::sqrt(std::numbers::pi / 2.0);
    if (a > 0.0) {
        return half * (std::erfc(root * a) - std::erfc(root * b));
    }
    if (b < 0.0) {
        return half * (std::erfc(-root * b) - std::erfc(-root * a));
    }
    return half * (std::erf(root * b) - std::erf(root * a));
}

struct Moments {
    double mass;
    double mean;
    double variance;
};

/// Mass of a part between its lower bound and x.
double mass_below(const TruncatedNormal& part, double x, double log_scale) {
    const double upper = std::clamp(x, part.lower, part.upper);
    const double height = std::exp(part.log_height - log_scale);
    if (!std::isfinite(part.std_dev)) {
        return height * (upper - part.lower);
    }
    return height * part.std_dev *
           normal_integral((part.lower - part.mean) / part.std_dev,
                           (upper - part.mean) / part.std_dev);
}

Moments moments_of(const TruncatedNormal& part, double log_scale) {
    const double mass = mass_below(part, part.upper, log_scale);
    if (!std::isfinite(part.std_dev)) {
        const double width = part.upper - part.lower;
        return {.mass = mass,
                .mean = 0.5 * (part.lower + part.upper),
                .variance = width * width / 12.0};
    }
    // With the density f(z) = exp(-z^2/2) between a and b, of integral Z:
    //   mean (f(a) - f(b)) / Z,   variance 1 + (a f(a) - b f(b)) / Z - mean^2.
    const double a = (part.lower - part.mean) / part.std_dev;
    const double b = (part.upper - part.mean) / part.std_dev;
    const auto f = [](double z) { return std::exp(-0.5 * z * z); };
    const auto zf = [&](double z) { return std::isfinite(z) ? z * f(z) : 0.0; };
    const double Z = normal_integral(a, b);
    if (!(Z > 0.0)) {
        return {.mass = 0.0, .mean = nearest(part), .variance = 0.0};
    }
    const double mean = (f(a) - f(b)) / Z;
    const double variance = std::max(0.0, 1.0 + (zf(a) - zf(b)) / Z - mean * mean);
    return {.mass = mass,
            .mean = part.mean + part.std_dev * mean,
            .variance = part.std_dev * part.std_dev * variance};
}

}  // namespace

TruncatedMixture::TruncatedMixture(const std::vector<TruncatedNormal>& parts)
    : m_log_scale(-std::numeric_limits<double>::infinity()) {
    for (const TruncatedNormal& part : parts) {
        if (part.lower < part.upper) {
            m_parts.push_back(tame(part));
            m_log_scale = std::max(m_log_scale, log_density(part, nearest(part)));
        }
    }
    for (const TruncatedNormal& part : m_parts) {
        m_mass += mass_below(part, part.upper, m_log_scale);
    }
}

std::pair<double, double> TruncatedMixture::moments() const {
    double first = 0.0;
    for (const TruncatedNormal& part : m_parts) {
        const Moments m = moments_of(part, m_log_scale);
        first += m.mass * m.mean;
    }
    const double mean = first / m_mass;
    double second = 0.0;
    for (const TruncatedNormal& part : m_parts) {
        const Moments m = moments_of(part, m_log_scale);
        second += m.mass * (m.variance + (m.mean - mean) * (m.mean - mean));
    }
    return {mean, second / m_mass};
}

double TruncatedMixture::cumulative(double x) const {
    double below = 0.0;
    for (const TruncatedNormal& part : m_parts) {
        below += mass_below(part, x, m_log_scale);
    }
    return below / m_mass;
}

double TruncatedMixture::marked() const {
    double marked = 0.0;
    for (const TruncatedNormal& part : m_parts) {
        marked += part.is_marked ? mass_below(part, part.upper, m_log_scale) : 0.0;
    }
    return marked / m_mass;
}

double TruncatedMixture::quantile(double p) const {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    for (const TruncatedNormal& part : m_parts) {
        lower = std::min(lower, std::max(part.lower, nearest(part) - normal_reach * part.std_dev));
        upper = std::max(upper, std::min(part.upper, nearest(part) + normal_reach * part.std_dev));
    }
    if (!(upper > lower)) {
        return lower;  // all of it is one number
    }
    // Measured from the lower end, so that a narrow distribution far from zero loses no digits.
    constexpr int bits = 40;
    std::uintmax_t evaluations = 100;
    const auto [below, above] = boost::math::tools::toms748_solve(
        [&](double step) { return cumulative(lower + step) - p; }, 0.0, upper - lower, -p, 1.0 - p,
        boost::math::tools::eps_tolerance<double>(bits), evaluations);
    return lower + 0.5 * (below + above);
}

}  // namespace taut
