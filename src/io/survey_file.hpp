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
    bool is_own = false;                ///< whether it is taut's own CSV, to be kept to strictly
    std::string unit_hint;              ///< what to tell where the survey does not fit the net
    double unit = 1.0;                  ///< that its numbers were taken in [m]
    bool has_known_points = false;      ///< as ForeignSurvey has them
    bool is_of_readings = false;        ///< of angles and distances, not of coordinates
    double scale_std = 0.0;  ///< common to all points, of readings from several stations [-]
    double rounding = 0.0;   ///< the step to which coordinates are written; 0: as doubles are [m]
};

/// Reads taut's own CSV as parse_survey_points() does, all else as read_foreign_survey().
/// The unit is that which is told, else the file's, else of taut's own CSV the metre, else guessed
/// by the net's extent.
/// @throws InputError as these two, and where no unit fits
[[nodiscard]] SurveyFile read_survey_file(const CableNet& net, const std::filesystem::path& path,
                                          const ReadSurveyOptions& options);

}  // namespace taut
