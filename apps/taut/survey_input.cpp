// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>

#include "command.hpp"
#include "taut/files/file.hpp"
#include "taut/interchange/foreign_survey.hpp"
#include "taut/io/target_offsets_csv.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/registration.hpp"
#include "terminal.hpp"

namespace taut::app {

namespace {

/// Options that most files make needless, as they say it themselves.
void add_file_options(CLI::App& command, SurveyOptions& options, std::vector<CLI::Option*>& added) {
    const auto add = [&](const char* name, std::string& value, const char* what,
                         const char* group = heading::input) {
        added.push_back(command.add_option(name, value, what)->group(group));
        return added.back();
    };
    add("--format", options.format, "Format of the survey (default: by its content)")
        ->check(CLI::IsMember({"table", "xyz", "pts", "gsi", "landxml", "jobxml", "gama", "dxf"}));
    add("--unit", options.unit,
        "Unit of the coordinates (default: that of the file; else by the extent of the net)")
        ->check(CLI::IsMember({"m", "mm", "cm", "ft", "us-ft", "in"}));
    add("--columns", options.columns,
        "Columns of a table in their order, id,x,y,z,sx,sy,sz; - skips one (default: by its "
        "header)");
    add("--separator", options.separator, "Separator of a table's columns (default: detected)")
        ->check(CLI::IsMember({"comma", "semicolon", "tab", "blank"}));
    add("--decimal", options.decimal, "Decimal sign of a table (default: detected)")
        ->check(CLI::IsMember({"point", "comma"}));
    add("--encoding", options.encoding, "Encoding of the survey's text (default: detected)")
        ->check(CLI::IsMember({"utf-8", "utf-16", "latin-1"}));
    add("--match", options.match,
        "How points are matched to nodes: by name, by place, or auto: by name where a node has it, "
        "else by place")
        ->check(CLI::IsMember({"auto", "name", "place"}))
        ->capture_default_str();
    add("--offset", options.offset,
        "Offset of targets from the cable's axis along the net's normal (up; -3mm: down), and its "
        "standard deviation: \"3mm:0.2mm\"",
        heading::known);
    add("--offsets", options.offsets,
        "Table of offsets by a target's name or code: target,offset[,std]. --offset is then that "
        "of all other targets",
        heading::known);
    add("--angle", options.angle,
        "Standard deviation of each direction and zenith angle of a file of polar observations "
        "without any: \"0.3mgon\". Angles without a unit are then in gon (gon, mgon), degrees "
        "(deg, arcsec) or radians (rad, mrad)",
        heading::known);
    add("--range", options.range,
        "The same of each distance: \"1mm+1.5ppm\" (default of both: a common total station's)",
        heading::known);
    add("--names", options.names, "Table to write: which point is at which node (CSV)",
        heading::output);
}

SurveyFileOptions file_options_of(const SurveyOptions& options) {
    SurveyFileOptions given;
    if (!options.separator.empty()) {
        given.separator = parse_separator(options.separator);
    }
    if (!options.format.empty()) {
        given.format = parse_survey_format(options.format);
    }
    if (!options.columns.empty()) {
        given.columns = parse_survey_columns(options.columns);
    }
    if (!options.decimal.empty()) {
        given.decimal = parse_decimal_sign(options.decimal);
    }
    if (!options.encoding.empty()) {
        given.encoding = parse_text_encoding(options.encoding);
    }
    return given;
}

TargetOffsets target_offsets_of(const SurveyOptions& options) {
    TargetOffsets offsets;
    if (!options.offsets.empty()) {
        offsets.of = parse_target_offsets(read_file(options.offsets), options.offsets);
    }
    if (!options.offset.empty()) {
        offsets.all = parse_target_offset(options.offset);
    }
    return offsets;
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

AngleText parse_angle_std(const std::string& text) {
    const AngleText angle = parse_angle(text);
    if (!(angle.angle > 0.0)) {
        throw std::invalid_argument(
            fmt::format("--angle is '{}', expected a standard deviation above 0", text));
    }
    return angle;
}

std::vector<CLI::Option*> add_survey_options(CLI::App& command, SurveyOptions& options) {
    CLI::Option* const noise = command.add_option(
        "--noise", options.noise,
        "Standard deviation of each surveyed coordinate, such as 0.5mm, where the file has none "
        "(default: that of its last digit). identify also takes estimate: it then estimates the "
        "scale from the survey");
    CLI::Option* const frame =
        command
            .add_option("--frame", options.frame,
                        "Coordinate system of the survey: net (that of the net), supports (a rigid "
                        "motion is fitted to the supports that it names), auto (net where its "
                        "supports agree, else supports). Small errors of the coordinate system "
                        "are estimated together with the lengths, except with --frame net")
            ->check(CLI::IsMember({"auto", "net", "supports"}))
            ->capture_default_str()
            ->group(heading::input);
    CLI::Option* const control =
        command
            .add_option("--control", options.control,
                        "Control points id,x,y,z in the net's coordinate system. The survey is "
                        "fitted to them instead of to the supports")
            ->group(heading::input);
    std::vector<CLI::Option*> added{noise, frame, control};
    add_file_options(command, options, added);
    return added;
}

ReadSurveyOptions SurveyOptions::read_options() const {
    constexpr double first_guess = 0.001;  // [m]
    ReadSurveyOptions options{.noise_std = noise.empty() ? std::nullopt
                                           : noise == estimated_noise
                                               ? std::optional(first_guess)
                                               : std::optional(parse_noise(noise)),
                              .frame = frame == "net"        ? SurveyFrame::net
                                       : frame == "supports" ? SurveyFrame::supports
                                                             : SurveyFrame::automatic,
                              .control = control,
                              .file = file_options_of(*this),
                              .unit = unit.empty() ? std::nullopt : length_of_unit(unit),
                              .matching = match == "name"    ? PointMatching::name
                                          : match == "place" ? PointMatching::place
                                                             : PointMatching::automatic,
                              .offsets = target_offsets_of(*this)};
    if (!angle.empty()) {
        const AngleText given = parse_angle_std(angle);
        options.angle_std = given.angle;
        options.file.angle_unit = given.full_unit;
        options.file.takes_observations = true;
    }
    if (!range.empty()) {
        options.distance = parse_distance_precision(range);
        options.file.takes_observations = true;
    }
    return options;
}

void print_survey_notes(const SurveyOptions& options, const Survey& survey, bool with_notes) {
    warn(options.survey, survey.warnings);
    for (const std::string& note : with_notes ? survey.notes : std::vector<std::string>()) {
        print_message("note", fmt::format("{}: {}", options.survey, note));
    }
}

std::string survey_text(const CableNet& net, const SurveyOptions& options, const Survey& survey) {
    std::string text = fmt::format(
        "survey {}: {} free nodes, {} not surveyed, standard deviation {:.4g} mm\n", options.survey,
        survey.surveyed.size(), survey.missing.size(), 1e3 * survey.largest_noise_std());
    for (const std::string& note : survey.notes) {
        text += fmt::format("  {}\n", note);
    }
    if (!options.noise.empty() && options.noise != estimated_noise) {
        const double given = parse_noise(options.noise);
        const double rounded = std::hypot(given, survey.rounding_std);
        const auto other = std::ranges::count_if(survey.surveyed, [&](int node) {
            const auto noise = survey.noise_std.col(node).array();
            return (noise != given && noise != rounded).any();
        });
        if (survey.has_own_noise && other > 0) {
            text +=
                fmt::format("  --noise {} is not used for {} of these: the file has their own\n",
                            options.noise, other);
        }
    }
    if (survey.frame) {
        std::vector<ControlResidual> worst = survey.frame->residuals;
        text += fmt::format(
            "  moved into the net's coordinate system by {} control points, {:.3g} mm RMS\n",
            worst.size(), 1e3 * root_mean_square(worst));
        std::ranges::sort(worst, std::greater{},
                          [](const ControlResidual& r) { return r.residual.norm(); });
        constexpr size_t shown = 3;
        for (size_t i = 0; i < std::min(shown, worst.size()); ++i) {
            text += fmt::format("    {:<12}{:>10.3g} mm\n", worst[i].id,
                                1e3 * worst[i].residual.norm());
        }
    }
    if (!survey.unmatched.empty()) {
        text += fmt::format("  {} points are at no node and not used:\n", survey.unmatched.size());
        for (const UnmatchedPoint& p : survey.unmatched) {
            text += fmt::format(
                "    line {:<6}{} {}: {:.4g} mm from node {}{}\n", p.point.line,
                p.point.label.empty() ? "" : fmt::format(" '{}'", p.point.label),
                to_string(p.reason), 1e3 * p.distance, net.node_id(p.nearest),
                p.swapped_with < 0 ? ""
                                   : fmt::format(", swapped with {}", net.node_id(p.swapped_with)));
        }
    }
    return text;
}

}  // namespace taut::app
