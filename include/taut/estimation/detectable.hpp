// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace taut {

/// The smallest errors that the checks of a survey would have shown: an error of this size, at a
/// place and in a direction drawn at random, is found with a probability of 80 % (minimal
/// detectable bias, W. Baarda 1968). docs/theory.md, (detectable). Infinite: of this kind nothing
/// is found with that probability, or nothing is tested.
struct DetectableErrors {
    /// Distance of a target from its node [m].
    double target = std::numeric_limits<double>::infinity();
    /// Error of one interior edge's length, in addition to its deviation [m].
    double length = std::numeric_limits<double>::infinity();
    /// Of one adjustable edge's length [m].
    double adjustable = std::numeric_limits<double>::infinity();
    /// Distance of one support from its place as designed [m].
    double support = std::numeric_limits<double>::infinity();
    /// Of the survey's scale, relative [-].
    double scale = std::numeric_limits<double>::infinity();
    /// Difference of temperature of all interior edges, with 12e-6/K where the net gives no
    /// expansion; infinite above 100 K, which no site has [K].
    double temperature = std::numeric_limits<double>::infinity();
    /// Of one force measurement, relative [-].
    double force = std::numeric_limits<double>::infinity();
    /// Of all force measurements, by the same part; infinite for fewer than two [-].
    double force_scale = std::numeric_limits<double>::infinity();
    /// Vertical, at each free node, besides the loads given; infinite above the mean tension [N].
    double load = std::numeric_limits<double>::infinity();
};

}  // namespace taut
