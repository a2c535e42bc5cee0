// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>

#include "taut/gp/likelihood.hpp"

namespace taut::gp {

/// Which lambda to look at next, so that every one of m outputs comes close to its own best one
/// with few decompositions. Knows the profiles (value and slope over log lambda) at the points
/// looked at, interpolates each output's between them by cubic Hermite polynomials, and asks for
/// the point where the outputs together expect to gain most.
class LengthScaleSearch {
public:
    /// Every profile seen so far, by log lambda.
    using Profiles = std::map<double, LikelihoodProfile>;

    /// @param relative_tolerance gain below which an output is content, of its |value|
    LengthScaleSearch(double lower_log_lambda, double upper_log_lambda, double relative_tolerance);

    /// The next log lambda, or nothing when every output is content.
    [[nodiscard]] std::optional<double> next() const;
    void add(double log_lambda, LikelihoodProfile profile);

    [[nodiscard]] const Profiles& profiles() const { return m_profiles; }
    /// Where each output's value is smallest among the points looked at (m).
    [[nodiscard]] std::vector<double> best() const;

private:
    double m_lower;
    double m_upper;
    double m_tolerance;
    Profiles m_profiles;
};

}  // namespace taut::gp
