// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/read_survey.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/io/survey_csv.hpp"
#include "taut/io/target_list.hpp"
#include "taut/survey/control_check.hpp"
#include "taut/survey/measured_scale.hpp"
#include "taut/survey/noise_check.hpp"
#include "taut/survey/planned_survey.hpp"
#include "taut/survey/registration.hpp"

namespace taut {
namespace {

/// Does something with the points of a file; rules of surveys that are broken are told with its
/// name.
template <class Action>
auto with_points_of(const std::filesystem::path& file, const Action& action) {
    try {
        return action();
    } catch (const SurveyError& error) {
        throw InputError(file.string(), error.line() > 0 ? std::to_string(error.line()) : "",
                         error.what());
    }
}

void check(const ReadSurveyOptions& options) {
    if (!(options.noise_std >= 0.0 && std::isfinite(options.noise_std))) {
        throw std::invalid_argument(fmt::format(
            "noise_std is {}, expected a standard deviation of at least 0", options.noise_std));
    }
}

/// What no survey of the net can be.
void check_matched(const CableNet& net, const Survey& survey) {
    if (survey.surveyed.empty()) {
        throw SurveyError(0, "holds no free node of the net");
    }
    refuse_absurd_noise(net, survey.largest_noise_std());
}

bool is_frame_fitted(const CableNet& net, const std::vector<ControlPoint>& control,
                     const ReadSurveyOptions& options) {
    constexpr size_t needed = 3;
    return !options.control.empty() || options.frame == SurveyFrame::supports ||
           (options.frame == SurveyFrame::automatic && control.size() >= needed &&
            !in_frame_of_net(net, control));
}

/// Where control points lie in a survey that is in the net's frame as it stands.
std::vector<ControlResidual> residuals_of(const std::vector<ControlPoint>& control) {
    std::vector<ControlResidual> residuals;
    residuals.reserve(control.size());
    for (const ControlPoint& point : control) {
        residuals.push_back({.id = point.id, .residual = point.measured - point.known});
    }
    return residuals;
}

}  // namespace

Survey read_survey(const CableNet& net, const std::filesystem::path& file,
                   const ReadSurveyOptions& options) {
    check(options);
    std::vector<SurveyPoint> points = read_survey_points(file);
    const std::vector<ControlPoint> control = with_points_of(options.control, [&] {
        return options.control.empty()
                   ? support_control_points(net, points)
                   : split_off_control_points(net, read_survey_points(options.control), points);
    });
    return with_points_of(file, [&] {
        std::optional<Registration> frame;
        if (is_frame_fitted(net, control, options)) {
            frame = register_rigidly(control);
            points = moved(std::move(points), frame->motion);
        }
        Survey survey = match_to_nodes(net, points, options.noise_std);
        check_matched(net, survey);
        std::ranges::move(control_warnings(net, frame ? frame->residuals : residuals_of(control),
                                           survey.largest_noise_std()),
                          std::back_inserter(survey.warnings));
        survey.frame = std::move(frame);
        survey.frame_is_unknown =
            options.frame != SurveyFrame::net && options.control.empty() && survey.is_noisy();
        std::ranges::move(scale_warnings(control), std::back_inserter(survey.warnings));
        return survey;
    });
}

Survey read_planned_survey(const CableNet& net, const std::filesystem::path& file,
                           const ReadSurveyOptions& options) {
    check(options);
    const auto targets = file.extension() == ".pts"
                             ? std::nullopt
                             : parse_target_list(read_file(file), file.string());
    if (!targets) {
        return read_survey(net, file, options);
    }
    if (!options.control.empty() || options.frame == SurveyFrame::supports) {
        throw InputError(file.string(), "",
                         "names nodes alone, expected their places to fit a frame to");
    }
    return with_points_of(file, [&] {
        Survey survey = planned_survey(net, *targets, options.noise_std);
        check_matched(net, survey);
        return survey;
    });
}

Points read_form(const CableNet& net, const std::filesystem::path& file) {
    return with_points_of(file, [&] {
        Survey survey = match_to_nodes(net, read_survey_points(file));
        require_whole(net, survey, "all");
        return std::move(survey.form);
    });
}

}  // namespace taut
