// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gp/likelihood_profile.hpp"
#include "taut/gp/likelihood.hpp"

namespace taut::gp {

/// One output's profile at one point.
struct ProfilePoint {
    double at;  ///< log lambda
    double value;
    double slope;
};

/// Chooses the lambdas to try next, so that each of m outputs comes close to its own best one with
/// few decompositions. It interpolates each output's profile (value and slope over log lambda)
/// between the points tried by cubic Hermite polynomials. It asks for the point where the outputs
/// together expect to gain most, then for the one that adds most to that, and so on.
class LengthScaleSearch {
public:
    /// A lambda to try.
    struct Look {
        double log_lambda = 0.0;
        std::vector<Eigen::Index> outputs;  ///< that may gain there; the others need no profile
    };

    /// @param outputs m
    /// @param relative_tolerance gain below which an output is content, of its |value|
    LengthScaleSearch(Eigen::Index outputs, double lower_log_lambda, double upper_log_lambda,
                      double relative_tolerance);

    /// At most `most` (1 or more) lambdas to try next; none when every output is content.
    [[nodiscard]] std::vector<Look> next(int most) const;
    /// Adds the profiles at a lambda.
    /// @param profile of look.outputs, in their order
    void add(const Look& look, const LikelihoodProfile& profile);

    /// Where each output's value is smallest among the points looked at (m).
    [[nodiscard]] std::vector<double> best() const;

private:
    double m_lower;
    double m_upper;
    double m_tolerance;
    int m_looks = 0;
    std::vector<std::vector<ProfilePoint>> m_outputs;  ///< of each, in ascending order
};

}  // namespace taut::gp
