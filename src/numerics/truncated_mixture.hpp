// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

namespace taut {

/// Density exp(log_height - (x - mean)^2 / (2 std^2)) on [lower, upper], zero outside. The std may
/// be infinite between finite bounds: a constant density.
struct TruncatedNormal {
    double log_height = 0.0;
    double mean = 0.0;
    double std_dev = 1.0;
    double lower = 0.0;
    double upper = 0.0;
    bool is_marked = false;
};

/// A sum of truncated normal densities, normalised.
class TruncatedMixture {
public:
    /// Parts with lower >= upper are ignored. At least one part must have lower < upper.
    explicit TruncatedMixture(const std::vector<TruncatedNormal>& parts);

    [[nodiscard]] std::pair<double, double> moments() const;  ///< mean and variance
    [[nodiscard]] double cumulative(double x) const;          ///< P(X <= x)
    [[nodiscard]] double marked() const;                      ///< probability of the marked parts
    /// x with P(X <= x) = p, 0 < p < 1.
    [[nodiscard]] double quantile(double p) const;

private:
    std::vector<TruncatedNormal> m_parts;
    double m_mass = 0.0;  ///< of all parts, in units of exp(m_log_scale)
    double m_log_scale;   ///< largest log density of all parts: keeps masses from underflow
};

}  // namespace taut
