// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/linearisation.hpp"
#include "estimation/observations.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The scales of noise and lengths at which both fit the survey (W. Foerstner, Ein Verfahren zur
/// Schaetzung von Varianz- und Kovarianzkomponenten, 1979), docs/theory.md (components): each sum
/// of squares over its redundancy becomes 1. The standard deviation of a ratio of the noise that is
/// too small is that of (held-noise) where this is not significant. Those along an axis are of the
/// first fit; where one is too large, of that with the noise held.
///
/// @param fitted on return the fit to the scales found
/// @param observations of the fit; on return with these
/// @param left_out interior edges (m_I) of another prior
[[nodiscard]] VarianceComponents estimate_components(LinearisedFit& fitted,
                                                     Observations& observations,
                                                     const std::vector<bool>& left_out);

}  // namespace taut
