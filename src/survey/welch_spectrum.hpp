// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "taut/export/core.hpp"
#include "taut/survey/vibration_record.hpp"

namespace taut {

/// The one-sided power spectral density of a record, and of parts of it.
struct WelchSpectrum {
    double step = 0.0;        ///< between bins, the first of which is 0 Hz [Hz]
    double resolution = 0.0;  ///< 1 / length of a segment [Hz]
    int segments = 0;         ///< averaged
    /// The mean over all segments, summed over the columns of the record (bins) [unit^2/Hz].
    Eigen::VectorXd density = {};
    /// The part that segments of one time add to the mean, in the order of time (bins x groups).
    Eigen::MatrixXd groups = {};
};

/// Welch's method: the mean periodogram of segments that overlap by half, each without its linear
/// trend and under a periodic Hann window, padded with zeros to at least twice its length. P. D.
/// Welch, The use of fast Fourier transform for the estimation of power spectra, IEEE Trans. Audio
/// Electroacoust. 15 (1967). The same as scipy.signal.welch(detrend="linear", nperseg=segment,
/// nfft=the padded length).
/// @param segment samples in one, 8 to those of the record
[[nodiscard]] TAUT_CORE_EXPORT WelchSpectrum welch_spectrum(const VibrationRecord& record,
                                                            Eigen::Index segment);

}  // namespace taut
