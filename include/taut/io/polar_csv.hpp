// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "taut/export/io.hpp"
#include "taut/survey/station_adjustment.hpp"

namespace taut {

/// An angle written with its unit, "0.3mgon", "1arcsec", "5 mrad"; the units are gon, mgon, deg,
/// arcsec, rad, mrad.
struct AngleText {
    double angle;  ///< [rad]
    double
        full_unit;  ///< of observed angles, where a precision has this unit: gon, degree or 1 [rad]
};

/// Reads an angle with its unit.
/// @throws std::invalid_argument for anything else, naming the text
[[nodiscard]] TAUT_IO_EXPORT AngleText parse_angle(std::string_view text);

/// Reads a precision, "1mm+1.5ppm", "1mm".
/// @throws std::invalid_argument for anything else, naming the text
[[nodiscard]] TAUT_IO_EXPORT DistancePrecision parse_distance_precision(std::string_view text);

/// Whether the first line of a text is the header of observations: it names station, target and hz.
[[nodiscard]] TAUT_IO_EXPORT bool is_polar_csv(std::string_view text);

/// Reads observations of instruments, one pointing a line, by a header in any order:
///
///     station,target,hz [gon],v [gon],distance [m],target_height [m],angle_std [mgon],
///     distance_std [mm]
///
/// of which the last three may be left out. hz is the direction, clockwise, v the zenith angle (of
/// the second face more than half a circle), distance the slope distance. Units as those of
/// parse_angle(), m and mm; lengths without a unit are in m.
/// @param given_unit of hz and v where the header has none [rad]
/// @param file_name for messages
/// @throws InputError with the line, for anything else: a column that is missing, or of another
///   name; angles without a unit or above a full circle; what is no number
[[nodiscard]] TAUT_IO_EXPORT PolarSurvey parse_polar_csv(std::string_view text,
                                                         const std::string& file_name,
                                                         std::optional<double> given_unit = {});

/// Observations as parse_polar_csv() reads them back, in gon, to a part in 10^12.
/// @param survey whose observations are of stations that it has, not checked
[[nodiscard]] TAUT_IO_EXPORT std::string polar_to_csv(const PolarSurvey& survey);

}  // namespace taut
