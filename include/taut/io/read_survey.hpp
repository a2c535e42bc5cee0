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

/// What determines the node of a surveyed point.
enum class PointMatching {
    automatic,  ///< its name where that is a node's, else its place; the places of all where they
                ///< contradict the names
    name,       ///< its name
    place,      ///< its place
};

/// How a survey file is to be read.
struct ReadSurveyOptions {
    /// Standard deviation of each coordinate where the file gives none; empty: that of the file's
    /// rounding, 0 where it is not rounded [m].
    std::optional<double> noise_std = {};
    bool is_noise_guess = false;  ///< whether a fit will estimate it: then it may go unused
    SurveyFrame frame = SurveyFrame::automatic;  ///< that its coordinates are in
    /// Control points id,x,y,z in the net's frame, to fit the survey's frame to instead of the
    /// supports; empty: none.
    std::filesystem::path control = {};
    SurveyFileOptions file = {};  ///< what is given of the file's format
    /// Of its coordinates, and of its standard deviations where the file gives no other; empty:
    /// that of the file, else guessed from the net's extent [m].
    std::optional<double> unit = {};
    PointMatching matching = PointMatching::automatic;  ///< what determines the node of a point
    /// Of observed angles, where the file gives none; empty: that of a common total station, with a
    /// warning [rad].
    std::optional<double> angle_std = {};
    /// Of observed distances, where the file gives none; empty: DistancePrecision{}, with a
    /// warning.
    std::optional<DistancePrecision> distance = {};
    TargetOffsets offsets = {};  ///< of targets from the axes of the cables
};

/// A survey file brought to the nodes of a net. Points are read (taut's own CSV,
/// parse_survey_points(), or any other format, read_foreign_survey()), or computed from angles and
/// distances (parse_polar_csv(), GSI; adjust_stations()). Those of one name are averaged, their
/// frame is fitted (register_rigidly()), they are put on nodes by name or place (match_to_nodes()),
/// and taken back to the axes of the cables (take_off_offsets()).
/// Survey::notes say how a foreign file was understood, and its rounding where that counts as
/// noise; Survey::warnings what was guessed.
/// @throws std::invalid_argument for a noise that is negative or not finite, and a unit that is not
///   positive
/// Where some points have standard deviations, a point without, or with one of 0, takes the noise
/// of the options, with a warning.
/// @throws InputError naming the file, its line and the rule: as the functions named, and where two
///   points of one name lie apart, a point has no standard deviations where others have and no
///   noise is given, no unit fits, no free node was surveyed or the noise exceeds the mean edge
///   length
[[nodiscard]] TAUT_IO_EXPORT Survey read_survey(const CableNet& net,
                                                const std::filesystem::path& file,
                                                const ReadSurveyOptions& options = {});

/// The same of points in memory; their unit is the metre unless given.
/// @param points a name that is no node's is a label, and points of one name are one target
/// @throws InputError as read_survey(), naming "points" and the line of the point
[[nodiscard]] TAUT_IO_EXPORT Survey read_survey(const CableNet& net,
                                                std::vector<SurveyPoint> points,
                                                const ReadSurveyOptions& options = {});

/// The same; for a file that only names nodes the planned survey of these, without places.
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
