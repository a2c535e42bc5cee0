// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/read_survey.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "io/survey_file.hpp"
#include "survey/misfit_hint.hpp"
#include "survey/point_names.hpp"
#include "survey/repeated_points.hpp"
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
/// @param hint gives what is to be told with them
template <class Action>
auto with_points_of(
    const std::filesystem::path& file, const Action& action,
    const std::function<std::string()>& hint = [] { return ""; }) {
    try {
        return action();
    } catch (const SurveyError& error) {
        throw InputError(file.string(), error.line() > 0 ? std::to_string(error.line()) : "",
                         error.what() + hint());
    }
}

void check(const ReadSurveyOptions& options) {
    if (!(options.noise_std >= 0.0 && std::isfinite(options.noise_std))) {
        throw std::invalid_argument(fmt::format(
            "noise_std is {}, expected a standard deviation of at least 0", options.noise_std));
    }
    if (options.unit && !(*options.unit > 0.0 && std::isfinite(*options.unit))) {
        throw std::invalid_argument(
            fmt::format("unit is {}, expected a length above 0", *options.unit));
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

/// Turns all names into labels where the options tell to, or the places contradict the names.
void name_by_place_where_told(const CableNet& net, const ReadSurveyOptions& options,
                              SurveyFile& found) {
    if (options.matching == PointMatching::place) {
        make_names_labels(net, found.points, true);
    } else if (options.matching == PointMatching::automatic &&
               names_contradict_places(net, found.points)) {
        const int count = make_names_labels(net, found.points, true);
        found.warnings.push_back(fmt::format(
            "its {} points lie on other nodes than those of their names: all are "
            "matched by their place (--match name takes the names, --names writes which "
            "is where)",
            count));
    }
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
    SurveyFile found = read_survey_file(net, file, options);
    const std::vector<SurveyPoint> as_read = found.points;
    const auto of_this = [&](const auto& action) {
        return with_points_of(file, action, [&] {
            return found.unit_hint.empty() ? misfit_hint(net, as_read) : found.unit_hint;
        });
    };
    of_this([&] {
        if (found.is_own) {
            return;  // each name once, as match_to_nodes() asks
        }
        AveragedPoints averaged = average_repeated(std::move(found.points), options.noise_std);
        found.points = std::move(averaged.points);
        if (!averaged.note.empty()) {
            found.notes.push_back(std::move(averaged.note));
        }
    });
    std::vector<SurveyPoint>& points = found.points;
    name_by_place_where_told(net, options, found);
    const std::vector<ControlPoint> control = with_points_of(options.control, [&] {
        return options.control.empty()
                   ? support_control_points(net, points)
                   : split_off_control_points(
                         net, read_survey_file(net, options.control, {}).points, points);
    });
    return of_this([&] {
        std::optional<Registration> frame;
        if (is_frame_fitted(net, control, options)) {
            frame = register_rigidly(control);
            points = moved(std::move(points), frame->motion);
        }
        if (options.matching == PointMatching::automatic) {
            std::vector<SurveyPoint> labelled = points;
            const int count = make_names_labels(net, labelled, false);
            // A few unknown names in taut's own CSV are slips, which match_to_nodes() refuses.
            if (count > 0 && !(found.is_own && 2 * count < std::ssize(points))) {
                points = std::move(labelled);
                found.warnings.push_back(
                    fmt::format("{} of its {} names are no node's of the net: those points are "
                                "matched by their place (--names writes which is where)",
                                count, points.size()));
            }
        }
        Survey survey = match_to_nodes(net, points, options.noise_std);
        check_matched(net, survey);
        std::ranges::move(found.warnings, std::back_inserter(survey.warnings));
        std::ranges::move(control_warnings(net, frame ? frame->residuals : residuals_of(control),
                                           survey.largest_noise_std()),
                          std::back_inserter(survey.warnings));
        survey.frame = std::move(frame);
        survey.frame_is_unknown =
            options.frame != SurveyFrame::net && options.control.empty() && survey.is_noisy();
        survey.notes = std::move(found.notes);
        std::ranges::move(scale_warnings(control), std::back_inserter(survey.warnings));
        return survey;
    });
}

Survey read_planned_survey(const CableNet& net, const std::filesystem::path& file,
                           const ReadSurveyOptions& options) {
    check(options);
    const std::string text = read_file(file);
    const bool may_be_list = options.file == SurveyFileOptions{} &&
                             detect_survey_format(text, file.string()) == SurveyFormat::table &&
                             text.find('\0') == std::string::npos;
    const auto targets = may_be_list ? parse_target_list(text, file.string()) : std::nullopt;
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
