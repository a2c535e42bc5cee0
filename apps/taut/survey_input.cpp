// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "taut/io/input_error.hpp"
#include "taut/io/survey_csv.hpp"
#include "taut/net/units.hpp"

namespace taut::app {
namespace {

/// Points of the survey that a control file names, and the others: those are no targets.
std::vector<ControlPoint> split_off_control_points(const CableNet& net, const std::string& file,
                                                   std::vector<SurveyPoint>& points) {
    std::map<std::string, Eigen::Vector3d> known;
    for (const SurveyPoint& point : read_survey_points(file)) {
        if (point.id.empty() || !known.emplace(point.id, point.position).second) {
            throw InputError(file, std::to_string(point.line),
                             "expected a control point with a name of its own");
        }
    }
    std::map<std::string, int> nodes;
    for (int node = 0; node < net.node_count(); ++node) {
        nodes.emplace(net.node_id(node), node);
    }
    std::vector<ControlPoint> control;
    std::erase_if(points, [&](const SurveyPoint& point) {
        const auto found = known.find(point.id);
        if (found == known.end()) {
            return false;
        }
        control.push_back({.id = point.id,
                           .known = found->second,
                           .measured = point.position,
                           .line = point.line});
        return !nodes.contains(point.id);
    });
    return control;
}

/// Whether the named supports stand where the net has them.
bool in_frame_of_net(const CableNet& net, const std::vector<ControlPoint>& supports) {
    double sum = 0.0;
    for (const auto& [s, t] : net.edges()) {
        sum += (net.nodes().col(s) - net.nodes().col(t)).norm();
    }
    const double limit = 0.1 * sum / net.edge_count();
    return std::ranges::all_of(supports, [&](const ControlPoint& point) {
        return (point.measured - point.known).norm() <= limit;
    });
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

void add_survey_options(CLI::App& command, SurveyOptions& options) {
    command
        .add_option("SURVEY", options.survey,
                    "Surveyed points in m: [id,]x,y,z[,sx,sy,sz], or PTS. Targets without a name "
                    "are matched by their place")
        ->required();
    command.add_option("--noise", options.noise,
                       "Standard deviation of each surveyed coordinate, \"0.5mm\", where the file "
                       "tells none (default: 0)");
    command
        .add_option("--frame", options.frame,
                    "Frame of the survey: net (the net's), supports (fit a rigid motion to the "
                    "supports it names), auto (the net's if its supports agree, else fit)")
        ->check(CLI::IsMember({"auto", "net", "supports"}))
        ->capture_default_str();
    command.add_option("--control", options.control,
                       "Control points id,x,y,z in the net's frame, to fit the survey's frame to "
                       "instead of the supports");
}

SurveyInput read_survey(const CableNet& net, const SurveyOptions& options) {
    const double noise_std = parse_noise(options.noise);
    std::vector<SurveyPoint> points = read_survey_points(options.survey);
    try {
        SurveyInput input;
        const bool by_control = !options.control.empty();
        const std::vector<ControlPoint> control =
            by_control ? split_off_control_points(net, options.control, points)
                       : support_control_points(net, points);
        constexpr size_t needed = 3;
        const bool fits_by_itself =
            options.frame == "auto" && control.size() >= needed && !in_frame_of_net(net, control);
        if (by_control || options.frame == "supports" || fits_by_itself) {
            input.registration = register_rigidly(control);
            points = moved(std::move(points), input.registration->motion);
        }
        input.survey = match_to_nodes(net, points, noise_std);
        if (input.registration) {
            for (size_t i = 0; i < control.size(); ++i) {
                input.survey.control.push_back(
                    {.id = control[i].id,
                     .residual = input.registration->residuals.col(static_cast<Eigen::Index>(i))});
            }
        }
        if (input.survey.surveyed.empty()) {
            throw SurveyError(0, "holds no free node of the net");
        }
        return input;
    } catch (const SurveyError& error) {
        throw InputError(options.survey, error.line() > 0 ? std::to_string(error.line()) : "",
                         error.what());
    }
}

std::string survey_text(const CableNet& net, const SurveyOptions& options,
                        const SurveyInput& input) {
    const Survey& survey = input.survey;
    std::string text = fmt::format("survey {}: {} free nodes, {} not surveyed, noise {:.4g} mm\n",
                                   options.survey, survey.surveyed.size(), survey.missing.size(),
                                   1e3 * survey.noise_std(Eigen::all, survey.surveyed).maxCoeff());
    if (const auto& registration = input.registration) {
        text += fmt::format("  moved into the net's frame by {} control points, {:.3g} mm RMS\n",
                            registration->points.size(), 1e3 * registration->rms());
        std::vector<int> order(registration->points.size());
        std::iota(order.begin(), order.end(), 0);
        const Eigen::VectorXd lengths = registration->residuals.colwise().norm();
        std::ranges::sort(order, std::greater{}, [&](int i) { return lengths(i); });
        constexpr size_t shown = 3;
        for (size_t i = 0; i < std::min(shown, order.size()); ++i) {
            text += fmt::format("    {:<12}{:>10.3g} mm\n",
                                registration->points[static_cast<size_t>(order[i])].id,
                                1e3 * lengths(order[i]));
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
