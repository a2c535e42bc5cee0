// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "taut/estimation/length_posterior.hpp"
#include "taut/sampling/length_prior.hpp"

namespace taut {

/// How well a prior explains what a survey tells of each length without its prior, docs/theory.md
/// (prior-check): of lengths whose errors are correlated a composite likelihood.
class PriorLikelihood {
public:
    /// @param prior reckoned with: what is known to less than twice its standard deviation is used
    /// @param told of each interior edge without its prior (m_I)
    /// @param left_out edges (m_I) that are beyond it, or of another prior
    PriorLikelihood(const LengthPrior& prior, const std::vector<LengthLikelihood>& told,
                    const std::vector<bool>& left_out);

    /// How many lengths it rests on.
    [[nodiscard]] int count() const { return static_cast<int>(m_lengths.size()); }
    /// log L of another prior.
    [[nodiscard]] double operator()(const LengthPrior& prior) const;
    /// Of a kind, the scale within a factor of ten of the prior's that is likeliest.
    [[nodiscard]] LengthPrior likeliest(LengthPrior::Kind kind) const;

private:
    double m_prior_std;                                ///< [m]
    std::vector<std::pair<double, double>> m_lengths;  ///< mean, standard deviation [m]
};

/// With a scale to a hundredth of a millimetre, or to two digits where that is much of it: nobody
/// reads more.
[[nodiscard]] LengthPrior rounded(const LengthPrior& prior);

}  // namespace taut
