// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "taut/io/read_survey.hpp"

namespace taut {

/// What stands in a survey file, of any format, before it is brought to the nodes of a net.
struct SurveyFile {
    std::vector<SurveyPoint> points;    ///< [m], as many as the file holds
    std::vector<std::string> notes;     ///< how it was understood; empty: it is taut's own CSV
    std::vector<std::string> warnings;  ///< what was guessed
    int contradicted_names = 0;         ///< as Survey has it
    bool is_own = false;                ///< whether it is taut's own CSV, read strictly
    std::string unit_hint;              ///< added where the survey does not fit the net
    double unit = 1.0;                  ///< that its numbers were taken in [m]
    bool has_known_points = false;      ///< as ForeignSurvey has them
    bool is_of_observations = false;    ///< of angles and distances, not of coordinates
    double scale_std = 0.0;  ///< common to all points, of observations from several stations [-]
    double rounding = 0.0;   ///< step to which coordinates are rounded; 0: none [m]
};

/// Reads taut's own CSV as parse_survey_points() does, all else as read_foreign_survey().
/// The unit is that of the options, else of the file, else the metre for taut's own CSV, else
/// guessed by the net's extent.
/// @throws InputError as these two, and where no unit fits
[[nodiscard]] SurveyFile read_survey_file(const CableNet& net, const std::filesystem::path& path,
                                          const ReadSurveyOptions& options);

}  // namespace taut
