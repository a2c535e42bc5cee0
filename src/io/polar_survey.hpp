// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "io/survey_file.hpp"
#include "taut/survey/station_adjustment.hpp"

namespace taut {

/// Targets from observations, in a frame of their own, by adjust_stations(). The precision is that
/// of the file, else of the options, else of a common total station, with a warning.
/// @param format of the file, in words
/// @throws InputError with the line, as adjust_stations(), and where the angles do not give the
///   shape of the net in their unit, but do in another
[[nodiscard]] SurveyFile targets_of_observations(const CableNet& net, PolarSurvey observations,
                                                 const ReadSurveyOptions& options,
                                                 const std::string& format,
                                                 const std::string& file_name);

}  // namespace taut
