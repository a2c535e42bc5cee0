// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "taut/net/cable_net.hpp"
#include "taut/survey/survey.hpp"

namespace taut {

/// The frame that a survey's coordinates are in.
enum class SurveyFrame {
    automatic,  ///< the net's if the supports that it names agree, else fitted to them
    net,        ///< the net's
    supports,   ///< fitted to the supports that it names by a rigid motion
};

/// How a survey file is to be read.
struct ReadSurveyOptions {
    /// Standard deviation of each coordinate where the file tells none [m].
    double noise_std = 0.0;
    SurveyFrame frame = SurveyFrame::automatic;
    /// Control points id,x,y,z in the net's frame, to fit the survey's frame to instead of the
    /// supports; empty: none.
    std::filesystem::path control;
};

/// A survey file brought to the nodes of a net: points read (CSV or PTS, read_survey_points()),
/// their frame fitted (register_rigidly()), and put on nodes by name or place (match_to_nodes()).
/// @throws std::invalid_argument for a noise that is negative or not finite
/// @throws InputError naming the file, its line and the rule: as read_survey_points(),
///   register_rigidly() and match_to_nodes(), and where no free node was surveyed or the noise
///   exceeds the mean edge length
[[nodiscard]] Survey read_survey(const CableNet& net, const std::filesystem::path& file,
                                 const ReadSurveyOptions& options = {});

/// The same, or where the file names nodes alone, their survey as planned: without places.
/// @throws InputError as read_survey(), and where a file of names asks for a frame to be fitted
[[nodiscard]] Survey read_planned_survey(const CableNet& net, const std::filesystem::path& file,
                                         const ReadSurveyOptions& options = {});

/// A form that holds every free node of the net, in its frame (3 x n) [m].
/// @throws InputError as read_survey(), and where a free node is missing
[[nodiscard]] Points read_form(const CableNet& net, const std::filesystem::path& file);

}  // namespace taut
