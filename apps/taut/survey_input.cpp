// SPDX-FileCopyrightText: 2026 The taut authors
// SPDX-License-Identifier: MIT
#include "survey_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "command.hpp"
#include "taut/files/table_file.hpp"
#include "taut/interchange/foreign_survey.hpp"
#include "taut/io/target_offsets_csv.hpp"
#include "taut/net/units.hpp"
#include "taut/survey/registration.hpp"
#include "terminal.hpp"

namespace taut::app {

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
    ReadSurveyOptions& read = options.read;
    std::vector<CLI::Option*> added;
    const auto add = [&](CLI::Option* option, const char* group = heading::input) {
        added.push_back(option->group(group));
        return option;
    };
    added.push_back(command.add_option(
        "--noise", options.noise,
        "Standard deviation of each surveyed coordinate, such as 0.5mm, where the file has none "
        "(default: that of its last digit). identify also takes estimate: it then estimates the "
        "scale from the survey"));
    add(add_parsed(
            command, "--frame", read.frame,
            [](const std::string& name) {
                return name == "net"        ? SurveyFrame::net
                       : name == "supports" ? SurveyFrame::supports
                                            : SurveyFrame::automatic;
            },
            "Coordinate system of the survey: net (that of the net), supports (a rigid "
            "motion is fitted to the supports that it names), auto (net where its "
            "supports agree, else supports). Small errors of the coordinate system "
            "are estimated together with the lengths, except with --frame net",
            "auto"))
        ->check(CLI::IsMember({"auto", "net", "supports"}));
    add(command.add_option("--control", options.control,
                           "Control points id,x,y,z in the net's coordinate system. The survey is "
                           "fitted to them instead of to the supports"));
    add(add_parsed(command, "--format", read.file.format, parse_survey_format,
                   "Format of the survey (default: by its content)"))
        ->check(CLI::IsMember({"table", "xyz", "pts", "gsi", "landxml", "jobxml", "gama", "dxf"}));
    add(add_parsed(
            command, "--unit", read.unit, length_of_unit,
            "Unit of the coordinates (default: that of the file; else by the extent of the net)"))
        ->check(CLI::IsMember({"m", "mm", "cm", "ft", "us-ft", "in"}));
    add(add_parsed(command, "--columns", read.file.columns, parse_survey_columns,
                   "Columns of a table in their order, id,x,y,z,sx,sy,sz; - skips one (default: by "
                   "its header)"));
    add(add_parsed(command, "--separator", read.file.separator, parse_separator,
                   "Separator of a table's columns (default: detected)"))
        ->check(CLI::IsMember({"comma", "semicolon", "tab", "blank"}));
    add(add_parsed(command, "--decimal", read.file.decimal, parse_decimal_sign,
                   "Decimal sign of a table (default: detected)"))
        ->check(CLI::IsMember({"point", "comma"}));
    add(add_parsed(command, "--encoding", read.file.encoding, parse_text_encoding,
                   "Encoding of the survey's text (default: detected)"))
        ->check(CLI::IsMember({"utf-8", "utf-16", "latin-1"}));
    add(add_parsed(
            command, "--match", read.matching,
            [](const std::string& name) {
                return name == "name"    ? PointMatching::name
                       : name == "place" ? PointMatching::place
                                         : PointMatching::automatic;
            },
            "How points are matched to nodes: by name, by place, or auto: by name where a node has "
            "it, else by place",
            "auto"))
        ->check(CLI::IsMember({"auto", "name", "place"}));
    add(add_parsed(command, "--offset", read.offsets.all, parse_target_offset,
                   "Offset of targets from the cable's axis along the net's normal (up; -3mm: "
                   "down), and its standard deviation: \"3mm:0.2mm\""),
        heading::known);
    add(command.add_option("--offsets", options.offsets,
                           "Table of offsets by a target's name or code: target,offset[,std]. "
                           "--offset is then that of all other targets"),
        heading::known);
    add(command.add_option_function<std::string>(
            "--angle",
            [&read](const std::string& text) {
                const AngleText angle = parse_angle_std(text);
                read.angle_std = angle.angle;
                read.file.angle_unit = angle.full_unit;
                read.file.takes_observations = true;
            },
            "Standard deviation of each direction and zenith angle of a file of polar observations "
            "without any: \"0.3mgon\". Angles without a unit are then in gon (gon, mgon), degrees "
            "(deg, arcsec) or radians (rad, mrad)"),
        heading::known);
    add(command.add_option_function<std::string>(
            "--range",
            [&read](const std::string& text) {
                read.distance = parse_distance_precision(text);
                read.file.takes_observations = true;
            },
            "The same of each distance: \"1mm+1.5ppm\" (default of both: a common total "
            "station's)"),
        heading::known);
    add(command.add_option("--names", options.names,
                           "Table to write: which point is at which node (CSV)"),
        heading::output);
    return added;
}

ReadSurveyOptions SurveyOptions::read_options() const {
    constexpr double first_guess = 0.001;  // [m]
    ReadSurveyOptions options = read;
    options.control = control;
    if (!noise.empty()) {
        options.is_noise_guess = noise == estimated_noise;
        options.noise_std = options.is_noise_guess ? first_guess : parse_noise(noise);
    }
    if (!offsets.empty()) {
        options.offsets.of = parse_target_offsets(read_table(offsets), offsets);
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
