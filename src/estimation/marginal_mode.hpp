// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"

namespace taut {

/// From so many uncertain lengths on. The intervals of fewer hold without it, docs/theory.md.
inline constexpr int fewest_for_marginal_mode = 700;

/// The slope of l, half the logarithm of the determinant of a fit, by prior means: by Laplace's
/// approximation the posterior of what many lengths share falls by exp(-l) against the fit's
/// objective. docs/theory.md, (marginal-mode).
class DeterminantSlope {
public:
    /// Keeps references to both.
    DeterminantSlope(const LinearisedFit& fitted, const Observations& observations);

    /// Change of l where the fit follows other prior means, to first order: one factorisation. NaN
    /// where there is none.
    [[nodiscard]] double change(const Observations& moved);

private:
    const LinearisedFit* m_fitted;
    const Observations* m_observations;
    double m_determinant;
    std::optional<Linearisation> m_last;  ///< its memory is used again
};

/// Moves the prior means of common parameters (stiffness, temperature) so that a fit to the result
/// has the mode of their own posterior, lengths and form integrated over. Of few edges both modes
/// agree.
/// @param fitted to the observations
/// @param count of the common parameters: the first ones
[[nodiscard]] Observations with_marginal_mode(const LinearisedFit& fitted,
                                              Observations observations, int count);

}  // namespace taut
