// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "taut/export/core.hpp"
#include "taut/survey/vibration_record.hpp"

namespace taut {

/// Where a frequency lies.
struct FrequencyRange {
    double lowest = 0.0;   ///< [Hz]
    double highest = 0.0;  ///< [Hz]
};

/// A peak of the spectrum of a record.
struct FrequencyPeak {
    double frequency = 0.0;  ///< [Hz]
    double std_dev = 0.0;    ///< standard deviation of the frequency [Hz]
    double level = 0.0;      ///< density at the peak over that of the noise around it
    int mode = 0;            ///< number by the likeliest fundamental, from 1; 0: not explained
};

/// A fundamental that may explain the peaks: mode n of a hinged string with bending stiffness has
///     f_n = n f_0 sqrt(1 + B n^2),  f_0 = sqrt(T/m) / (2 l),  B = pi^2 EI / (T l^2)
/// for the tension T, mass per length m, length l and bending stiffness EI. H. Fletcher, Normal
/// vibration frequencies of a stiff piano string, J. Acoust. Soc. Am. 36 (1964).
struct Fundamental {
    double frequency = 0.0;      ///< f_1, by the fit to all its peaks [Hz]
    double std_dev = 0.0;        ///< standard deviation of f_1 [Hz]
    double inharmonicity = 0.0;  ///< B, 0 where the peaks show none
    double misfit = 0.0;         ///< RMS over its peaks of (f - f_n) / f_n
    std::vector<int> modes;      ///< of each peak; 0: not explained
    double probability = 0.0;    ///< among all fundamentals and that there is none
};

/// What a record shows of a cable's natural frequencies.
struct CableFrequency {
    std::vector<FrequencyPeak> peaks;        ///< ascending in frequency
    std::optional<Fundamental> fundamental;  ///< only where nothing speaks against it
    std::string message;                     ///< why there is none
    bool needs_range =
        false;  ///< whether a range of the fundamental, or a narrower one, may decide
    std::vector<Fundamental> candidates;  ///< likeliest first, at most 5
    std::vector<std::string> warnings;    ///< what is most likely wrong
    FrequencyRange searched;              ///< for peaks
    double duration = 0.0;                ///< of the record [s]
    double resolution = 0.0;              ///< 1 / length of a segment [Hz]
    double spectrum_step = 0.0;           ///< between values of spectrum, from 0 Hz [Hz]
    Eigen::VectorXd spectrum;             ///< one-sided power spectral density [unit^2/Hz]
};

/// Finds the natural frequencies of a cable in a record, numbers their modes, and fits one
/// fundamental: docs/theory.md, (string modes). Peaks without a mode, modes without a peak and an
/// octave are weighed by (mode numbers).
/// @param range where the fundamental is known to lie; it is then taken for granted that there is
///   one, and a single peak suffices
/// @throws std::invalid_argument for fewer than 256 samples, more than 2^27 numbers, a rate, range
///   or number that makes no sense, and signals that are constant
[[nodiscard]] TAUT_CORE_EXPORT CableFrequency
cable_frequency(const VibrationRecord& record, const std::optional<FrequencyRange>& range = {});

}  // namespace taut
