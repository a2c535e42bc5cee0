// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "io/survey_file.hpp"
#include "taut/survey/station_adjustment.hpp"

namespace taut {

/// Targets out of readings, in a frame of their own, by adjust_stations(), with the precision that
/// the readings tell, else that of the options, else that of a common total station, which is
/// warned of.
/// @param format of the file, in words
/// @throws InputError with the line, as adjust_stations(), and where the angles do not give the
///   shape of the net in the unit that was told, but do in another
[[nodiscard]] SurveyFile targets_of_readings(const CableNet& net, PolarSurvey readings,
                                             const ReadSurveyOptions& options,
                                             const std::string& format,
                                             const std::string& file_name);

}  // namespace taut
