// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "estimation/length_posterior.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// Likelihood of a prior, given the estimate of each length without its prior, docs/theory.md
/// (prior-check). The errors of the lengths are correlated, so it is a composite likelihood.
class PriorLikelihood {
public:
    /// @param prior of the fit; lengths known to less than twice its standard deviation are used
    /// @param likelihoods of each interior edge's length, without its prior (m_I)
    /// @param left_out edges (m_I) that are outliers, or of another prior
    PriorLikelihood(const LengthPrior& prior, const std::vector<LengthLikelihood>& likelihoods,
                    const std::vector<bool>& left_out);

    /// How many lengths it rests on.
    [[nodiscard]] int count() const { return static_cast<int>(m_lengths.size()); }
    /// log L of another prior.
    [[nodiscard]] double operator()(const LengthPrior& prior) const;
    /// The likeliest prior of a kind, with a scale within a factor of ten of the fit's.
    [[nodiscard]] LengthPrior likeliest(LengthPrior::Kind kind) const;

private:
    double m_prior_std;                                ///< [m]
    std::vector<std::pair<double, double>> m_lengths;  ///< mean, standard deviation [m]
};

/// Rounds the scale to a hundredth of a millimetre, or to two digits where it is small.
[[nodiscard]] LengthPrior rounded(const LengthPrior& prior);

}  // namespace taut
