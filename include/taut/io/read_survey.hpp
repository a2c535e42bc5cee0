// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "taut/export/io.hpp"
#include "taut/interchange/foreign_survey.hpp"
#include "taut/net/cable_net.hpp"
#include "taut/survey/station_adjustment.hpp"
#include "taut/survey/survey.hpp"
#include "taut/survey/target_offsets.hpp"

namespace taut {

/// The frame that a survey's coordinates are in.
enum class SurveyFrame {
    automatic,  ///< the net's if the supports that it names agree, else fitted to them
    net,        ///< the net's
    supports,   ///< fitted to the supports that it names by a rigid motion
};

/// What tells the node of a surveyed point.
enum class PointMatching {
    automatic,  ///< its name where that is a node's, else its place; the places of all where they
                ///< contradict the names
    name,       ///< its name
    place,      ///< its place
};

/// How a survey file is to be read.
struct ReadSurveyOptions {
    /// Standard deviation of each coordinate where the file tells none; empty: that of the rounding
    /// to the digits of the file, 0 where it holds all of a double [m].
    std::optional<double> noise_std = {};
    SurveyFrame frame = SurveyFrame::automatic;  ///< that its coordinates are in
    /// Control points id,x,y,z in the net's frame, to fit the survey's frame to instead of the
    /// supports; empty: none.
    std::filesystem::path control = {};
    SurveyFileOptions file = {};  ///< what is told of the file's format
    /// Of its coordinates, and of its standard deviations where the file tells no other; empty: as
    /// the file tells, or as the net's extent lets guess [m].
    std::optional<double> unit = {};
    PointMatching matching = PointMatching::automatic;  ///< what tells the node of a point
    /// Of readings of angles and distances, where the file tells none; empty: those of a common
    /// total station, which is warned of [rad].
    std::optional<double> angle_std = {};
    /// Of distances, where the file tells none; empty: DistancePrecision{}, which is warned of.
    std::optional<DistancePrecision> distance = {};
    TargetOffsets offsets = {};  ///< of targets from the axes of the cables
};

/// A survey file brought to the nodes of a net: points read (taut's own CSV,
/// parse_survey_points(), or any other format, read_foreign_survey()), or found from readings of
/// angles and distances (parse_polar_csv(), GSI; adjust_stations()), those of one name averaged,
/// their frame fitted (register_rigidly()), put on nodes by name or place (match_to_nodes()), and
/// taken back to the axes of the cables (take_off_offsets()).
/// What was understood of a file that is not taut's own stands in Survey::notes, and to which digit
/// it is rounded where that counts as noise; what was guessed in its warnings.
/// @throws std::invalid_argument for a noise that is negative or not finite, and a unit that is not
///   positive
/// Where some points have standard deviations, one without, or with one of 0, takes the noise of
/// the options, which is warned of.
/// @throws InputError naming the file, its line and the rule: as the functions named, and where two
///   points of one name lie apart, a point has no standard deviations where others have and no
///   noise is given, no unit fits, no free node was surveyed or the noise exceeds the mean edge
///   length
[[nodiscard]] TAUT_IO_EXPORT Survey read_survey(const CableNet& net,
                                                const std::filesystem::path& file,
                                                const ReadSurveyOptions& options = {});

/// The same of points that are there already: their format is none, their unit the metre unless
/// told.
/// @param points a name that is no node's is a label, and points of one name are one target
/// @throws InputError as read_survey(), naming "points" and the line of the point
[[nodiscard]] TAUT_IO_EXPORT Survey read_survey(const CableNet& net,
                                                std::vector<SurveyPoint> points,
                                                const ReadSurveyOptions& options = {});

/// The same, or where the file names nodes alone, their survey as planned: without places.
/// @throws InputError as read_survey(), and where a file of names asks for a frame to be fitted
[[nodiscard]] TAUT_IO_EXPORT Survey read_planned_survey(const CableNet& net,
                                                        const std::filesystem::path& file,
                                                        const ReadSurveyOptions& options = {});

/// Which point of a survey is on which node, as CSV: line,name,node,distance,status in the order of
/// the file; distance to the node's nominal place [m], status "used", or why the point was left
/// out, and then the nearest node.
/// @param survey of this net, which is not checked
[[nodiscard]] TAUT_IO_EXPORT std::string survey_names_csv(const CableNet& net,
                                                          const Survey& survey);

/// A form that holds every free node of the net, in its frame (3 x n) [m].
/// @throws InputError as read_survey(), and where a free node is missing
[[nodiscard]] TAUT_IO_EXPORT Points read_form(const CableNet& net,
                                              const std::filesystem::path& file);

}  // namespace taut
