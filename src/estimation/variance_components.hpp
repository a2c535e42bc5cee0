// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include "estimation/linearised_statics.hpp"
#include "estimation/observations.hpp"
#include "taut/estimation/diagnostics.hpp"
#include "taut/net/cable_net.hpp"

namespace taut {

/// The scales of noise and lengths at which both fit the survey (W. Foerstner, Ein Verfahren zur
/// Schaetzung von Varianz- und Kovarianzkomponenten, 1979), docs/theory.md (components): each sum
/// of squares over its redundancy becomes 1.
///
/// @param statics linearised and inverted at the fit; on return at the scales found
/// @param observations of the fit; on return with the scales found
/// @param fitted on return the fit to these
/// @param left_out interior edges (m_I) of another prior
[[nodiscard]] VarianceComponents estimate_components(const CableNet& net,
                                                     LinearisedStatics& statics,
                                                     Observations& observations, Iterate& fitted,
                                                     const std::vector<bool>& left_out);

}  // namespace taut
