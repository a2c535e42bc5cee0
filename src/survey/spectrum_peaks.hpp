// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "survey/welch_spectrum.hpp"
#include "taut/survey/cable_frequency.hpp"

namespace taut {

/// Peaks of a spectrum that noise does not explain, ascending in frequency, 24 at most: those
/// highest above the noise. A peak lies above the local noise floor by more than chance allows in
/// any bin, falls off on both sides by more than chance allows, and is no side lobe of a higher
/// one. Its frequency is that of the parabola through the logarithms of three bins.
/// @param duration of the record [s]
[[nodiscard]] TAUT_CORE_EXPORT std::vector<FrequencyPeak> spectrum_peaks(
    const WelchSpectrum& spectrum, double duration, const FrequencyRange& range);

}  // namespace taut
