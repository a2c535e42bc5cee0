// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "taut/io/read_survey.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "io/survey_file.hpp"
#include "io/target_list.hpp"
#include "net/rounded_length.hpp"
#include "survey/control_check.hpp"
#include "survey/mean_edge_length.hpp"
#include "survey/measured_scale.hpp"
#include "survey/misfit_hint.hpp"
#include "survey/node_names.hpp"
#include "survey/planned_survey.hpp"
#include "survey/point_names.hpp"
#include "survey/repeated_points.hpp"
#include "survey/rounding.hpp"
#include "taut/files/input_error.hpp"
#include "taut/files/table_file.hpp"
#include "taut/io/survey_csv.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/noise_check.hpp"
#include "taut/survey/registration.hpp"

namespace taut {
namespace {

/// Runs an action on the points of a file. A SurveyError becomes an InputError with the file's
/// name.
/// @param hint gives what is added to its message
template <class Action>
auto with_points_of(
    const std::filesystem::path& file, const Action& action,
    const std::function<std::string()>& hint = [] { return ""; }) {
    try {
        return action();
    } catch (const SurveyError& error) {
        std::string what = error.what();
        const std::string added = hint();
        // A question that the hint answers.
        if (const size_t question = what.find(": is the survey of this net");
            !added.empty() && question != std::string::npos) {
            what.erase(question);
        }
        throw InputError(file.string(), error.line() > 0 ? std::to_string(error.line()) : "",
                         what + added);
    }
}

void check(const ReadSurveyOptions& options) {
    if (options.noise_std && !(*options.noise_std >= 0.0 && std::isfinite(*options.noise_std))) {
        throw std::invalid_argument(fmt::format(
            "noise_std is {}, expected a standard deviation of at least 0", *options.noise_std));
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

/// Turns all names into labels where the options ask for it, or the places contradict the names.
void drop_wrong_names(const CableNet& net, const ReadSurveyOptions& options, SurveyFile& found) {
    if (options.matching == PointMatching::place) {
        make_names_labels(net, found.points, true);
    } else if (options.matching == PointMatching::automatic &&
               names_contradict_places(net, found.points)) {
        found.contradicted_names = make_names_labels(net, found.points, true);
        found.warnings.push_back(
            fmt::format("its {} points lie on other nodes than those of their names: all are "
                        "matched by place, unless matching by name is given",
                        found.contradicted_names));
    }
}

/// Whether all named points are on the nominal places of their free nodes to far less than the
/// rounding: then they are no survey, but the form of a net designed in round numbers.
bool is_nominal_form(const CableNet& net, const std::vector<SurveyPoint>& points, double step) {
    constexpr double far_below = 1e-3;
    const std::map<std::string, int> node_of = nodes_by_name(net);
    bool has_any = false;
    for (const SurveyPoint& point : points) {
        const auto found = node_of.find(point.id);
        if (found == node_of.end() || net.free_index(found->second) < 0) {
            continue;
        }
        has_any = true;
        const Eigen::Vector3d off = point.position - net.nodes().col(found->second);
        if (off.cwiseAbs().maxCoeff() > far_below * step) {
            return false;
        }
    }
    return has_any;
}

/// What rounding to the digits of a file adds to its noise.
struct RoundedNoise {
    double default_std = 0.0;   ///< of points without their own [m]
    double rounding_std = 0.0;  ///< 0 where it adds nothing [m]
};

bool has_whole_std(const SurveyPoint& point) {
    return point.noise_std && (point.noise_std->array() > 0.0).all();
}

/// "line 7", "lines 7, 9 and 3 more".
std::string lines_text(const std::vector<SurveyPoint*>& points) {
    constexpr size_t shown = 6;
    std::string text = points.size() == 1 ? "line" : "lines";
    for (size_t i = 0; i < std::min(shown, points.size()); ++i) {
        text += fmt::format("{} {}", i == 0 ? "" : ",", points[i]->line);
    }
    return points.size() <= shown ? text
                                  : fmt::format("{} and {} more", text, points.size() - shown);
}

/// Where some points have standard deviations, a point without, or with one of 0, was cut or
/// mistyped and would count as exact. It takes the noise of the options, which is not used where
/// all have their own. Where no point has any above 0, all count as without.
/// @throws SurveyError with the first line, where no noise was given
void complete_std(const ReadSurveyOptions& options, SurveyFile& found) {
    const double noise_std = options.noise_std.value_or(0.0);
    const bool has_any = std::ranges::any_of(found.points, [](const SurveyPoint& point) {
        return point.noise_std && point.noise_std->maxCoeff() > 0.0;
    });
    std::vector<SurveyPoint*> without;
    for (SurveyPoint& point : found.points) {
        const bool is_known = found.has_known_points && noise_std == 0.0 && point.noise_std &&
                              point.noise_std->isZero(0.0);
        if (!has_whole_std(point) && (has_any || point.noise_std) && !is_known) {
            without.push_back(&point);
        }
    }
    if (without.empty() && has_any && noise_std > 0.0 && !options.is_noise_guess) {
        const bool is_the_same = std::ranges::all_of(found.points, [&](const SurveyPoint& point) {
            return !point.noise_std || (point.noise_std->array() == noise_std).all();
        });
        if (!is_the_same) {
            found.warnings.push_back(
                fmt::format("gives standard deviations of its own: the noise of {} is not used",
                            format_length(noise_std)));
        }
    }
    if (without.empty() || (!has_any && noise_std == 0.0)) {
        return;
    }
    if (noise_std == 0.0) {
        const int first = without.front()->line;
        const std::string others =
            without.size() == 1 ? "" : fmt::format(" ({} in all)", lines_text(without));
        throw SurveyError(
            first, fmt::format("gives no standard deviations above 0{}, as {} of {} points do: "
                               "expected sx, sy, sz of every point, or a noise for those without",
                               others, found.points.size() - without.size(), found.points.size()));
    }
    for (SurveyPoint* const point : without) {
        if (point->noise_std) {
            point->noise_std = point->noise_std->unaryExpr(
                [&](double std_dev) { return std_dev == 0.0 ? noise_std : std_dev; });
        }
        if (!has_any) {
            point->noise_std.reset();
        }
    }
    const std::string noise = format_length(noise_std);
    if (has_any) {
        found.warnings.push_back(fmt::format(
            "{} of {} points give no standard deviations above 0: the noise of {} holds for "
            "{}",
            without.size(), found.points.size(), noise, lines_text(without)));
    } else {
        found.notes.push_back(fmt::format(
            "{} points give standard deviations of 0, which no survey has: the noise of "
            "{} holds for them",
            without.size(), noise));
    }
}

/// Adds the rounding of a file's coordinates to their noise, with a note.
RoundedNoise with_rounding(const CableNet& net, const ReadSurveyOptions& options,
                           SurveyFile& found) {
    // Coarser digits are those of a sketch, or of numbers that happen to be round.
    constexpr double coarsest_part = 0.02;  // of the mean edge length
    const double noise_std = options.noise_std.value_or(0.0);
    const double rounding = rounding_std(found.rounding);
    if (rounding == 0.0 || rounding > coarsest_part * mean_edge_length(net) ||
        is_nominal_form(net, found.points, found.rounding)) {
        return {.default_std = noise_std};
    }
    bool uses_default = false;
    double before = 0.0;
    double after = 0.0;
    const auto widened = [&](double std_dev) {
        const double with = noise_with_rounding(std_dev, rounding);
        if (with > std_dev && with > after) {
            before = std_dev;
            after = with;
        }
        return with;
    };
    for (SurveyPoint& point : found.points) {
        uses_default = uses_default || !point.noise_std;
        if (point.noise_std) {
            point.noise_std = point.noise_std->unaryExpr(widened);
        }
    }
    RoundedNoise result{.default_std = uses_default ? widened(noise_std) : noise_std};
    const std::string step = format_length(found.rounding);
    if (uses_default && !options.noise_std) {
        result = {.default_std = rounding, .rounding_std = rounding};
        found.notes.push_back(
            fmt::format("coordinates are rounded to {}: taken with +- {:.2g} mm, unless the "
                        "instrument's noise is given",
                        step, 1e3 * rounding));
    } else if (after > 0.0) {
        result.rounding_std = rounding;
        found.notes.push_back(
            fmt::format("coordinates are rounded to {}, which adds {:.2g} mm to their noise: {} "
                        "becomes {:.3g} mm",
                        step, 1e3 * rounding, rounded_length(before), 1e3 * after));
    }
    return result;
}

/// Residuals of control points in a survey that is given in the net's frame.
std::vector<ControlResidual> residuals_of(const std::vector<ControlPoint>& control) {
    std::vector<ControlResidual> residuals;
    residuals.reserve(control.size());
    for (const ControlPoint& point : control) {
        residuals.push_back({.id = point.id, .residual = point.measured - point.known});
    }
    return residuals;
}

/// What was read, brought to the nodes of the net.
/// @param file for messages
Survey put_on_nodes(const CableNet& net, SurveyFile&& found, const std::filesystem::path& file,
                    const ReadSurveyOptions& options) {
    with_points_of(file, [&] { complete_std(options, found); });
    const std::vector<SurveyPoint> as_read = found.points;
    const RoundedNoise noise = with_rounding(net, options, found);
    bool frame_is_fitted = true;
    const auto of_this = [&](const auto& action) {
        return with_points_of(file, action, [&]() -> std::string {
            if (found.is_of_observations) {
                return "; check the prism's constant and heights, and that all distances are in "
                       "one "
                       "unit";
            }
            const std::string hint = misfit_hint(net, as_read, found.unit, frame_is_fitted);
            constexpr double likely = 0.7;  // supports that lie close together match none
            if (hint.empty() && names_contradict_places(net, as_read, likely)) {
                return "; most points lie on other nodes than those of their names: match them by "
                       "place";
            }
            return hint.empty() ? found.unit_hint : hint;
        });
    };
    of_this([&] {
        if (found.is_own) {
            return;  // match_to_nodes() refuses a name that comes twice
        }
        AveragedPoints averaged = average_repeated(std::move(found.points), noise.default_std);
        found.points = std::move(averaged.points);
        if (!averaged.note.empty()) {
            found.notes.push_back(std::move(averaged.note));
        }
    });
    std::vector<SurveyPoint>& points = found.points;
    drop_wrong_names(net, options, found);
    const std::vector<ControlPoint> control = with_points_of(options.control, [&] {
        return options.control.empty()
                   ? support_control_points(net, points)
                   : split_off_control_points(
                         net, read_survey_file(net, options.control, {}).points, points);
    });
    frame_is_fitted = is_frame_fitted(net, control, options);
    return of_this([&] {
        std::optional<Registration> frame;
        if (frame_is_fitted) {
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
                                "matched by place",
                                count, points.size()));
            }
        }
        Survey survey = match_to_nodes(net, points, noise.default_std);
        take_off_offsets(net, options.offsets, survey);
        check_matched(net, survey);
        std::ranges::move(found.warnings, std::back_inserter(survey.warnings));
        std::ranges::move(control_warnings(net, frame ? frame->residuals : residuals_of(control),
                                           survey.largest_noise_std()),
                          std::back_inserter(survey.warnings));
        survey.contradicted_names = found.contradicted_names;
        survey.frame = std::move(frame);
        survey.frame_is_unknown = options.frame != SurveyFrame::net && survey.is_noisy();
        survey.notes.insert(survey.notes.begin(), found.notes.begin(), found.notes.end());
        survey.rounding_std = noise.rounding_std;
        survey.scale_std = found.scale_std;
        survey.has_own_noise = std::ranges::any_of(
            as_read, [](const SurveyPoint& point) { return point.noise_std.has_value(); });
        std::ranges::move(scale_warnings(control), std::back_inserter(survey.warnings));
        return survey;
    });
}

}  // namespace

Survey read_survey(const CableNet& net, const std::filesystem::path& file,
                   const ReadSurveyOptions& options) {
    check(options);
    return put_on_nodes(net, read_survey_file(net, file, options), file, options);
}

Survey read_survey(const CableNet& net, std::vector<SurveyPoint> points,
                   const ReadSurveyOptions& options) {
    check(options);
    if (points.empty()) {
        throw InputError("points", "", "holds none, expected one at least");
    }
    const double unit = options.unit.value_or(1.0);
    for (SurveyPoint& point : points) {
        point.position *= unit;
        if (point.noise_std) {
            *point.noise_std *= unit;
        }
    }
    return put_on_nodes(net, {.points = std::move(points), .unit = unit}, "points", options);
}

Survey read_planned_survey(const CableNet& net, const std::filesystem::path& file,
                           const ReadSurveyOptions& options) {
    check(options);
    const std::string text = read_table(file);
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
        Survey survey = planned_survey(net, *targets, options.noise_std.value_or(0.0));
        take_off_offsets(net, options.offsets, survey);
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
