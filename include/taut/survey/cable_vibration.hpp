// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "taut/export/core.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/forces.hpp"

namespace taut {

/// A straight cable that vibrates freely between its ends.
struct VibratingCable {
    double length = 0.0;             ///< free to vibrate [m]
    double mass = 0.0;               ///< per length [kg/m]
    double bending_stiffness = 0.0;  ///< EI; 0: a string [N m2]
};

/// An edge as a cable that vibrates; mass and bending stiffness are 0 where the net has none.
/// @param form in which it vibrates (3 x n) [m]
/// @throws std::invalid_argument for an edge out of range
[[nodiscard]] TAUT_CORE_EXPORT VibratingCable vibrating_cable(const CableNet& net,
                                                              const Points& form, int edge);

/// The tension of a cable with a natural frequency of transverse vibration, docs/theory.md
/// (frequency). Hinged ends: T = m (2 l f / n)^2 - EI (n pi / l)^2. Fixed ends: the root of the
/// characteristic equation of a beam under tension (A. Bokaian, J. Sound Vib. 142 (1990) 481-498).
/// @param frequency [Hz]
/// @param mode number of half waves, from 1
/// @return [N]; negative where the cable without tension vibrates faster
/// @throws std::invalid_argument for a frequency, length or mass that is not positive, a negative
///   bending stiffness, a mode below 1, unknown ends
[[nodiscard]] TAUT_CORE_EXPORT double tension_of_frequency(const VibratingCable& cable,
                                                           double frequency, int mode,
                                                           CableEnds ends);

/// A natural frequency of an edge.
struct FrequencyMeasurement {
    int edge = 0;            ///< index in the net
    double frequency = 0.0;  ///< [Hz]
    int mode = 1;            ///< number of half waves
    double std_dev = 0.0;    ///< standard deviation [Hz]
};

/// The force measurement that a natural frequency amounts to, with what is not known of the cable
/// in its standard deviations:
/// - its own: frequency and free length, which clamps shorten;
/// - shared with all others: ends between hinged and fixed, if the net does not say which; the
///   bending stiffness, if the net has none, between zero and half that of a solid bar with the
///   same EA and mass, of steel; the sag, which stiffens the first mode in its plane (M. Irvine,
///   Cable Structures, 1981). Each is half its range, over sqrt(3); the tension is that of the
///   middle.
/// The mass is that of the net. Its error is the uncertain parameter "mass".
/// @param form in which the cable vibrates (3 x n) [m]
/// @param free_length_std of its length [m]
/// @throws std::invalid_argument for an edge out of range, of a net without masses, without mass,
/// with a tension that is not positive, and where it sags so much that it is no
///   string (Irvine's parameter above 1)
[[nodiscard]] TAUT_CORE_EXPORT ForceMeasurement
tension_by_frequency(const CableNet& net, const Points& form, const FrequencyMeasurement& measured,
                     double free_length_std);

/// The first natural frequency of an edge of which tension_by_frequency() gives this tension [Hz].
/// @param length between its ends [m]
/// @return nothing where the net has no mass of it, it has no tension, or it is no string
/// @throws std::invalid_argument for an edge out of range
[[nodiscard]] TAUT_CORE_EXPORT std::optional<double> expected_frequency(const CableNet& net,
                                                                        int edge, double length,
                                                                        double tension);

}  // namespace taut
