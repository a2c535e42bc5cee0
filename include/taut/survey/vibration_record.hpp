// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "taut/export/core.hpp"

namespace taut {

/// A vibration record of a cable, sampled evenly.
struct VibrationRecord {
    double rate = 0.0;  ///< samples in a second [Hz]
    /// A column each of a sensor's axes (n x c): accelerations, or any signals that are linear in
    /// the motion, all in one unit.
    Eigen::MatrixXd signals;
    double jitter = 0.0;  ///< RMS of time steps about their mean, as a part of it, as measured
    bool is_resampled = false;  ///< whether it was brought to even times
};

/// Why samples are no record.
struct RecordFault {
    Eigen::Index sample = 0;  ///< from 0
    std::string what;         ///< field, value and rule
};

/// The first fault of samples: a time or signal that is not finite, a time that is not after the
/// one before, a gap of more than 5 median steps, or a median rate outside of 5 Hz to 1 MHz.
/// @param time of each sample (n) [s]
/// @param signals (n x c)
[[nodiscard]] TAUT_CORE_EXPORT std::optional<RecordFault> record_fault(
    const Eigen::VectorXd& time, const Eigen::MatrixXd& signals);

/// Brings samples to even times: as they are where no time is off by more than a hundredth of a
/// step, else by linear interpolation at the median step. Of several columns one that is the
/// magnitude of all others is left out: it is not linear, and holds doubled frequencies.
/// @param time of each sample, ascending (n) [s]
/// @param signals (n x c)
/// @throws std::invalid_argument for a fault, and for two samples or fewer
[[nodiscard]] TAUT_CORE_EXPORT VibrationRecord evenly_sampled(const Eigen::VectorXd& time,
                                                              const Eigen::MatrixXd& signals);

}  // namespace taut
