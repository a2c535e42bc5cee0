// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "taut/estimation/length_posterior.hpp"
#include "taut/sampling/length_law.hpp"

namespace taut {

/// How well a law explains what a survey tells of each length without its law, docs/theory.md
/// (law-check): of lengths whose errors are correlated a composite likelihood.
class LawLikelihood {
public:
    /// @param law reckoned with: what is known to less than twice its standard deviation is used
    /// @param told of each interior edge without its law (m_I)
    /// @param left_out edges (m_I) that are beyond it, or of another law
    LawLikelihood(const LengthLaw& law, const std::vector<LengthLikelihood>& told,
                  const std::vector<bool>& left_out);

    /// How many lengths it rests on.
    [[nodiscard]] int count() const { return static_cast<int>(m_lengths.size()); }
    /// log L of another law.
    [[nodiscard]] double operator()(const LengthLaw& law) const;
    /// Of a kind, the scale within a factor of ten of the law's that is likeliest.
    [[nodiscard]] LengthLaw likeliest(LengthLaw::Kind kind) const;

private:
    double m_law_std;                                  ///< [m]
    std::vector<std::pair<double, double>> m_lengths;  ///< mean, standard deviation [m]
};

/// With a scale to a hundredth of a millimetre, or to two digits where that is much of it: nobody
/// reads more.
[[nodiscard]] LengthLaw rounded(const LengthLaw& law);

}  // namespace taut
