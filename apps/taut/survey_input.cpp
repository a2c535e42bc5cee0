// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey_input.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "taut/files/file.hpp"
#include "taut/files/input_error.hpp"
#include "taut/io/survey_csv.hpp"
#include "taut/io/target_list.hpp"
#include "taut/net/units.hpp"
#include "taut/statics/tensions.hpp"
#include "taut/survey/registration.hpp"

namespace taut::app {
namespace {

/// Does something with the points of a file; rules of surveys that are broken are told with its
/// name.
template <class Action>
auto with_points_of(const std::string& file, const Action& action) {
    try {
        return action();
    } catch (const SurveyError& error) {
        throw InputError(file, error.line() > 0 ? std::to_string(error.line()) : "", error.what());
    }
}

/// Noise that hides which node a target is on is most likely told in another unit.
void refuse_absurd_noise(const CableNet& net, const Survey& survey) {
    const double noise = survey.noise_std(Eigen::all, survey.surveyed).maxCoeff();
    const double length = edge_lengths(net, net.nodes()).mean();
    if (noise > length) {
        throw SurveyError(
            0,
            fmt::format("noise of {:.4g} mm, expected less than the mean edge length, {:.4g} mm: "
                        "is it told in another unit?",
                        1e3 * noise, 1e3 * length));
    }
}

void refuse_empty(const Survey& survey) {
    if (survey.surveyed.empty()) {
        throw SurveyError(0, "holds no free node of the net");
    }
}

}  // namespace

double parse_noise(const std::string& text) {
    const double noise_std = text.empty() ? 0.0 : parse_length(text);
    if (noise_std < 0.0) {
        throw std::invalid_argument(
            fmt::format("--noise is '{}', expected a standard deviation of at least 0", text));
    }
    return noise_std;
}

std::vector<CLI::Option*> add_survey_options(CLI::App& command, SurveyOptions& options) {
    CLI::Option* const noise =
        command.add_option("--noise", options.noise,
                           "Standard deviation of each surveyed coordinate, \"0.5mm\", where the "
                           "file tells none (default: 0)");
    CLI::Option* const frame =
        command
            .add_option("--frame", options.frame,
                        "Frame of the survey: net (the net's), supports (fit a rigid motion to the "
                        "supports it names), auto (the net's if its supports agree, else fit)")
            ->check(CLI::IsMember({"auto", "net", "supports"}))
            ->capture_default_str();
    CLI::Option* const control =
        command.add_option("--control", options.control,
                           "Control points id,x,y,z in the net's frame, to fit the survey's frame "
                           "to instead of the supports");
    return {noise, frame, control};
}

Survey read_survey(const CableNet& net, const SurveyOptions& options) {
    const double noise_std = parse_noise(options.noise);
    std::vector<SurveyPoint> points = read_survey_points(options.survey);
    const bool by_control = !options.control.empty();
    const std::vector<ControlPoint> control = with_points_of(options.control, [&] {
        return by_control
                   ? split_off_control_points(net, read_survey_points(options.control), points)
                   : support_control_points(net, points);
    });
    return with_points_of(options.survey, [&] {
        constexpr size_t needed = 3;
        const bool fits_by_itself =
            options.frame == "auto" && control.size() >= needed && !in_frame_of_net(net, control);
        std::vector<ControlResidual> residuals;
        if (by_control || options.frame == "supports" || fits_by_itself) {
            Registration registration = register_rigidly(control);
            points = moved(std::move(points), registration.motion);
            residuals = std::move(registration.residuals);
        }
        Survey survey = match_to_nodes(net, points, noise_std);
        refuse_empty(survey);
        refuse_absurd_noise(net, survey);
        survey.control = std::move(residuals);
        return survey;
    });
}

Survey read_planned_survey(const CableNet& net, const SurveyOptions& options) {
    const bool is_pts = std::filesystem::path(options.survey).extension() == ".pts";
    const auto targets =
        is_pts ? std::nullopt : parse_target_list(read_file(options.survey), options.survey);
    if (!targets) {
        return read_survey(net, options);
    }
    if (!options.control.empty() || options.frame == "supports") {
        throw InputError(options.survey, "",
                         "names nodes alone, expected their places to fit a frame to");
    }
    return with_points_of(options.survey, [&] {
        Survey survey = planned_survey(net, *targets, parse_noise(options.noise));
        refuse_empty(survey);
        refuse_absurd_noise(net, survey);
        return survey;
    });
}

bool is_noisy(const Survey& survey) {
    return survey.noise_std(Eigen::all, survey.surveyed).maxCoeff() > 0.0;
}

Points read_form(const CableNet& net, const std::string& file) {
    Survey survey =
        with_points_of(file, [&] { return match_to_nodes(net, read_survey_points(file)); });
    refuse_hidden_nodes(net, survey, file, "all");
    return std::move(survey.form);
}

void refuse_hidden_nodes(const CableNet& net, const Survey& survey, const std::string& file,
                         const std::string& expected) {
    if (!survey.missing.empty()) {
        throw InputError(
            file, "",
            fmt::format("holds {} of {} free nodes, expected {}: node '{}' is the first missing",
                        survey.surveyed.size(), net.free_node_count(), expected,
                        net.node_id(survey.missing.front())));
    }
}

std::string survey_text(const CableNet& net, const SurveyOptions& options, const Survey& survey) {
    std::string text = fmt::format("survey {}: {} free nodes, {} not surveyed, noise {:.4g} mm\n",
                                   options.survey, survey.surveyed.size(), survey.missing.size(),
                                   1e3 * survey.noise_std(Eigen::all, survey.surveyed).maxCoeff());
    if (!options.noise.empty()) {
        const double told = parse_noise(options.noise);
        const auto other = std::ranges::count_if(survey.surveyed, [&](int node) {
            return (survey.noise_std.col(node).array() != told).any();
        });
        if (other > 0) {
            text += fmt::format("  not --noise {}: the file tells the noise of {} of these\n",
                                options.noise, other);
        }
    }
    if (!survey.control.empty()) {
        text += fmt::format("  moved into the net's frame by {} control points, {:.3g} mm RMS\n",
                            survey.control.size(), 1e3 * root_mean_square(survey.control));
        std::vector<ControlResidual> worst = survey.control;
        std::ranges::sort(worst, std::greater{},
                          [](const ControlResidual& r) { return r.residual.norm(); });
        constexpr size_t shown = 3;
        for (size_t i = 0; i < std::min(shown, worst.size()); ++i) {
            text += fmt::format("    {:<12}{:>10.3g} mm\n", worst[i].id,
                                1e3 * worst[i].residual.norm());
        }
    }
    if (!survey.unmatched.empty()) {
        text += fmt::format("  {} points are on no node, and left out:\n", survey.unmatched.size());
        for (const UnmatchedPoint& p : survey.unmatched) {
            text += fmt::format("    line {:<6} {}: {:.4g} mm from node {}\n", p.point.line,
                                to_string(p.reason), 1e3 * p.distance, net.node_id(p.nearest));
        }
    }
    return text;
}

}  // namespace taut::app
